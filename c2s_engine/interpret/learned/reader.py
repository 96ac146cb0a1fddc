"""S of the learned model's answer in short notation; what of the answer fits no field is left out.

The model is SmolLM2-135M with an adapter trained on texts with their S (benchmark/reading). It says what the text says:
no defaults, no planner's numbers. The weather, what it leaves out of the road, and what became of each clause come
from the embedded interpreter, which reads the whole text where the model cannot.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from c2s_engine.interpret import typologies
from c2s_engine.interpret.accounting import accounted_for_given_structure
from c2s_engine.interpret.composing import unmet
from c2s_engine.interpret.embedded import Understood, faults, understood
from c2s_engine.interpret.entities import fits
from c2s_engine.interpret.learned.certainty import CERTAIN, certainties
from c2s_engine.interpret.learned.decoder import Answer, ReaderError, loaded
from c2s_engine.interpret.learned.grounding import grounded
from c2s_engine.interpret.learned.notation import Components, left_out, parse
from c2s_engine.interpret.learned.quantities import si, unit_of
from c2s_engine.interpret.learned.units import rooms_in_seconds
from c2s_engine.interpret.llm import fallback
from c2s_engine.interpret.llm.components import link
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.account import is_set
from c2s_engine.structure.components import Assumption, Component, Structure, Unmet, field_words
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.sentences import described
from c2s_engine.structure.shown import value_in_words
from c2s_engine.structure.specs import SPEC_OF, AnySpec, ObjectSpec, PlaceSpec, SettingsSpec

MOST_WORDS = 80
"""Words of the longest texts that it was trained on, but for one in a hundred."""
NOT_USED = "the learned reader's words for it fit no field"
TOO_LONG = f"The text has more than the {MOST_WORDS} words that the learned reader can read"
NO_SCENARIO = "The learned reader's answer is no scenario"
CHECK = "The learned reader is not sure of {}: compare S with the text."
NAMED = 4
"""Fields that are named of those that it is not sure of; S marks all."""
GUESSED = "the learned reader is {:.0%} sure of it"
PASSED_OVER = "no field of S says it"
ALIKE = (("road", "straight"), ("straight", "road"), ("road", "curve"))
"""Kinds of place, the model's and the interpreter's, that can both be meant: the more special one is."""
INSTEAD = "{}: the embedded interpreter read the text instead."
_LENGTHS = ("gap", "spacing", "distance", "lateral", "clearance")
_UNITS = {**dict.fromkeys(_LENGTHS, "m"), "speed": "m/s", "rate": "m/s2", "duration": "s", "delay": "s", "arrives": "s"}
_REFERENCES = ("of", "target", "react_to", "hidden_by", "subject", "other")


@dataclass(frozen=True)
class Read:
    """S of a text, with the model's answer; `note`: why the embedded interpreter read it instead, or that
    S is to be looked at; empty where nothing is to be said."""

    structure: Structure
    answer: Answer | None = None
    note: str = ""


def asked(text: str) -> str:
    """A text as the model is asked it: one paragraph as one line, as in training."""
    return " ".join(text.split()) if text.count("\n") < 3 else text.strip()


def learned(text: str) -> Read:
    """S of a text; raises what the embedded interpreter raises."""
    found = understood(text)
    own = found.on_the_text(found.structure)
    if typologies.named(text):  # the name of a crash type stands for a text that the interpreter knows
        return Read(own)
    if len(text.split()) > MOST_WORDS:
        return Read(own, note=INSTEAD.format(TOO_LONG))
    try:
        answer = loaded().answer(asked(text))
    except ReaderError as error:
        return Read(own, note=INSTEAD.format(error))
    with faults():
        structure = reading(answer.text, found)
    if structure is None:
        return Read(own, answer, INSTEAD.format(NO_SCENARIO))
    structure, guesses = with_guesses(structure, answer)
    more = f" and {len(guesses) - NAMED} more" if len(guesses) > NAMED else ""
    return Read(structure, answer, CHECK.format(", ".join(guesses[:NAMED]) + more) if guesses else "")


def with_guesses(structure: Structure, answer: Answer) -> tuple[Structure, list[str]]:
    """S, in which the fields that the model was not certain of count as assumed; and these in words, the least certain
    first."""
    said = []
    for (cid, path), likely in sorted(certainties(answer).items(), key=lambda found: found[1]):
        if likely >= CERTAIN or cid not in structure or not is_set(structure[cid].spec, path):
            continue
        value = value_in_words(path, value_at(structure[cid].spec, path))
        note = Assumption(field=path, value=value, reason=GUESSED.format(likely), by="reader")
        component = structure[cid]
        structure = structure.with_component(component.model_copy(update={"assumed": (*component.assumed, note)}))
        said.append(f"{cid}'s {field_words(path)} ({value})")
    return structure, said


def reading(answer: str, found: Understood) -> Structure | None:
    """S of a text by the model's answer, with what became of each clause; None where the answer is no scenario."""
    components = parse(rooms_in_seconds(answer, found.mended.text))
    if not components.keys() & {"E", "R"}:
        return None
    scene = found.scene
    structure = _with_surroundings(structure_of(components, found.mended.text), found.structure)
    theirs, scene.ids = scene.ids, grounded(scene, structure)
    pairs = [(found.structure[_id(theirs[e])], cid) for e, cid in scene.ids.items() if e in theirs]
    structure = described(_with_rates(structure, [(own, _id(cid)) for own, cid in pairs]))
    structure = _with_others(scene, _with_untold(found, structure))
    structure = accounted_for_given_structure(scene, structure, found.mended.text)
    for component in structure.components:
        if component.id in components and not component.links:
            links = link(structure.text, component.description)
            structure = structure.with_component(component.model_copy(update={"links": links}))
    return _with_left_out(found.on_the_text(structure), left_out(answer))


def _id(name: str) -> str:
    """The id of the component of whom S calls so."""
    return "E" if name == "ego" else name


def _with_rates(structure: Structure, pairs: list[tuple[Component, str]]) -> Structure:
    """S with how hard somebody brakes ("hard", "gently") as the interpreter has read it, where the model left that
    open; `pairs`: the interpreter's components and the ids of the same in S."""
    for theirs, cid in pairs:
        rates = {p.action: p.rate for p in getattr(theirs.spec, "phases", ()) if p.rate is not None}
        phases = getattr(structure[cid].spec, "phases", ())
        filled = [p.model_copy(update={"rate": rates[p.action]}) if p.rate is None and p.action in rates else p
                  for p in phases]  # fmt: skip
        structure = structure.with_spec(cid, phases=tuple(filled))
    return structure


def _with_untold(found: Understood, structure: Structure) -> Structure:
    """S with what the text tells and no spec can say, each with whom it is about."""
    for owner, note in unmet.find(found.scene):
        cid = owner if isinstance(owner, str) else _id(found.scene.ids.get(owner, "E"))
        component = structure[cid]
        structure = structure.with_component(component.model_copy(update={"unmet": (*component.unmet, note)}))
    return structure


def _with_left_out(structure: Structure, phrases: Sequence[str]) -> Structure:
    """S with the phrases of its text that the model says to be in no component, where they are not noted yet."""
    known = [u.span for u in (*structure.not_understood, *structure.background) if u.span]
    known += [u.span for c in structure.components for u in c.unmet if u.span]
    notes = []
    for phrase in phrases:
        found = re.search(r"\s+".join(map(re.escape, phrase.split())), structure.text, re.IGNORECASE)
        if found and not any(a < found.end() and found.start() < b for a, b in known):
            notes.append(Unmet(text=found[0], reason=PASSED_OVER, span=found.span()))
    return structure.model_copy(update={"not_understood": (*structure.not_understood, *notes)})


def _with_others(scene: Scene, structure: Structure) -> Structure:
    """S with a note where somebody is of another type in it than the text's word for it."""
    for entity, cid in scene.ids.items():
        spec = structure[cid].spec if not entity.ego else None
        if isinstance(spec, ObjectSpec) and spec.type not in (entity.type, entity.noun) and not fits(entity, spec.type):
            at = entity.mentions[0]
            reason = f"in S it is a {spec.type.replace('_', ' ')}"
            note = Unmet(text=scene.text[at.start : at.end], reason=reason, span=(at.start, at.end))
            component = structure[cid]
            structure = structure.with_component(component.model_copy(update={"unmet": (*component.unmet, note)}))
    return structure


def _with_surroundings(structure: Structure, theirs: Structure) -> Structure:
    """S with the other reading's weather and map, and with what that one knows of the same kind of place beyond it."""
    place, other = structure.place.spec, theirs.place.spec
    assert isinstance(place, PlaceSpec) and isinstance(other, PlaceSpec)
    more: dict[str, Any] = {}
    if (place.kind, other.kind) in ALIKE or place.kind == other.kind:
        fields = (name for name in PlaceSpec.model_fields if name not in ("component", "kind"))
        more = {name: getattr(other, name) for name in fields if getattr(place, name) is None}
        more["kind"] = other.kind if place.kind == "road" else place.kind
    filled = structure.place.model_copy(update={"spec": place.model_copy(update=more)})
    own, read = structure.settings.spec, theirs.settings.spec
    assert isinstance(own, SettingsSpec) and isinstance(read, SettingsSpec)
    dark = read.time if read.time != "day" else None
    told = {"time": own.time or dark, "light": own.light, "light_changes": own.light_changes or read.light_changes}
    spec = read.model_copy(update={**told, "weather": read.weather or own.weather})
    settings = structure.settings.model_copy(update={"spec": spec})
    return described(structure.with_component(filled).with_component(settings))


def structure_of(components: Components, text: str) -> Structure:
    """S of components in plain data: whatever fits no field of its spec, or names nobody, is left out and noted."""
    objects = {cid: data for cid, data in components.items() if cid.startswith("O")}
    ids = {"ego", *objects}
    speeds = {"ego" if c == "E" else c: si(data["speed"]) for c, data in components.items() if "speed" in data}
    every = ("G", "R", "E", *objects, "T")
    found = {cid: component_of_data(cid, components.get(cid, {}), ids, speeds) for cid in every}
    structure = Structure(
        text=text, settings=found["G"], place=found["R"], ego=found["E"],
        objects=tuple(found[cid] for cid in objects), restrictions=found["T"],
    )  # fmt: skip
    return described(fallback.in_order(fallback.distinct_names(structure)))


def component_of_data(cid: str, data: dict[str, Any], ids: set[str], speeds: dict[str, Any]) -> Component:
    """A component of plain data; what fits no field of its spec is noted in `unmet`. `ids`: of all that are there;
    `speeds` (m/s), by these."""
    lost: list[str] = []
    own = "ego" if cid == "E" else cid
    spec = _spec(cid[0], _known(si(_in_units(data, own, speeds, lost)), ids, own, lost), lost)
    return Component(id=cid, spec=spec, unmet=tuple(Unmet(text=said, reason=NOT_USED) for said in lost))


def _in_units(data: Any, own: str, speeds: dict[str, Any], lost: list[str]) -> Any:
    """The data with quantities in the units of their fields: s of room are m at the speed of who follows; what has
    another unit goes."""
    if isinstance(data, list):
        return [_in_units(item, own, speeds, lost) for item in data]
    if not isinstance(data, dict):
        return data
    kept: dict[str, Any] = {}
    behind = "behind" in (data.get("position"), data.get("along"))
    beside = data.get("of", "ego") if "position" in data else own
    fast = [s for who in ((own, beside) if behind else (beside,)) if isinstance(s := speeds.get(who), float)]
    for name, value in data.items():
        unit = unit_of(value)
        if unit in ("", _UNITS.get(name, unit)):
            kept[name] = _in_units(value, own, speeds, lost)
        elif unit == "s" and name in _LENGTHS and fast:
            kept[name] = f"{round(si(value) * fast[0], 1)}m"
        else:
            lost.append(f"{name} {value}")
    return kept


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
