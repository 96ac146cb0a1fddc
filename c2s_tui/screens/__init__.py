"""Screens that open over the workbench: help, settings, sources, conflicts, sessions, questions."""
