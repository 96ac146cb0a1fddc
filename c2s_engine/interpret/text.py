"""A text in plain letters, and its sentences. Every offset is one of the text itself."""

import re

SAME = str.maketrans(
    "\u2018\u2019\u201b\u2032\u201c\u201d\u00a0\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u202f\t",
    "''''\"\"" + " " + "------- " + " ",
)
_END = re.compile(r"(?<![ .][a-ln-rt-z])(?<!\bapprox)(?<!\bvs)[.!?]+[\"')\]]*(?=\s|$)|;|\n+", re.IGNORECASE)
"""Where a sentence ends: no full stop of "e.g.", "approx." or "vs.", but one after a unit."""


def normalised(text: str) -> str:
    """The text in lower case with plain quotes, dashes and blanks, of the same length."""
    plain = text.translate(SAME)
    return "".join(c.lower() if len(c.lower()) == 1 else c for c in plain)


def sentences(text: str) -> list[tuple[int, int]]:
    """The sentences' spans: they end at full stops, question marks, semicolons and line ends."""
    cuts = [0, *(m.end() for m in _END.finditer(text)), len(text)]
    pairs = ((a, b) for a, b in zip(cuts, cuts[1:], strict=False) if text[a:b].strip())
    return [(a + len(text[a:b]) - len(text[a:b].lstrip()), a + len(text[a:b].rstrip())) for a, b in pairs]
