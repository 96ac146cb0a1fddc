"""Clauses of which the tree makes one noun phrase with what stands before "and": "crossed the centre line and its front
struck V2", "was stopped at the lights and the car behind ran into it"."""

from __future__ import annotations

OWN = frozenset(("its", "his", "her", "their", "my", "our"))
