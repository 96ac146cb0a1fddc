"""Where everybody is at the start: as told, and as it follows from what happens."""
