"""The benchmark: records, scoring by what programs do when they run, the runner and its tables."""
