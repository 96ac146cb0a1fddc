"""Scenic's highlighting by Pygments, memoised by top-level block so that a key in 2,000 lines costs little."""

import importlib.util
import re
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from c2s_tui.look.kinds import look

Highlight = tuple[int, int, str]  # first byte, byte after the last, name of the style
_TOP = re.compile(r"^(?=[^\s)\]}#])", re.MULTILINE)


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


def highlights(text: str) -> dict[int, list[Highlight]]:
    """By row (0-based), the highlights of a program."""
    found: dict[int, list[Highlight]] = {}
    row = 0
    for block in _blocks(text):
        for offset, spans in _block(block):
            found[row + offset] = list(spans)
        row += block.count("\n")
    return found


def _blocks(text: str) -> list[str]:
    """Pieces that begin at the left margin, outside triple quotes."""
    cuts = [m.start() for m in _TOP.finditer(text)]
    edges = sorted({0, *cuts, len(text)})
    blocks, open_block = [], ""
    for a, b in zip(edges, edges[1:], strict=False):
        open_block += text[a:b]
        if open_block.count('"""') % 2 == 0 and open_block.count("'''") % 2 == 0:
            blocks.append(open_block)
            open_block = ""
    return [*blocks, open_block] if open_block else blocks


@lru_cache(maxsize=4096)
def _block(text: str) -> tuple[tuple[int, tuple[Highlight, ...]], ...]:
    rows: dict[int, list[Highlight]] = {}
    row = column = 0
    for token, value in lexer().get_tokens(text):
        name = style_name(str(token))
        for i, piece in enumerate(value.split("\n")):
            if i:
                row, column = row + 1, 0
            width = len(piece.encode())
            if name and width:
                rows.setdefault(row, []).append((column, column + width, name))
            column += width
    return tuple((r, tuple(spans)) for r, spans in rows.items())


@lru_cache(maxsize=512)
def style_name(token: str) -> str | None:
    """The entry of look.toml's [syntax] for a token class: the longest prefix."""
    parts = token.removeprefix("Token.").split(".")
    for length in range(len(parts), 0, -1):
        name = ".".join(parts[:length])
        if name in look()["syntax"]:
            return name
    return None
