"""Who is meant where only a value of his is told: "70 instead of 80", "60 m is too far, 40 please".

He is the one who has that speed, distance or moment now; ego before the others.
"""

import re
from collections.abc import Iterator
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import notes
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec

DEMANDS = {
    "speed": "{who} at {value} km/h",
    "gap": "the gap to {who} is {value} m",
    "distance": "{who} should start when ego is {value} m away",
    "time": "{who} should start after {value} s",
    "ttc": "{who} should start when the ttc is {value} s",
}
"""What is demanded by a new value of each sort."""
MEASURED = {"speed": "k", "gap": "m", "distance": "m", "time": "s", "ttc": "s"}
"""How the units of each sort begin."""


@cache
def _forms(section: str) -> list[re.Pattern[str]]:
    table = language.table("wordings")
    words = {**table["words"], **table["old_values"]["words"]}
    return [notes.compiled(form, words) for form in table["old_values"][section]]


def in_place_of_old(sentence: str, structure: Structure) -> str:
    """A sentence that gives an old value and a new one, as a demand of the one who has the old; else the sentence."""
    match = next((m for form in _forms("says") if (m := form.fullmatch(sentence.strip()))), None)
    if match is None or scan.names(sentence):
        return _moment(sentence, structure)
    told = match.groupdict()
    unit = (told.get("unit") or told.get("old_unit") or "").strip()
    for component in structure.components:
        for sort, value in _values(component):
            if abs(value - float(told["old"])) < 0.5 and MEASURED[sort].startswith(unit[:1]):
                who = "ego" if component.id == "E" else component.id.lower()
                return DEMANDS[sort].format(who=who, value=told["new"])
    return sentence


def _moment(sentence: str, structure: Structure) -> str:
    """A sentence that gives but a moment, as a demand of the one who waits for such a one; else the sentence."""
    match = next((m for form in _forms("moments") if (m := form.fullmatch(sentence.strip()))), None)
    unit = (match["unit"] or "").strip() if match else ""
    for component in structure.objects if unit else ():
        for sort, _ in _values(component):
            if match and sort in ("distance", "time") and MEASURED[sort].startswith(unit[:1]):
                return DEMANDS[sort].format(who=component.id.lower(), value=match["new"])
    return sentence


def _values(component: Component) -> Iterator[tuple[str, float]]:
    """What is measured of somebody now: each sort and its value in km/h, m or s."""
    spec = component.spec
    if not isinstance(spec, EgoSpec | ObjectSpec):
        return
    if spec.speed is not None:
        yield "speed", middle(spec.speed) * 3.6
    if isinstance(spec, ObjectSpec) and spec.placement.gap is not None:
        yield "gap", middle(spec.placement.gap)
    for trigger in (p.trigger for p in spec.phases if p.trigger):
        if trigger.kind in DEMANDS and trigger.value is not None:
            yield trigger.kind, middle(trigger.value)
