"""Labels of people and of numbered actors ("P-1", "B2", "NPC 2"), and which party of a claim ego is not."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.spans import Span

FORMS = frozenset(("ahead", "behind", "who", "in front"))


@cache
def _numbered_part() -> re.Pattern[str]:
    parts = language.alternatives(language.table("ego")["labels"]["parts"])
    return re.compile(rf"(?<![\w-])(?:the )?(?P<word>{parts})[ _-]?#?(?P<id>[1-9])(?![\w/%-]|\.\d|\s?(?:m|s|km)\b)")


@cache
def _short_label() -> re.Pattern[str]:
    shorts = "|".join(language.table("ego")["labels"]["short"])
    return re.compile(rf"(?<![\w-])(?P<word>{shorts})\.?[ -]?#?(?P<id>[1-9])(?![\w/%-]|\.\d)")


NO_ROAD = re.compile(
    r"(?:^|[.,;:(]|\b(?:and|struck|strikes?|hits?|hitting|striking|with|by|of|contacted|towards?|while|when|as|for|into"
    r"|behind))\s*$"
)


def short_labels(text: str) -> list[Span]:
    """The letters and numbers of people on foot and riders in a report ("P-1", "B2"), not of roads ("on the B1"), and
    those of actors in a test ("NPC 2")."""
    shorts = language.table("ego")["labels"]["short"]
    parts = [
        Span("label", m.start(), m.end(), {"label": f"{m['word']} {m['id']}", "word": ""})
        for m in _numbered_part().finditer(text)
    ]
    found = [m for m in _short_label().finditer(text) if NO_ROAD.search(text[max(0, m.start() - 12) : m.start()])]
    for match in found:
        noun, number = shorts[match["word"]], match["id"]
        data = {"label": f"{noun} {number}", "word": noun}
        parts.append(Span("label", match.start(), match.end(), data))
    return parts
