"""A distance that is said of an act: "the gap at the cut-in is 12 m", "it cuts in 12 m ahead of ego", "ego stands 2 m
before the child". It belongs to the phase that has the field, not to where somebody starts."""

import re
from collections.abc import Sequence
from functools import cache
from typing import get_args

from c2s_engine.interpret.changes.forms import Found, name_of, quantity_of, value_of
from c2s_engine.interpret.changes.motion import is_relative
from c2s_engine.interpret.changes.refer import doing, refer
from c2s_engine.interpret.changes.scene_context import table
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.spans import Span
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField
from c2s_engine.structure.quantity import ends, in_words
from c2s_engine.structure.specs import Phase
from c2s_engine.structure.vocabulary import Action, Part

MOMENTARY = frozenset(("cut_in", "cut_out", "lane_change", "overtake"))
"""Acts of a moment, at which there is one gap."""


@cache
def with_field(name: str) -> frozenset[str]:
    """The actions whose phases can say a field, by its meaning in the vocabulary."""
    said = Phase.model_fields[name].description or ""
    return frozenset(a for a in get_args(Action) if re.search(rf"\b{a}\b", said))


def gap_of_act(clause: str, structure: Structure) -> Found | None:
    """ "The gap at the cut-in is 12 m", "it cuts in 12 m ahead of ego": of one who does that already."""
    told = re.sub(table()["meanwhile"], " ", clause)
    far = quantity_of(told, "distance")
    if far is None or is_relative(clause) or re.search(table()["denies"], clause):
        return None
    found = [(c, i) for c in structure.components for i, p in enumerate(getattr(c.spec, "phases", ()))
             if p.action in MOMENTARY & with_field("gap") and doing(told, (p.action,))]  # fmt: skip
    first = next((s for s in scan.names(told) if s.kind in ("actor", "label", "ego")), None)
    subject = refer(told[: first.end], structure, alone=False) if first is not None else None
    if subject is not None and (subject.id != "E" or re.match(r"(?:the )?ego\b", told)):
        found = [(c, i) for c, i in found if c.id == subject.id]
    if len(found) != 1:
        return None
    component, number = found[0]
    edit = SetField(component=component.id, path=f"phases.{number}.gap", value=value_of(far))
    act = component.spec.phases[number].action.replace("_", " ")  # type: ignore[union-attr]
    return [edit], f"{name_of(component)}: {act}, gap {in_words('gap', value_of(far))}"


def at_rest_before(clause: str, edits: Sequence[Edit], structure: Structure) -> list[Edit]:
    """The edits, and that one who moves and comes to stand a distance before somebody stops with that room to him."""
    far = quantity_of(re.sub(table()["meanwhile"], " ", clause), "distance")
    acts = next((e for e in edits if isinstance(e, SetField) and e.path == "phases"), None)
    if far is None or acts is None or acts.component not in structure:
        return list(edits)
    whom = _other(clause, structure, acts.component)
    still = [i for i, p in enumerate(acts.value) if p.action in ("stop", "stationary")]
    speed = ends(getattr(structure[acts.component].spec, "speed", None))
    if whom is None or len(still) != 1 or speed is not None and speed[1] == 0:
        return list(edits)
    target = "ego" if whom.id == "E" else whom.id
    update = {"action": "stop", "target": target, "clearance": value_of(far)}
    phases = list(acts.value)
    phases[still[0]] = phases[still[0]].model_copy(update=update)
    kept = [e for e in edits if e is not acts and not (isinstance(e, SetField) and e.path.startswith("placement"))]
    return [acts.model_copy(update={"value": tuple(phases)}), *kept]


STRUCK = re.compile(
    r"(?:(?P<own>with its |with his |with her )?(?:(?<=with its )|(?<=with his )|(?<=with her )"
    r"|(?!its|his|her)\w+.s|in the|on the|on its|from the) ?(?P<part>(?:(?:front|rear) )?(?:left"
    r"|right)|front|rear|back|side)(?:-?hand)?"
    r"(?: (?:side|corner|end|flank|door|wing))?|from (?P<way>behind|the rear|the back))$"
)
"""Where somebody is struck: "hits ego's left side", "runs into ego from behind"."""


def struck(clause: str, edits: Sequence[Edit]) -> list[Edit]:
    """The edits, and the part of whom he hits that somebody hits first."""
    match = STRUCK.search(re.sub(table()["meanwhile"], " ", clause).strip(" ,"))
    said = (
        "rear" if match and match["way"] else (match["part"] if match else "").replace("back", "rear").replace(" ", "_")
    )
    found, field = list(edits), "part" if match and match["own"] else "target_part"
    for number, edit in enumerate(edits if said in get_args(Part) else ()):
        if isinstance(edit, SetField) and edit.path == "phases" and any(p.action == "collide" for p in edit.value):
            phases = tuple(p if p.action != "collide" else p.model_copy(update={field: said})
                           for p in edit.value)  # fmt: skip
            found[number] = edit.model_copy(update={"value": phases})
    return found


def _other(clause: str, structure: Structure, doer: str) -> Component | None:
    """Who is named besides the doer."""
    spans = [s for s in scan.names(clause) if s.kind in ("actor", "label", "ego")]
    spans += [Span("id", *m.span()) for m in re.finditer(r"\bo[1-9]\b", clause)]
    found = [refer(f"the {clause[s.start : s.end]}", structure, alone=False) for s in spans]
    return next((c for c in found if c is not None and c.id != doer), None)
