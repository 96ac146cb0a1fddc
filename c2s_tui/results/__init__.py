"""The results pane: what the last run showed, and a series of runs."""
