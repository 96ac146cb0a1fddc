"""The literals of code by hand that can be put in the place of one another: numbers, ranges, strings, words, params.

Scenic's tokens are Python's, so the standard tokenizer finds them; nothing is parsed or executed here.
"""

import io
import re
import tokenize
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from c2s_engine.check.pieces import Cut, Piece, cut
from c2s_engine.write.typed.scope import number

RANGES = frozenset({"Range", "VerifaiRange", "DiscreteRange", "VerifaiDiscreteRange"})
_NUMBER = r"(?:\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+)"
_DECIMAL = re.compile(_NUMBER)
_PAIR = re.compile(rf"\( (?P<low>(?:- )?{_NUMBER}) , (?P<high>(?:- )?{_NUMBER}) \)")


@dataclass(frozen=True)
class Site:
    """Characters `start`..`end` (exclusive) of a text: a number or range of these ends, or (without) other words."""

    start: int
    end: int
    text: str
    ends: tuple[float, float] | None = None
    call: str = ""  # Range or another draw

    def with_ends(self, low: float, high: float) -> str:
        """The text of another number or range, written as this one is."""
        if self._number(low) == self._number(high):
            return self._number(low)
        return f"{self.call or 'Range'}({self._number(low)}, {self._number(high)})"

    def _number(self, value: float) -> str:
        text = number(value)
        return f"{text}.0" if "." in self.text and "." not in text else text


@dataclass(frozen=True)
class Token:
    kind: int
    text: str
    start: int
    end: int


def tokens(code: str) -> list[Token]:
    """The tokens of a text with the places of their characters; none where it cannot be read."""
    begins = [0]
    for line in io.StringIO(code, newline="\n"):
        begins.append(begins[-1] + len(line))
    found = []
    try:
        for t in tokenize.generate_tokens(io.StringIO(code, newline="\n").readline):
            if t.type in (tokenize.NAME, tokenize.NUMBER, tokenize.STRING, tokenize.OP, tokenize.NEWLINE):
                start, end = (begins[row - 1] + column for row, column in (t.start, t.end))
                found.append(Token(t.type, t.string, start, end))
    except (tokenize.TokenError, SyntaxError, IndentationError):
        return []
    return found


def statements(code: str) -> list[tuple[int, Piece]]:
    """The top-level statements, each with the place of its first character; none where the code cannot be cut."""
    begins = [0]
    for line in io.StringIO(code, newline="\n"):
        begins.append(begins[-1] + len(line))
    try:
        return [(begins[piece.first - 1], piece) for piece in cut(code)]
    except Cut:
        return []


def numbers(code: str) -> list[Site]:
    """Ranges of two numbers, then single numbers, each in reading order."""
    found = tokens(code)
    ranges, singles = [], []
    for i, token in enumerate(found):
        if token.text in RANGES and (drawn := _drawn(found[i + 1 : i + 8])):
            start, end = token.start, found[i + len(drawn[1])].end
            ranges.append(Site(start, end, code[start:end], drawn[0], token.text))
        if token.kind == tokenize.NUMBER and _DECIMAL.fullmatch(token.text):
            value = float(token.text)
            singles.append(Site(token.start, token.end, token.text, (value, value)))
    return [*ranges, *singles]


def _drawn(found: Sequence[Token]) -> tuple[tuple[float, float], list[str]] | None:
    """The ends of `(low, high)`, where both are numbers, and its tokens."""
    texts = [t.text for t in found]
    taken = texts[: texts.index(")") + 1] if ")" in texts else []
    match = _PAIR.fullmatch(" ".join(taken))
    if match is None:
        return None
    low, high = (float(match[name].replace(" ", "")) for name in ("low", "high"))
    return (low, high), taken


def words(code: str, wanted: Sequence[str]) -> list[Site]:
    """Where these words follow one another, outside of strings and comments."""
    found = tokens(code)
    sites = []
    for i, token in enumerate(found):
        run = found[i : i + len(wanted)]
        if [t.text for t in run] == list(wanted):
            sites.append(Site(token.start, run[-1].end, code[token.start : run[-1].end]))
    return sites


def blueprints(code: str, whole: bool) -> list[Site]:
    """What `with blueprint` is given as a string or a name; the `whole` specifiers, with the comma before them."""
    found = [t for t in tokens(code) if t.kind != tokenize.NEWLINE]
    sites = []
    for i in range(len(found) - 3):
        comma, *words, value = found[i : i + 4]
        after = found[i + 4].text if i + 4 < len(found) else ","
        plain = value.kind in (tokenize.STRING, tokenize.NAME) and after not in ("(", "[", ".")
        if plain and comma.text == "," and [w.text for w in words] == ["with", "blueprint"]:
            start = comma.start if whole else value.start
            sites.append(Site(start, value.end, code[start : value.end]))
    return sites


def params(code: str, name: str) -> Iterator[Site]:
    """The values that top-level `param` statements give to a global parameter."""
    for start, piece in statements(code):
        found = tokens(piece.text)
        if not found or found[0].text != "param":
            continue
        for i in range(1, len(found) - 2):
            if found[i].text != name or found[i + 1].text != "=" or found[i - 1].text not in ("param", ","):
                continue
            depth, last = 0, i + 1
            for at in range(i + 2, len(found)):
                text = found[at].text
                if depth == 0 and (text == "," or found[at].kind == tokenize.NEWLINE):
                    break
                depth += (text in ("(", "[", "{")) - (text in (")", "]", "}"))
                last = at
            begin, end = found[i + 2].start, found[last].end
            yield Site(start + begin, start + end, piece.text[begin:end])
