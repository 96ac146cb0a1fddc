"""First stage: where sentences and bare notes begin and end."""

import re

from c2s_engine.interpret.reading.scan import Span

ABBREVIATION = re.compile(
    r"(?:\b(?:e\.g|i\.e|approx|ca|vs|no|st|ave|rd|dr|mr|mrs|ms|mx|prof|sgt|min|max|fig|sec|incl|etc|resp|veh|est|op|opr)"
    r"|(?<!\d)(?<!\d )\b[a-z])\.$"
)
TITLE = re.compile(r"(?<!\d )\b(?:mr|mrs|ms|mx|prof|sgt)\.$")
"""Before a name: "Mr. Osei"."""
NUMBER = re.compile(r"(?:\d{1,2}|[a-h]|[ivx]{1,4})\.", re.IGNORECASE)
"""Of a step in a list."""


def sentences(text: str) -> list[tuple[int, int]]:
    """The sentences' spans: at full stops, question marks, semicolons, line ends of lists, and blank lines."""
    found: list[tuple[int, int]] = []
    start = 0
    for match in re.finditer(r"[.!?]+[\"')\]]*(?=\s|$)|;|\n\s*(?=\n|[-*•]|\d+[.)]\s)|\n+", text):
        before = text[start : match.end()].rstrip()
        if NUMBER.fullmatch(before.strip()):
            continue  # "2. It brakes": the number of a step is no sentence
        if match[0].startswith(".") and ABBREVIATION.search(before.lower()):
            rest = text[match.end() :].lstrip()
            if (
                TITLE.search(before.lower())
                or not re.match(r"[A-Z]", rest)
                or re.search(r"\b(?:e\.g|i\.e|approx|vs|no|veh|est|op|opr)\.$", before.lower())
            ):
                continue
        if match[0].startswith("\n") and "\n\n" not in text[match.start() : match.end() + 1]:
            rest = text[match.end() :].lstrip()
            wrapped = rest[:1].islower()
            if wrapped:
                continue
        if text[start : match.end()].strip():
            found.append(_trimmed(text, start, match.end()))
        start = match.end()
    if text[start:].strip():
        found.append(_trimmed(text, start, len(text)))
    return [(s, e) for s, e in found if s < e]


def shorthand(plain: str, sentences: list[tuple[int, int]], names: list[Span]) -> list[tuple[int, int]]:
    """The sentences; bare notes ("bus at stop, ego 40, car ahead brakes") are cut where a new one is spoken of."""
    found: list[tuple[int, int]] = []
    for start, end in sentences:
        piece = plain[start:end]
        at = start
        colon = re.search(r":\s+(?=\S)", piece)
        if (
            colon
            and not any(start <= n.start < start + colon.start() for n in names)
            and any(start + colon.end() <= n.start < end for n in names)
        ):
            found.append((start, start + colon.start()))
            at = start + colon.end()
        if not re.search(r"\b(?:the|an?|its?|his|her|their)\b", piece):
            for name in names:
                comma = re.search(r",\s*$", plain[at : name.start]) if at < name.start <= end else None
                if comma is None or name.kind == "label":
                    continue
                told = len(re.findall(r"\w+", plain[at : name.start])) >= 2
                says = re.match(r"\s*[\w+-]", plain[name.end : end]) and not re.match(
                    r"\s*(?:and|or)\b", plain[name.end : end]
                )
                if told and says:
                    found.append((at, at + comma.start()))
                    at = name.start
        found.append((at, end))
    return found


def _trimmed(text: str, start: int, end: int) -> tuple[int, int]:
    while start < end and (text[start].isspace() or text[start] in "-*•"):
        start += 1
    numbered = re.match(
        r"(?:\(?(?:\d{1,2}|[a-h]|[ivx]{1,4})[.)]|(?:step|phase|stage|event)\s\d{1,2}\s*[:.)-])\s+(?=\S)",
        text[start:end],
        re.IGNORECASE,
    )
    if numbered:
        start += numbered.end()
    while end > start and text[end - 1].isspace():
        end -= 1
    return start, end
