"""The events of FORMAT.md. Their definitions and thresholds stand in data/events.yaml (table.py, without Scenic)."""
