"""Headlines of reports: "Lorry hits cyclist in Camden", before the story tells it again from the start."""

from __future__ import annotations
