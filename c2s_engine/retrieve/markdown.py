"""Markdown and plain text to blocks."""

import re

from c2s_engine.retrieve.blocks import NUMBERED, Block, BlockKind

_HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*#*$")
_FENCE = re.compile(r"^\s*(```|~~~)")
_ITEM = re.compile(r"^\s*(?:[-*+•]|\d+[.)]|\([a-z0-9]{1,3}\))\s+")
_UNDERLINE = re.compile(r"^(=+|-+)\s*$")


def read_markdown(text: str) -> list[Block]:
    """Headings, fenced code, tables, lists and paragraphs of a Markdown text (front matter is skipped)."""
    lines = text.splitlines()
    if lines and lines[0].strip() == "---":
        end = next((i for i, line in enumerate(lines[1:], 1) if line.strip() == "---"), 0)
        lines = lines[end + 1 :] if end else lines
    blocks: list[Block] = []
    gathered: list[str] = []
    kind: BlockKind = "paragraph"

    def flush() -> None:
        nonlocal gathered, kind
        if any(line.strip() for line in gathered):
            joint = " " if kind == "paragraph" else "\n"
            pieces = (
                gathered if kind == "code" else [line.strip() if kind == "paragraph" else line for line in gathered]
            )
            blocks.append(Block(kind, joint.join(pieces).strip("\n")))
        gathered, kind = [], "paragraph"

    fence = ""
    for i, line in enumerate(lines):
        if fence:
            if line.strip().startswith(fence):
                fence = ""
                flush()
            else:
                gathered.append(line)
            continue
        if match := _FENCE.match(line):
            flush()
            fence, kind = match[1], "code"
        elif match := _HEADING.match(line):
            flush()
            blocks.append(Block("heading", match[2], len(match[1])))
        elif _UNDERLINE.match(line) and kind == "paragraph" and len(gathered) == 1:
            heading = gathered.pop().strip()
            flush()
            blocks.append(Block("heading", heading, 1 if line.startswith("=") else 2))
        elif not line.strip():
            following = next((x for x in lines[i + 1 :] if x.strip()), "")
            if kind != "list" or not (_ITEM.match(following) or following.startswith("  ")):
                flush()
        elif line.lstrip().startswith("|"):
            if kind != "table":
                flush()
                kind = "table"
            gathered.append(line.strip())
        elif _ITEM.match(line):
            if kind != "list":
                flush()
                kind = "list"
            gathered.append(line.rstrip())
        elif kind == "list" and gathered:
            gathered[-1] += " " + line.strip()
        else:
            if kind == "table":
                flush()
            gathered.append(line)
    flush()
    return blocks


def read_text(text: str, page: int = 0) -> list[Block]:
    """Plain text: numbered clauses and short capitals are headings, list items and paragraphs are kept together."""
    blocks: list[Block] = []
    gathered: list[str] = []
    kind: BlockKind = "paragraph"

    def flush() -> None:
        nonlocal gathered, kind
        if gathered:
            blocks.append(Block(kind, (" " if kind == "paragraph" else "\n").join(gathered), page=page))
        gathered, kind = [], "paragraph"

    for raw in text.splitlines():
        line = re.sub(r"\s+", " ", raw).strip()
        if not line:
            flush()
        elif heading := _plain_heading(line):
            flush()
            blocks.append(Block("heading", heading[0], heading[1], page, heading[2]))
            if rest := heading[3]:
                gathered.append(rest)
        elif _ITEM.match(raw):
            if kind != "list":
                flush()
                kind = "list"
            gathered.append(line)
        elif kind == "list" and gathered:
            gathered[-1] += " " + line
        else:
            gathered.append(line)
    flush()
    return blocks


def _plain_heading(line: str) -> tuple[str, int, str, str] | None:
    """Heading, level, clause and what follows it on the line, where a line of plain text begins a section."""
    if match := NUMBERED.match(line):
        number = match["number"]
        rest = line[match.end() :]
        level = number.count(".") + 1
        if len(rest) <= 90 and not rest.endswith((".", ";", ",")):
            return line, level, number, ""
        return (number, level, number, rest) if level > 1 else None
    if re.match(r"^(Annex|Appendix|Chapter|Part|Section)\s+[0-9A-Z]+\b", line) and len(line) <= 100:
        return line, 1, line.split(":")[0].split(" - ")[0][:40], ""
    letters = [c for c in line if c.isalpha()]
    if len(letters) > 3 and len(line) <= 70 and line.isupper():
        return line, 1, "", ""
    return None
