"""Code by hand and code written for other fields, merged word by word upon what both came from (a three-way merge)."""

import re
from dataclasses import dataclass
from difflib import SequenceMatcher

from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.program import parted, without_comment
from c2s_engine.structure.regenerate import FragmentWriter

_NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")
_CONSTANT = re.compile(r"(\w+) *= *(\d+(?:\.\d+)?)")
TOKEN = re.compile(r"\d+(?:\.\d+)?|\w+|\n[^\S\n]*|[^\S\n]+|.")
"""The words, numbers, signs and gaps of code: joined they are the code."""


@dataclass(frozen=True)
class Upon:
    """What a writer writes, merged into code by hand: `base`, which the writer wrote when it was edited, and `own`."""

    writer: FragmentWriter
    base: str
    own: str

    def write(self, structure: Structure, cid: ComponentId) -> Component:
        """Raises ValueError where the two cannot be merged."""
        written = self.writer.write(structure, cid)
        code = merged(self.base, self.own, written.code)
        if code is None:
            raise ValueError(f"the code of {cid} was changed where other fields change it")
        return written.model_copy(update={"code": code})


def merged(base: str, own: str, other: str) -> str | None:
    """`own`, with the words and numbers that `other` has otherwise than `base`; None where `own` differs from `base`
    there, too; but for the comment that borders a component, which stays."""
    (_, base), (border, own), (_, other) = (parted(text) for text in (base, own, other))
    start, mine, theirs = (TOKEN.findall(text.strip()) for text in (base, own, other))
    where = {-1: -1, len(start): len(mine)}
    for found in SequenceMatcher(None, _values(start), _values(mine), autojunk=False).get_matching_blocks():
        where |= {found.a + k: found.b + k for k in range(found.size)}
    places: list[tuple[int, int, list[str]]] = []
    for tag, i1, i2, j1, j2 in SequenceMatcher(None, start, theirs, autojunk=False).get_opcodes():
        if tag == "equal":
            continue
        around = range(i1 - 1, i1 + 1) if tag == "insert" else range(i1, i2)
        at = [where[i] for i in around if i in where]
        if len(at) < len(around) or at[-1] - at[0] != len(at) - 1:
            return None
        first = at[-1] if tag == "insert" else at[0]
        places.append((first, first + i2 - i1, theirs[j1:j2]))
    for first, last, tokens in reversed(places):
        mine[first:last] = tokens
    head, tail = own[: len(own) - len(own.lstrip())], own[len(own.rstrip()) :]
    return border + head + "".join(mine) + tail


def without_numbers(base: str, own: str) -> str:
    """`own`, with the lines of `base` wherever it has but other numbers than these; its comments stay."""
    start, mine = base.split("\n"), own.split("\n")
    for tag, i1, i2, j1, j2 in SequenceMatcher(None, start, mine, autojunk=False).get_opcodes():
        if tag != "replace":
            continue
        for i in range(i1, i2):
            code, same = _commented(start[i])[0], _NUMBER.sub("0", _commented(start[i])[0])
            at = next((j for j in range(j1, j2) if same and _NUMBER.sub("0", _commented(mine[j])[0]) == same), None)
            if at is not None:
                mine[at] = start[i] if _NUMBER.sub("0", start[i]) == _NUMBER.sub("0", mine[at]) else \
                    code + _commented(mine[at])[1]  # fmt: skip
                j1 = at + 1
    return "\n".join(mine)


def constants(code: str) -> dict[str, str]:
    """The constants that code defines by a number alone, and these numbers as they stand there."""
    found = (_CONSTANT.fullmatch(_commented(line)[0]) for line in code.split("\n"))
    return {line[1]: line[2] for line in found if line}


def _commented(line: str) -> tuple[str, str]:
    """A line of code and the comment behind it, with the gap before that."""
    code = without_comment(line).rstrip()
    return code, line[len(code) :]


def alike(code: str, other: str) -> bool:
    """Whether two pieces of code are the same but for comments, empty lines and how numbers are written."""
    one, two = (_values(TOKEN.findall(_plain(text))) for text in (code, other))
    return one == two


def _plain(code: str) -> str:
    lines = (without_comment(line).rstrip() for line in code.split("\n"))
    return "\n".join(line for line in lines if line)


def _values(tokens: list[str]) -> list[str | float]:
    """Tokens, numbers as such: 5.0 is 5."""
    return [float(t) if _NUMBER.fullmatch(t) else t for t in tokens]
