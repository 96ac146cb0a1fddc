"""A document as a list of blocks (headings, paragraphs, lists, tables, code) and its cutting into chunks."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

BlockKind = Literal["heading", "paragraph", "list", "table", "code"]
TARGET = 900  # characters of a chunk: with its title path it stays within the model's 256 tokens
CLAUSE = re.compile(
    r"(?P<annex>(?:Annex|Appendix)\s+[0-9A-Z]{1,3}(?:,\s*(?:Appendix\s+\d+|(?:clause|paragraph)?\s*\d+(?:\.\d+)*))*)"
    r"|(?<![\w.])(?P<number>\d{1,2}(?:\.\d{1,3}){1,6})(?![\w])"
)
NUMBERED = re.compile(r"^(?:§\s*)?(?P<number>\d{1,2}(?:\.\d{1,3}){0,6})\.?\s+(?=[A-Z\"“(])")


@dataclass(frozen=True, slots=True)
class Block:
    """A piece of a document. `level`: of a heading, from 1. `page`: from 1, 0 where there are no pages."""

    kind: BlockKind
    text: str
    level: int = 0
    page: int = 0
    clause: str = ""


@dataclass(frozen=True, slots=True)
class Chunk:
    """What is indexed of a document: a text with the headings above it."""

    path: tuple[str, ...]
    text: str
    clause: str = ""
    page: int = 0


def clause_of(heading: str) -> str:
    """The clause that a heading names ("Annex 5, 4.4", "5.2.6.5"), or an empty string."""
    match = NUMBERED.match(heading) or CLAUSE.search(heading)
    if not match:
        return ""
    groups = match.groupdict()
    return re.sub(r"\s+", " ", groups.get("annex") or groups.get("number") or "").strip(" ,.")


def chunks(blocks: Iterable[Block], title: str, target: int = TARGET) -> list[Chunk]:
    """The chunks of a document: blocks under one heading together up to `target` characters, none across headings.

    A table or listing that is too long is cut between its lines, a table with its head repeated."""
    found: list[Chunk] = []
    path: list[tuple[int, str, str]] = []  # level, heading, clause
    gathered: list[str] = []
    page = 0

    def flush() -> None:
        nonlocal gathered
        text = "\n\n".join(gathered).strip()
        gathered = []
        if text:
            clause = next((c for _, _, c in reversed(path) if c), "")
            found.append(Chunk((title, *(h for _, h, _ in path)), text, clause, page))

    for block in blocks:
        if block.kind == "heading":
            flush()
            path = [p for p in path if p[0] < block.level]
            path.append((block.level, block.text, block.clause or clause_of(block.text)))
            page = block.page
            continue
        for piece in _pieces(block, target):
            if gathered and sum(map(len, gathered)) + len(piece) > target:
                flush()
            if not gathered:
                page = block.page
            gathered.append(piece)
    flush()
    return found


def _pieces(block: Block, target: int) -> list[str]:
    if len(block.text) <= target:
        return [block.text]
    if block.kind == "paragraph":
        parts, joint = re.split(r"(?<=[.;:!?])\s+", block.text), " "
    else:
        parts, joint = block.text.split("\n"), "\n"
    head = ""
    if block.kind == "table" and len(parts) > 2:
        head = "\n".join(parts[: 2 if re.fullmatch(r"[\s|:-]+", parts[1]) else 1])
        parts = parts[head.count("\n") + 1 :]
    room = max(target - len(head), 200)
    pieces: list[str] = []
    current = ""
    for part in (p for whole in parts for p in _hard(whole, room)):
        if current and len(current) + len(part) > room:
            pieces.append(current)
            current = ""
        current = f"{current}{joint}{part}" if current else part
    pieces.append(current)
    return [f"{head}\n{p}" if head else p for p in pieces if p.strip()]


def _hard(text: str, room: int) -> list[str]:
    """A text without a place to cut, cut between words (or anywhere, where there are none)."""
    pieces = []
    while len(text) > room:
        cut = text.rfind(" ", room // 2, room)
        cut = cut if cut > 0 else room
        pieces.append(text[:cut])
        text = text[cut:].lstrip(" ")
    return [*pieces, text]
