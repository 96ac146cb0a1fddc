"""Mends misspelt words of the trade before the text is read, and maps places in the mended text back to the user's."""

import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.clauses import _irregular

WORD = re.compile(r"[A-Za-z]{4,}")


class Mended:
    """A text with its misspellings mended; `back` maps an offset in it to the user's text."""

    def __init__(self, text: str) -> None:
        self.original = text
        self.starts: list[int] = [0]
        self.shifts: list[int] = [0]
        pieces: list[str] = []
        at = 0
        length = 0
        for start, end, new in _repairs(text):
            pieces += [text[at:start], new]
            length += start - at + len(new)
            at = end
            self.starts.append(length)
            self.shifts.append(at - length)
        pieces.append(text[at:])
        self.text = "".join(pieces)

    def back(self, offset: int) -> int:
        """The place in the user's text."""
        found = bisect_right(self.starts, offset) - 1
        return min(len(self.original), offset + self.shifts[found])


def _repairs(text: str) -> Iterator[tuple[int, int, str]]:
    found: list[tuple[int, int, str]] = []
    for pattern, new in language.table("spelling")["patterns"]:
        found += [(m.start(), m.end(), m.expand(new)) for m in re.finditer(pattern, text, re.IGNORECASE)]
    loud = text.isupper()
    for match in WORD.finditer(text):
        word = match[0]
        inner = match.start() > 0 and text[: match.start()].rstrip()[-1:] not in (".", "!", "?", ":", "")
        if word[0].isupper() and inner and not loud or word.isupper() and not loud or known(word.lower()):
            continue
        better = nearest(word.lower())
        if better is not None:
            found.append((match.start(), match.end(), better))
    found.sort()
    at = 0
    for start, end, new in found:
        if start >= at:
            yield start, end, new
            at = end


@cache
def vocabulary() -> frozenset[str]:
    """The single words of the language tables, with the forms of their verbs."""
    words: set[str] = set(language.table("spelling")["extra"])
    for noun in language.actor_nouns():
        words |= set(re.findall(r"[a-z]{4,}", noun))
    for rule in language.table("motions")["verbs"]:
        for verb in rule["verbs"]:
            words |= {
                verb,
                f"{verb}s",
                f"{verb}ed",
                f"{verb}ing",
                f"{verb.rstrip('e')}ing",
                f"{verb.rstrip('e')}ed",
                f"{verb}{verb[-1]}ing",
                f"{verb}{verb[-1]}ed",
            }
    words |= {w for form in _irregular() for w in re.findall(r"[a-z]+", form)}
    for name in ("environment", "places"):
        words |= set(re.findall(r"(?<![\\\w])[a-z]{5,}(?![\w?*+\[(|]*\\)", str(language.table(name))))
    return frozenset(w for w in words if len(w) >= 4 and w.isalpha())


def known(word: str) -> bool:
    """Whether a word is English or one of the tables'."""
    if word in vocabulary() or word.endswith("s") and word[:-1] in vocabulary() or f"{word}s" in vocabulary():
        return True
    from c2s_engine.interpret.syntax import parser

    strings = parser().vocab.strings
    return (
        word in strings
        or word.capitalize() in strings
        or word.endswith(("s", "d", "ing", "ly", "er"))
        and any(word[: -len(e)] in strings and len(word) - len(e) > 4 for e in ("s", "ed", "d", "ing", "ly", "er"))
    )


@cache
def nearest(word: str) -> str | None:
    """The one word of the vocabulary that differs by a slip or two; None where there is none or it is not clear."""
    allowed = 1 if len(word) < 10 else 2
    best: list[tuple[int, str]] = []
    for other in vocabulary():
        if abs(len(other) - len(word)) > allowed or other[0] != word[0] and other[1:2] != word[:1]:
            continue
        if len(word) < 8 and len(other) == len(word) and sorted(other) != sorted(word):
            continue
        distance = slips(word, other, allowed)
        if distance <= allowed:
            best.append((distance, other))
    best.sort()
    common = [
        other for distance, other in best if distance == best[0][0] and other in language.table("spelling")["extra"]
    ]
    if len(common) == 1:
        return common[0]
    if not best or len(best) > 1 and best[0][0] == best[1][0] and best[0][1].rstrip("sed") != best[1][1].rstrip("sed"):
        return None
    return best[0][1]


def slips(a: str, b: str, limit: int) -> int:
    """Edit distance with transpositions; `limit` + 1 where it is larger."""
    before: list[int] = []
    last = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        row = [i]
        for j, y in enumerate(b, 1):
            cost = min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, before[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
        before, last = last, row
    return last[-1]
