"""The top-down picture of the dry run, stepped and played."""
