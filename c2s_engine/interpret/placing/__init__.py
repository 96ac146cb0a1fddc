"""From relations to positions of the vocabulary: where vehicles, people and animals start."""
