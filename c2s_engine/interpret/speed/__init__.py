"""How fast: speeds, and whose each is."""
