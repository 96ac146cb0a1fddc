"""The code pane: the live program, its fragments and its diagnostics."""
