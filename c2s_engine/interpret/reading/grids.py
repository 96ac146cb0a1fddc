"""Tables with a row for each road user ("obj; type; lane; v; x // ego; car; centre; 90; 0"), as sentences."""

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement

SPLIT = re.compile(r"[ \t]+//[ \t]+|\n")


def grids(text: str) -> list[Replacement]:
    """The rows of a table, under a head whose cells are known, with what they say."""
    found: list[Replacement] = []
    head: list[str | None] = []
    for start, end in _rows(text):
        row = text[start:end]
        cells = _cells(row)
        if not head:
            keys = [_key(c) for c in cells]
            if len(cells) >= 3 and "who" in keys and sum(k is not None for k in keys) >= 3:
                head = keys
                found.append((start, end, _lanes(row)))
        elif len(cells) == len(head):
            found.append((start, end, _sentence(dict(zip(head, cells, strict=True)))))
        else:
            break
    if re.search(r"[ \t]//[ \t]", text):  # becomes a full stop by itself
        found = [(start, end, said.rstrip(".")) for start, end, said in found]
    return found if len(found) > 1 else []


def _rows(text: str) -> Iterator[tuple[int, int]]:
    at = 0
    for match in SPLIT.finditer(text):
        yield at, match.start()
        at = match.end()
    yield at, len(text)


def _cells(row: str) -> list[str]:
    """The cells of a row: between bars, semicolons or tabs, else between commas."""
    row = row.strip().strip("|")
    mark = next((m for m in ("|", ";", "\t") if m in row), ",")
    return [c.strip() for c in row.split(mark)]


@cache
def _heads() -> list[tuple[str, re.Pattern[str]]]:
    table: dict[str, Any] = language.table("telegraphic")["columns"]
    return [
        (key, re.compile(rf"(?:{'|'.join(names)})\b[\w .]*(?:[\[(].*)?", re.IGNORECASE)) for key, names in table.items()
    ]


def _key(cell: str) -> str | None:
    return next((key for key, pattern in _heads() if pattern.fullmatch(cell)), None)


def _lanes(row: str) -> str:
    told = re.search(r"lanes?\s*[(\[]\s*(?:of|out of|1\s*-|1\.\.)\s*(\d)", row, re.IGNORECASE)
    return f"The road has {told[1]} lanes in the same direction." if told else ""


def _sentence(cells: dict[str | None, str]) -> str:
    """What a row says: "box truck A drives in the right lane at 80 km/h 20 m ahead of ego." """
    name, kind = cells.get("who", ""), cells.get("type", "")
    ego = name.lower() in language.table("notation")["egos"]
    who = name if ego or not kind else f"{kind} {name}"
    said = ["drives"]
    if lane := cells.get("lane", ""):
        told = re.sub(r"\s*lane$", "", re.sub(r"^cent(?:er|re)$|^mid$", "middle", lane.lower()))
        said.append(f"in lane {told}" if told.isdigit() else f"in the {told} lane")
    if speed := re.match(r"\d+(?:\.\d+)?", cells.get("speed", "")):
        unit = re.search(r"km/?h|kph|mph|m/s", cells["speed"])
        said.append(f"at {speed[0]} {unit[0] if unit else 'km/h'}")
    gap = re.match(r"([+\-−]?)\s*(\d+(?:\.\d+)?)", cells.get("gap", "")) if not ego else None
    if gap:
        where = "behind" if gap[1] in ("-", "−") else "ahead of"
        said.append(f"{gap[2]} m {where} ego" if float(gap[2]) else "alongside ego")
    sentence = f"{who[:1].upper()}{who[1:]} {' '.join(said)}."
    act = cells.get("act", "").strip(" -")
    return f"{sentence} {who if ego or who == name else 'It'} {act}." if act else sentence
