"""Shorthand and tables become words, by data/language/notation.yaml, before anything is parsed."""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement

ROW = re.compile(r"^[ \t]*\|(?P<key>[^|\n]+)\|(?P<value>[^|\n]+)\|[ \t]*$", re.MULTILINE)
RULE = re.compile(r"^[ \t]*\|?[ \t:|-]*-{3,}[ \t:|-]*$", re.MULTILINE)
FIELD = re.compile(
    r"(?:^|(?<=[;\n])|(?<=[.:][ \t]))[ \t]*(?:[-*•][ \t]*)?(?P<key>[^\W\d_][\w /#-]{1,40}?)[ \t]*[:=][ \t]*"
    r"(?P<value>(?:[^;\n.:]|[.:](?=\d))+)"
)
NAMED = re.compile(
    r"(?:an? |the |one )?(?P<noun>[\w -]+?)(?= (?:at|with|on|in|from|behind|ahead|doing) |\s*[,(]|$)", re.IGNORECASE
)
VERBAL = re.compile(
    (
        r"\s*(?:slowly |suddenly |hard |then |gradually )?(?:to )?(?!(?:across|cross|bus|brakes?$"
        r"|gas)\b)\w+(?:s|es)\b|.*\b(?:is|has|does)\b"
    ),
    re.I,
)


@cache
def _patterns(section: str) -> list[tuple[re.Pattern[str], str]]:
    return [(re.compile(find, re.IGNORECASE), new) for find, new in language.table("notation")[section]]


def signs(text: str) -> list[Replacement]:
    """Signs and abbreviations with the words that they stand for."""
    return [(m.start(), m.end(), m.expand(new)) for find, new in _patterns("signs") for m in find.finditer(text)]


@cache
def _keys() -> dict[str, dict[str, Any]]:
    return {name: entry for entry in language.table("notation")["fields"] for name in entry["names"]}


TITLE = ""
"""Instead of the sentence of a field that only names the scenario."""


def fields(text: str) -> list[Replacement]:
    """Keys and values of a table or list, as sentences; none where fewer than two are found."""
    rows = list(ROW.finditer(text))
    found = rows if len(rows) >= 2 else list(FIELD.finditer(text))
    if len(found) < 2:
        return []
    replaced: list[Replacement] = [(m.start(), m.end(), "") for m in RULE.finditer(text)] if rows else []
    names: dict[str, str] = {}
    told = 0
    for match in found:
        sentence = _sentence(match["key"].strip(), match["value"].strip().rstrip("."), names)
        if sentence is not None:
            told += sentence != TITLE
        elif rows:
            sentence = f"{match['key'].strip()}: {match['value'].strip()}"
        if sentence == TITLE:
            replaced.append((match.start(), match.end(), ""))
        elif sentence is not None:
            start = match.start() + len(match[0]) - len(match[0].lstrip(" \t-*•"))
            replaced.append((start, match.end(), f"{sentence[:1].upper()}{sentence[1:]}."))
    return (
        [
            *replaced,
        ]
        if told
        else [r for r in replaced if r[2] == TITLE]
    )


def _sentence(key: str, value: str, names: dict[str, str]) -> str | None:
    """What a field says; None where its key is no known one. `names` gathers what the other road users are."""
    data = language.table("notation")
    plain = " ".join(re.sub(r"[_#]", " ", key.lower()).split())
    whole = plain
    if re.sub(r"\s*\d+$", "", plain) in data["others"]:
        parts = NAMED.match(value)
        first, rest = (parts["noun"], value[parts.end("noun") :].lstrip(", ")) if parts else (value, "")
        names[plain] = _noun(first)
        return f"{names[plain]}: {_named(rest, names)}" if rest else f"there is a {names[plain]}"
    value = _named(value, names)
    who, attribute = _split(plain, data)
    entry = _keys().get(attribute)
    if entry is None:
        return None
    if entry.get("title"):
        return TITLE
    if entry.get("name") and who is not None and who not in data["egos"]:
        names[who] = _noun(value)
        return f"there is a {names[who]}"
    other = next(reversed(names.values()), "car")
    if who is None and entry.get("who"):
        return None
    subject = "ego" if who is None or who in data["egos"] else names.get(who, who)
    said = re.sub(r"\s+lane$", "", value) if whole.endswith("lane") else value
    if entry["say"].startswith("{who} {value}"):
        lead = value.lower()
        if re.match(r"(the |a |an )?[\w-]+( vehicle| car)? \w+s\b", lead) and not VERBAL.match(value):
            return value
        if not VERBAL.match(value) and len(value.split()) > 3:
            return value
        if not VERBAL.match(value):
            return f"{subject}: {value}"
    return str(entry["say"]).format(who=subject, value=said, other=other)


def _named(text: str, names: dict[str, str]) -> str:
    """The text with "actor 1" and the like replaced by what they are."""
    for name, noun in names.items():
        if name[-1:].isdigit():
            text = re.sub(rf"\b{re.escape(name)}\b", f"the {noun}", text, flags=re.IGNORECASE)
    return text


def _split(key: str, data: dict[str, Any]) -> tuple[str | None, str]:
    """(whom the key is about, what of it): "ego speed", "speed of the lead", "speed"."""
    match = re.fullmatch(r"(?P<what>[\w ]+?) of (?:the )?(?P<who>[\w ]+)", key)
    if match:
        return match["who"], match["what"]
    for name in sorted(_keys(), key=len, reverse=True):
        if key == name:
            return None, name
        if key.endswith(f" {name}"):
            return key[: -len(name) - 1].removesuffix("'s").strip(), name
    return None, key


def _noun(value: str) -> str:
    return re.sub(r"^(?:an?|the|one)\s+", "", value.strip(), flags=re.IGNORECASE)
