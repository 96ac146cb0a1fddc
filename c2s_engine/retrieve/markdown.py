"""Markdown and plain text to blocks."""

import re

from c2s_engine.retrieve.blocks import NUMBERED, Block, BlockKind

_ITEM = re.compile(r"^\s*(?:[-*+•]|\d+[.)]|\([a-z0-9]{1,3}\))\s+")


def read_markdown(text: str) -> list[Block]:
    """Headings, code, tables, lists and paragraphs of a Markdown text (front matter is skipped)."""
    from markdown_it import MarkdownIt

    lines = text.splitlines()
    if lines and lines[0].strip() == "---":
        end = next((i for i, line in enumerate(lines[1:], 1) if line.strip() == "---"), 0)
        lines = lines[end + 1 :] if end else lines
    blocks: list[Block] = []
    tokens = MarkdownIt("commonmark").enable("table").parse("\n".join(lines))
    for i, token in enumerate(tokens):
        if token.level or token.map is None or token.nesting < 0:
            continue
        raw = [line.strip() for line in lines[slice(*token.map)] if line.strip()]
        if token.type == "heading_open":
            blocks.append(Block("heading", tokens[i + 1].content, int(token.tag[1])))
        elif token.type in ("fence", "code_block"):
            blocks.append(Block("code", token.content.strip("\n")))
        elif token.type == "table_open":
            blocks.append(Block("table", "\n".join(raw)))
        elif token.type in ("bullet_list_open", "ordered_list_open"):
            blocks.append(Block("list", _items(lines[slice(*token.map)])))
        elif token.type != "hr":
            blocks.append(Block("paragraph", " ".join(raw)))
    return [block for block in blocks if block.text]


def _items(lines: list[str]) -> str:
    """A line for each item of a list."""
    items: list[str] = []
    for line in lines:
        if _ITEM.match(line):
            items.append(line.rstrip())
        elif line.strip() and items:
            items[-1] += " " + line.strip()
    return "\n".join(items)


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
