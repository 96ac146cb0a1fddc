"""What a text tells and the specs cannot say: understood, shown with its component, and left out of the scenario."""

import re
from functools import cache
from typing import NamedTuple

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.components import Unmet


class UnmetNote(NamedTuple):
    """Something that no spec can say: whose it is (an entity, or a component's id) and the note on it."""

    owner: Entity | str
    note: Unmet


@cache
def _patterns() -> list[tuple[re.Pattern[str], str, str]]:
    return [(re.compile(p["find"]), p["about"], p["reason"]) for p in language.table("unmet")["patterns"]]


def find(scene: Scene) -> list[UnmetNote]:
    """All of it, in the order of the text; at most twelve notes."""
    found: list[UnmetNote] = []
    taken: list[tuple[int, int]] = []
    for pattern, about, reason in _patterns():
        for match in pattern.finditer(scene.plain):
            owner: Entity | str = _nearest_road_user(scene, match.start()) if about == "actor" else about
            taken.append(match.span())
            text = scene.text[match.start() : match.end()].strip()
            found.append(UnmetNote(owner, Unmet(text=text, reason=reason, span=match.span())))
    found.sort(key=lambda u: u.note.span or (0, 0))
    return found[:12]


def _nearest_road_user(scene: Scene, start: int) -> Entity:
    """The road user that a place in the text is about: the one named last before it in its sentence, else the next."""
    number = next((w.sentence for w in scene.words if w.end > start), None)
    near = [i for i in sorted(scene.cast.of) if scene.words[i].sentence == number]
    before = [i for i in near if scene.words[i].start <= start and scene.words[i].dep in ("nsubj", "nsubjpass", "ROOT")]
    pick = before[-1:] or [i for i in near if scene.words[i].start <= start][-1:] or near[:1]
    return scene.cast.of[pick[0]] if pick else scene.cast.ego


def alternatives(scene: Scene, entity: Entity) -> list[str]:
    """Choices that the text leaves between two acts of an entity, in words: the first of them is what is taken."""
    said = []
    for event in scene.clauses.events:
        if event.mode != "alternative" or event.agent is not entity:
            continue
        taken = scene.words[scene.words[event.word].head]
        if taken.i in scene.clauses.by_word:
            said.append(f"of “{taken.text}” or “{scene.words[event.word].text}” the first is taken")
    return said
