"""S of the learned model's answer in short notation; what of the answer fits no field is left out.

The model is SmolLM2-135M with an adapter trained on texts with their S (benchmark/reading). It says what the text says:
no defaults, no planner's numbers. Weather, light and what it leaves out of the road come from the embedded interpreter,
which reads these better; where its answer is no S at all, all of that one's reading stands in.
"""

from typing import Any

from pydantic import ValidationError

from c2s_engine.interpret.learned.notation import Components, parse
from c2s_engine.interpret.learned.quantities import si
from c2s_engine.interpret.llm import fallback
from c2s_engine.interpret.llm.components import link
from c2s_engine.interpret.llm.typed import Embedded, Reading
from c2s_engine.structure.components import Component, Structure, Unmet
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.sentences import described
from c2s_engine.structure.specs import SPEC_OF, AnySpec, PlaceSpec

NOT_USED = "the learned reader's words for it fit no field"
_REFERENCES = ("of", "target", "react_to", "hidden_by", "subject", "other")


def asked(text: str) -> str:
    """A text as the model is asked it: one paragraph as one line, as in training."""
    return " ".join(text.split()) if text.count("\n") < 3 else text.strip()


def reading(answer: str, text: str, embedded: Embedded) -> Reading:
    """S of a text by the model's answer; raises what the embedded interpreter raises where that has to stand in."""
    components = parse(answer)
    theirs = fallback.Embedded(embedded, text)
    if "E" in components or "R" in components:
        return Reading(structure=_with_surroundings(structure_of(components, text), theirs.structure))
    reason = "The learned reader's answer is no scenario: the embedded interpreter read the text instead."
    structure = theirs.strict()
    return Reading(structure=structure, fallbacks=dict.fromkeys(structure.ids, reason), notes=(reason,))


def _with_surroundings(structure: Structure, theirs: Structure) -> Structure:
    """S with the other reading's settings, and with what that one knows of the same kind of place beyond it."""
    place, other = structure.place.spec, theirs.place.spec
    assert isinstance(place, PlaceSpec) and isinstance(other, PlaceSpec)
    more: dict[str, Any] = {}
    if place.kind == other.kind or {place.kind, other.kind} == {"road", "straight"}:
        fields = (name for name in PlaceSpec.model_fields if name not in ("component", "kind"))
        more = {name: getattr(other, name) for name in fields if getattr(place, name) is None}
        more["kind"] = other.kind if place.kind == "road" else place.kind
    filled = structure.place.model_copy(update={"spec": place.model_copy(update=more)})
    settings = theirs.settings.model_copy(update={"assumed": ()})
    return described(structure.with_component(filled).with_component(settings))


def structure_of(components: Components, text: str) -> Structure:
    """S of components in plain data: whatever fits no field of its spec, or names nobody, is left out and noted."""
    objects = {cid: data for cid, data in components.items() if cid.startswith("O")}
    ids = {"ego", *objects}
    found = {cid: _component(cid, components.get(cid, {}), ids) for cid in ("G", "R", "E", *objects, "T")}
    structure = Structure(
        text=text, settings=found["G"], place=found["R"], ego=found["E"],
        objects=tuple(found[cid] for cid in objects), restrictions=found["T"],
    )  # fmt: skip
    structure = described(fallback.in_order(fallback.distinct_names(structure)))
    for component in structure.components:
        if component.id in components:
            links = link(text, component.description)
            structure = structure.with_component(component.model_copy(update={"links": links}))
    return structure


def _component(cid: str, data: dict[str, Any], ids: set[str]) -> Component:
    lost: list[str] = []
    own = "ego" if cid == "E" else cid
    spec = _spec(cid[0], _known(si(data), ids, own, lost), lost)
    return Component(id=cid, spec=spec, unmet=tuple(Unmet(text=said, reason=NOT_USED) for said in lost))


def _known(data: Any, ids: set[str], own: str, lost: list[str]) -> Any:
    """The data without references to those who are not there, or to oneself; a trigger that names such a one goes."""
    if isinstance(data, list):
        return [_known(item, ids, own, lost) for item in data]
    if not isinstance(data, dict):
        return data
    kept: dict[str, Any] = {}
    watches = data.get("subject", own) != own  # a trigger about somebody else may name its own actor
    for name, value in data.items():
        itself = value == own and name not in ("subject", "other") and not (name == "of" and watches)
        if name in _REFERENCES and (value not in ids or itself):
            lost.append(f"{name} {value}")
        elif name in ("trigger", "until", "when") and isinstance(value, dict) and value.get("of", "ego") not in ids:
            lost.append(f"{value.get('kind', '')} {value['of']}".strip())
        else:
            kept[name] = _known(value, ids, own, lost)
    return kept


def _spec(kind: str, data: dict[str, Any], lost: list[str]) -> AnySpec:
    """The spec of plain data; what does not validate goes, the smallest part that makes a difference first."""
    data = {"component": kind, **data}
    while True:
        try:
            return SPEC_ADAPTER.validate_python(data)
        except ValidationError as error:
            place = [p for p in error.errors()[0]["loc"] if p not in SPEC_OF]
            if not _without(data, place, lost):
                return SPEC_OF[kind]()


def _without(data: Any, place: list[Any], lost: list[str]) -> bool:
    """Take out of the data what lies at a place, or the innermost part around it that is there; whether any is."""
    around: list[tuple[Any, Any]] = []
    at = data
    for step in place:
        there = isinstance(at, dict) and step in at or isinstance(at, list) and isinstance(step, int) and step < len(at)
        if not there:
            break
        around.append((at, step))
        at = at[step]
    if not around:
        return False
    holder, step = around[-1]
    if isinstance(at, str | int | float):
        lost.append(f"{step} {at}")
    elif isinstance(step, str):  # a step that has lost its action was noted by that
        lost.append(step)
    del holder[step]
    return True
