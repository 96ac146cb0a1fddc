"""Sixth stage: the scene becomes the components of S, in the words of the vocabulary."""
