"""The chat pane: what was said, answered, found; and the line to type in."""
