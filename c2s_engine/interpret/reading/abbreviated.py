"""Abbreviations that a text makes itself ("the adult pedestrian target (EPTa)"): where it goes on with one, the noun is
read that it stands for."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement
from c2s_engine.interpret.reading.scan import names

BRACKET = re.compile(r" ?\((?:the )?[\"']?[A-Z][A-Za-z]{0,3}[A-Z][a-z]?[\"']?\)")


@cache
def _explained() -> re.Pattern[str]:
    nouns = language.alternatives([n for n, (kind, _, _) in language.actor_nouns().items() if kind != "vehicle"])
    return re.compile(
        rf"(?<![\w-])(?P<noun>(?i:{nouns})(?:[ -](?:target|dummy|surrogate))?)"
        r"(?P<bracket> ?\((?:the )?[\"']?(?P<short>[A-Z][A-Za-z]{0,3}[A-Z][a-z]?)[\"']?\))"
    )


def abbreviated(text: str) -> list[Replacement]:
    """The noun instead of each later mention; known abbreviations ("the lead car (GVT)") stay."""
    if text.isupper() or not BRACKET.search(text):
        return []
    found: list[Replacement] = []
    for match in _explained().finditer(text):
        known = names(match["short"].lower())
        if known:
            found.append((match.start(), match.end(), match["short"]))
            continue
        again = list(re.finditer(rf"\b(?:(?:the|an?) )?{match['short']}\b(?! ?[-/]\w)", text[match.end() :], 0))
        if not again:
            continue
        match.end()
    return found
