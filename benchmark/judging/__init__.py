"""Judging: blind dossiers for people (or models) who know the rubric and nothing else, and what their verdicts say."""
