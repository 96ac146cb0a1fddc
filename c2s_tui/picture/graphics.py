"""How the terminal can show the picture: real pixels (kitty's protocol, sixel), half blocks, or plain characters."""

import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from textual_image.widget import SixelImage, TGPImage

KITTY, SIXEL, BLOCKS, TEXT = "kitty", "sixel", "blocks", "text"
WAYS = ("auto", KITTY, SIXEL, BLOCKS, TEXT)
SIXEL_TERMS = ("foot", "mlterm", "yaft", "contour")
SIXEL_PROGRAMS = ("wezterm", "iterm.app", "mintty", "rio")
CELL = (10, 20)
"""Pixels of a cell where the terminal does not say."""


def chosen(wanted: str, theme: str, plain: bool, colours: str | None, environ: Mapping[str, str] = os.environ) -> str:
    """The way to draw. The terminal is judged by its environment: asking it would swallow keys typed meanwhile.

    `wanted`: a choice of WAYS; `theme`: of the app; `plain`: ASCII only; `colours`: Rich's name of the colour system.
    """
    if wanted in WAYS[1:]:
        return wanted
    if plain or theme in ("c2s-mono", "c2s-ansi") or colours not in ("256", "truecolor"):
        return TEXT
    term, program = environ.get("TERM", "").lower(), environ.get("TERM_PROGRAM", "").lower()
    if environ.get("TMUX") or term.startswith(("tmux", "screen")):
        return BLOCKS  # a multiplexer passes pixels on only where it is set up for it
    if environ.get("KITTY_WINDOW_ID") or term in ("xterm-kitty", "xterm-ghostty") or program == "ghostty":
        return KITTY
    return SIXEL if term.startswith(SIXEL_TERMS) or program in SIXEL_PROGRAMS else BLOCKS


def pixel_widget(way: str) -> "type[TGPImage | SixelImage]":
    """The widget of textual-image that shows an image by that protocol."""
    with _silent():
        from textual_image import widget
    return widget.TGPImage if way == KITTY else widget.SixelImage


def cell_size() -> tuple[int, int]:
    """Width and height of a cell in pixels, as the terminal's driver reports them."""
    with _silent():
        from textual_image import _terminal
    found = CELL
    try:
        import fcntl
        import struct
        import termios

        packed = fcntl.ioctl(sys.__stdout__.fileno(), termios.TIOCGWINSZ, b"\0" * 8)  # type: ignore[union-attr]
        rows, columns, width, height = struct.unpack("HHHH", packed)
        if rows and columns and width and height:
            found = width // columns, height // rows
    except (ImportError, OSError, ValueError, AttributeError):
        pass
    _terminal.get_cell_size._result = _terminal.CellSize(*found)  # type: ignore[attr-defined]
    return found


@contextmanager
def _silent() -> Iterator[None]:
    """textual-image asks the terminal while it is imported, which is too late once the app reads its keys: without a
    terminal it does not ask."""
    kept = sys.__stdout__
    with open(os.devnull, "w") as nothing:
        sys.__stdout__ = nothing  # type: ignore[misc]
        try:
            yield
        finally:
            sys.__stdout__ = kept  # type: ignore[misc]
