"""Plain words for the domain's jargon, which the embedding model has hardly seen."""

import re
from functools import cache
from pathlib import Path

import yaml


@cache
def _table() -> list[tuple[re.Pattern, str]]:
    entries = yaml.safe_load((Path(__file__).parent / "wording.yaml").read_text())
    return [(re.compile(rf"(?<!\w)(?:{pattern})(?!\w)", re.I), words) for pattern, words in entries]


def plain(text: str) -> str:
    """A text as it is embedded."""
    for pattern, words in _table():
        text = pattern.sub(words, text)
    return text
