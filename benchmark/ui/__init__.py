"""Benchmarks of the app: first paint, key to draw under load, long programs, idle processor time."""
