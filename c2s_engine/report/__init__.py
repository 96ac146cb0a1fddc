"""The dossier of a scenario: what was said, what became of it, and what the run shows. A reviewer signs it."""
