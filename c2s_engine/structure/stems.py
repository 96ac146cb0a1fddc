"""Words compared without their endings."""

import re


def stem(word: str) -> str:
    """A word without the ending of a verb or a plural: brakes, braking, stopped and stop."""
    if len(word) > 3:
        word = re.sub(r"(?:ing|es|ed|(?<!s)s|e)$", "", word)
    return re.sub(r"([^aeious])\1$", r"\1", word)


def stems(text: str) -> frozenset[str]:
    """Those of all words of a text."""
    return frozenset(map(stem, re.findall(r"[a-z]+", text.lower().replace("_", " "))))
