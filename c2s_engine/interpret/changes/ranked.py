"""Who is meant by a rank or a look among those who are there: "the faster one", "the last one", "the white one"."""

import re
from collections.abc import Callable
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.structure.components import Component, Structure

Naming = Callable[[Component, Structure], str]
"""What calls somebody so that nobody else is meant."""


def ranked(plain: str, structure: Structure, call: Naming) -> str:
    """The text in which those are called by `call` who are told by rank or look, where only one can be meant."""

    def said(match: re.Match[str]) -> str:
        return match[0]

    return _pattern().sub(said, plain)


@cache
def _pattern() -> re.Pattern[str]:
    table = language.table("notes")["ranks"]
    ranks = "|".join(row["said"] for row in table["by"])
    heads = "|".join(head for head, _ in table["heads"])
    return re.compile(rf"(?:\b(?:the|that) |^)(?P<how>{ranks}|[\w-]+(?= ones?\b)) (?P<head>{heads}|ones?)\b(?! of\b)")
