"""Map files: where they are, what is on them, what Scenic's parser leaves out, and places as Scenic code."""
