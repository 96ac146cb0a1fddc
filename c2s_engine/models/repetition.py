"""Notices that a model says the same over and over, while it streams."""

WINDOW = 1200
TIMES = 8
LONGEST = 120


def repeats(text: str) -> bool:
    """Whether the text ends in at least eight copies of one piece of 1 to 120 characters (and 160 characters of them).

    Runs of blanks count too: a model that is held to a schema may print blanks for ever.
    """
    tail = text[-WINDOW:]
    for size in range(1, LONGEST + 1):
        times = max(TIMES, -(-160 // size))
        if size * times > len(tail):
            continue
        piece = tail[-size:]
        if tail.endswith(piece * times):
            return True
    return False
