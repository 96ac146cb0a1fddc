"""Scenic's highlighting by Pygments, memoised by top-level block so that a key in 2,000 lines costs little."""

import importlib.util
from bisect import bisect_right
from collections.abc import Iterable
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from c2s_tui.look.kinds import look

Highlight = tuple[int, int, str]  # first byte, byte after the last, name of the style
INNER = ")]}#"
"""What a line at the left margin begins with that goes on with the piece before it."""


@cache
def lexer() -> Any:
    """Scenic's own lexer, loaded from its file so that Scenic itself is not imported; Python's where it is absent."""
    found = importlib.util.find_spec("scenic")
    for folder in (found.submodule_search_locations or []) if found else []:
        file = Path(folder) / "syntax" / "pygment.py"
        if file.is_file():
            spec = importlib.util.spec_from_file_location("c2s_scenic_lexer", file)
            assert spec and spec.loader
            module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(module)
            return module.ScenicLexer(stripnl=False, ensurenl=False)
    from pygments.lexers.python import PythonLexer

    return PythonLexer(stripnl=False, ensurenl=False)


class Blocks:
    """The pieces of a program that begin at the left margin, outside triple quotes; each is lexed when a row of it is
    first asked for, so that a key costs what is on the screen.
    """

    def __init__(self, lines: Iterable[str] = ("",)):
        self.lines = list(lines)
        self._firsts = [0]
        double = single = 0
        for i, line in enumerate(self.lines):
            if i and line and not (double | single) & 1 and line[0] not in INNER and not line[0].isspace():
                self._firsts.append(i)
            double += line.count('"""')
            single += line.count("'''")

    def around(self, row: int) -> tuple[int, int]:
        """The first row of the block that holds a row (0-based), and the row after its last."""
        i = bisect_right(self._firsts, row) - 1
        return self._firsts[i], self._firsts[i + 1] if i + 1 < len(self._firsts) else len(self.lines)

    def __getitem__(self, row: int) -> list[Highlight]:
        """The highlights of a row."""
        first, after = self.around(row)
        return list(_block("\n".join(self.lines[first:after])).get(row - first, ()))

    def __len__(self) -> int:
        return len(self.lines)


def stale(before: Blocks, now: Blocks) -> tuple[int, int]:
    """The rows (first, after the last) whose text or highlights may differ between two states of a program."""
    old, new = before.lines, now.lines
    head = next((i for i, (a, b) in enumerate(zip(old, new, strict=False)) if a != b), min(len(old), len(new)))
    if head == len(old) == len(new):
        return 0, 0
    longest = min(len(old), len(new)) - head
    tail = next((i for i in range(longest) if old[-1 - i] != new[-1 - i]), longest)
    was, become = old[head : len(old) - tail], new[head : len(new) - tail]
    first = min(before.around(max(0, min(head, len(old) - 1)))[0], now.around(max(0, min(head, len(new) - 1)))[0])
    if head:  # a line that begins a block no more joins the block before it
        first = min(first, before.around(head - 1)[0], now.around(head - 1)[0])
    if len(old) != len(new) or _parity(was) != _parity(become):
        return first, max(len(old), len(new))
    last = max(head, len(new) - tail - 1)
    after = min(last + 1, len(new) - 1)  # what follows may belong to the block before it now
    return first, max(before.around(last)[1], now.around(last)[1], before.around(after)[1], now.around(after)[1])


def _parity(lines: list[str]) -> tuple[int, int]:
    text = "\n".join(lines)
    return text.count('"""') % 2, text.count("'''") % 2


@lru_cache(maxsize=4096)
def _block(text: str) -> dict[int, tuple[Highlight, ...]]:
    rows: dict[int, list[Highlight]] = {}
    row = column = 0
    for token, value in lexer().get_tokens(text + "\n"):
        name = style_name(str(token))
        for i, piece in enumerate(value.split("\n")):
            if i:
                row, column = row + 1, 0
            width = len(piece.encode())
            if name and width:
                rows.setdefault(row, []).append((column, column + width, name))
            column += width
    return {r: tuple(spans) for r, spans in rows.items()}


@lru_cache(maxsize=512)
def style_name(token: str) -> str | None:
    """The entry of look.toml's [syntax] for a token class: the longest prefix."""
    parts = token.removeprefix("Token.").split(".")
    for length in range(len(parts), 0, -1):
        name = ".".join(parts[:length])
        if name in look()["syntax"]:
            return name
    return None
