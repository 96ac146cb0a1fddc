"""Road users of one type told apart: amid the scene that is retold each gets a noun of his own.

"The second car brakes for the third" is read amid a car, a van and a truck; what that gives is said of the cars.
"""

import re

from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure

ALIKE = (
    ("car", "van", "truck", "bus"),
    ("pedestrian", "animal"),
    ("child", "animal"),
    ("bicycle", "motorcycle"),
    *((urgent, "van", "truck", "bus") for urgent in ("police_car", "ambulance", "fire_truck")),
)
"""Types that can stand for each other."""
MEANT = re.compile(
    r"(?:\b(?:the|that|this|our|my|both) |^)"
    r"(?:(?!(?:an?|and|the|another|one|two|three|some|more|add|with) )[\w-]+ ){0,2}$"
)
"""What stands before one who is there."""
NEW = re.compile(r"\b(?:another|an?|one more|(?:a )?(?:second|third)) $")
"""What stands before one who is new."""


def told_apart(clause: str, structure: Structure) -> tuple[str, Structure]:
    """The clause and S with a noun of its own for each of one type; both as they are where that is not needed."""
    nouns = _nouns(clause, structure)
    if not nouns:
        return clause, structure
    for span in reversed([s for s in scan.names(clause) if s.kind == "actor" and not s.data.get("plural")]):
        head = MEANT.search(clause[: span.start])
        meant = refer(f"{head[0]}{clause[span.start : span.end]}", structure, alone=False) if head else None
        if head is not None and meant is not None and meant.id in nouns:
            clause = f"{clause[: head.start()]}the {nouns[meant.id]}{clause[span.end :]}"
    for component in structure.objects:
        structure = structure.with_component(_called(component, nouns))
    return clause, structure


def _called(component: Component, nouns: dict[str, str]) -> Component:
    noun = nouns.get(component.id, spec_of(component).type)
    spec = spec_of(component).model_copy(update={"type": noun, "name": noun})
    return component.model_copy(update={"spec": spec})


def _nouns(clause: str, structure: Structure) -> dict[str, str]:
    """By id, the nouns of those who share their type with another; none where these do not suffice."""
    types = [spec_of(c).type for c in structure.objects]
    spans = [s for s in scan.names(clause) if s.kind == "actor"]
    named = {s.data["type"] for s in spans}
    new = {s.data["type"] for s in spans if NEW.search(clause[: s.start])}
    new &= {s.data["type"] for s in spans if re.search(r"\bthe $", clause[: s.start])}
    types += sorted(new)
    found: dict[str, str] = {}
    for component in structure.objects:
        kind = spec_of(component).type
        pool = next((p for p in ALIKE if kind in p), ())
        if types.count(kind) < 2 or not pool:
            continue
        taken = {*types, *named} - {kind} | set(found.values())
        free = [noun for noun in (kind, *pool) if noun not in taken and not (noun == kind and kind in new)]
        if not free:
            return {}
        found[component.id] = free[0]
    return found
