"""A text with stretches replaced, which knows where each place of it is in the user's own text."""

from bisect import bisect_right
from collections.abc import Iterable

Replacement = tuple[int, int, str]
"""Start, end (in the text before), and what stands there instead."""


class Rewritten:
    """The text after one pass of replacements; those that overlap an earlier one are left out, the first of those given
    wins at one place."""

    def __init__(self, text: str, replacements: Iterable[Replacement]) -> None:
        self.original = text
        self.starts: list[int] = [0]
        self.shifts: list[int] = [0]
        pieces: list[str] = []
        at = length = 0
        for start, end, new in sorted(replacements, key=lambda found: found[0]):
            if start < at:
                continue
            pieces += [text[at:start], new]
            length += start - at + len(new)
            at = end
            self.starts.append(length)
            self.shifts.append(at - length)
        pieces.append(text[at:])
        self.text = "".join(pieces)

    def back(self, offset: int) -> int:
        """The place in the text before."""
        found = bisect_right(self.starts, offset) - 1
        return max(0, min(len(self.original), offset + self.shifts[found]))
