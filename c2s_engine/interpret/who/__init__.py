"""Who is meant: mentions become entities, over sentences."""
