"""Road users and things that a text names, by their nouns."""

import re
from dataclasses import dataclass
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.text import normalised
from c2s_engine.structure import vocabulary

FAMILY = {
    "vehicle": (*vocabulary.VEHICLES, "vehicle"), "rider": ("bicycle", "motorcycle"),
    "pedestrian": ("pedestrian", "child"),
    "obstacle": ("obstacle", "box", "debris", "container", "barrel"), "car": ("car", "police_car"),
    "child": ("child", "pedestrian"), "truck": ("truck", "pickup", "fire_truck"),
}  # fmt: skip
"""The types of objects that a noun can mean, where it means more than its own."""


@dataclass(frozen=True)
class Mention:
    """A noun for a road user or thing: where it stands, and its type."""

    start: int
    end: int
    type: str

    def fits(self, kind: str) -> bool:
        """Whether it can mean an object of that type."""
        return kind in FAMILY.get(self.type, (self.type,))


@cache
def _nouns() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?P<noun>{language.alternatives(list(language.actor_nouns()))})(?![\w]|-\w)")


@cache
def _things() -> re.Pattern[str]:
    words = [word for row in language.table("trade")["things"] for word in row["words"]]
    return re.compile(rf"(?<![\w-])(?:{language.alternatives(words)})(?![\w-])")


def mentions(text: str) -> list[Mention]:
    """The mentions of a text in their order."""
    known, plain = language.actor_nouns(), normalised(text)
    things = [match.span() for match in _things().finditer(plain)]
    found = []
    for match in _nouns().finditer(plain):
        noun = re.sub(r"[\s-]+", " ", match["noun"])
        kind = known.get(noun) or known.get(match["noun"], "vehicle")
        if kind == "vehicle" and any(start <= match.start() and match.end() < end for start, end in things):
            continue  # the traffic of a traffic light
        found.append(Mention(match.start(), match.end(), kind))
    return found


@cache
def _ego() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?:{'|'.join(map(re.escape, language.table('trade')['ego']))})(?![\w-])")


def names_ego(text: str) -> bool:
    """Whether a text speaks of ego."""
    return _ego().search(normalised(text)) is not None
