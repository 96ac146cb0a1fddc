"""S of the learned model's answer in short notation; what of the answer fits no field is left out.

The model is SmolLM2-135M with an adapter trained on texts with their S (benchmark/reading). It says what the text says:
no defaults, no planner's numbers. Weather, times of day, maps and blueprints, which are a catalogue's words, are found
by table (interpret/settings.py).
"""

import re
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from c2s_engine.interpret import language, typologies
from c2s_engine.interpret.english import NOT_ENGLISH, is_english
from c2s_engine.interpret.errors import InterpretError, faults
from c2s_engine.interpret.learned.account import accounted
from c2s_engine.interpret.learned.bounds import with_bounds
from c2s_engine.interpret.learned.certainty import CERTAIN, certainties
from c2s_engine.interpret.learned.decoder import Answer, ReaderError, loaded
from c2s_engine.interpret.learned.notation import Components, left_out, parse
from c2s_engine.interpret.learned.quantities import si, unit_of
from c2s_engine.interpret.learned.rates import with_rates
from c2s_engine.interpret.learned.units import quantities, rooms_in_seconds
from c2s_engine.interpret.mentions import mentions, names_ego
from c2s_engine.interpret.settings import Settings, detect
from c2s_engine.structure.account import is_set
from c2s_engine.structure.components import READ, Assumption, Component, Link, Structure, Unmet, field_words
from c2s_engine.structure.edits import SPEC_ADAPTER, no_side
from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.objects import distinct_names, in_order
from c2s_engine.structure.sentences import described
from c2s_engine.structure.shown import value_in_words
from c2s_engine.structure.specs import SPEC_OF, AnySpec, ObjectSpec, SettingsSpec
from c2s_engine.structure.vocabulary import ON_FOOT, VEHICLES

MOST_WORDS = 300
"""Words of a text that are read; the rest is listed as not understood. Few of those that it was trained on have more
than 80."""
NOT_USED = "the learned reader's words for it fit no field"
BEYOND = f"only the first {MOST_WORDS} words are read"
EMPTY = "The text is empty: describe a driving scene, for example “a car cuts in ahead of ego”."
NO_SCENARIO = (
    "This describes no driving scenario: name in English the vehicles or people, where they are and what they do."
)
CHECK = "The learned reader is not sure of {}: compare S with the text."
FEW = 8
"""Words of a text that is a scene though it names one road user alone."""
NAMED = 4
"""Fields that are named of those that it is not sure of; S marks all."""
GUESSED = "read with a certainty of {:.0%}"
_LENGTHS = ("gap", "spacing", "distance", "lateral", "clearance")
_UNITS = {**dict.fromkeys(_LENGTHS, "m"), "speed": "m/s", "rate": "m/s2", "duration": "s", "delay": "s", "arrives": "s"}
MOVERS = (*VEHICLES, *ON_FOOT)
_REFERENCES = ("of", "target", "react_to", "hidden_by", "subject", "other")


@dataclass(frozen=True)
class Read:
    """S of a text, with the model's answer; `note`: that S is to be looked at; empty where nothing is to be said."""

    structure: Structure
    answer: Answer
    note: str = ""


def asked(text: str) -> str:
    """A text as the model is asked it: one paragraph as one line, as in training."""
    return " ".join(text.split()) if text.count("\n") < 3 else text.strip()


def learned(text: str) -> Read:
    """S of a text. Raises InterpretError where it is empty, no English or tells no driving scene, or where the model
    cannot be asked; InterpreterFault where c2s fails."""
    if not text.strip():
        raise InterpretError(EMPTY)
    if not is_english(text):
        raise InterpretError(NOT_ENGLISH)
    named = typologies.meant(text)
    if named is None and not _of_the_road(text):
        raise InterpretError(NO_SCENARIO)
    words = list(re.finditer(r"\S+", text))
    told = text[: words[MOST_WORDS].start()] if len(words) > MOST_WORDS else text
    try:
        answer = loaded().answer(asked(named[0] if named else told))
    except ReaderError as error:
        raise InterpretError(f"{error}.") from None
    with faults():
        structure = reading(answer.text, told, named[1] if named else None)
        if structure is None or not _tells(structure, told):
            raise InterpretError(NO_SCENARIO)
        if told != text:
            rest = Unmet(text=text[len(told) :][:200], reason=BEYOND, span=(len(told), len(text)))
            update = {"text": text, "not_understood": (*structure.not_understood, rest)}
            structure = structure.model_copy(update=update)
        structure, guesses = with_guesses(structure, answer)
    more = f" and {len(guesses) - NAMED} more" if len(guesses) > NAMED else ""
    return Read(structure, answer, CHECK.format(", ".join(guesses[:NAMED]) + more) if guesses else "")


def _of_the_road(text: str) -> bool:
    """Whether a text has a word that only scenes of the road have, or names two who may be in one; if short, one."""
    if _words(text) & set(language.table("trade")["road"]) or any(unit == "m/s" for _, _, unit in quantities(text)):
        return True
    named = len(mentions(text)) + names_ego(text)
    return named > 1 or named == 1 and len(text.split()) <= FEW


def _words(text: str) -> set[str]:
    return set(re.findall(r"[a-z-]+", text.lower()))


def _tells(structure: Structure, text: str) -> bool:
    """Whether S tells of anybody who moves or does something, or the text of the road."""
    ego = structure.ego.spec.model_dump(exclude_defaults=True, exclude={"component", "model"})
    movers = [o for o in structure.objects if isinstance(o.spec, ObjectSpec) and o.spec.type in MOVERS]
    place = structure.place.spec.model_dump(exclude_defaults=True, exclude={"component"})
    return bool(ego or movers or place or _words(text) & set(language.table("trade")["road"]))


def with_guesses(structure: Structure, answer: Answer) -> tuple[Structure, list[str]]:
    """S, in which the fields that the model was not certain of count as assumed; and these in words, the least certain
    first."""
    said = []
    for (cid, path), likely in sorted(certainties(answer).items(), key=lambda found: found[1]):
        if likely >= CERTAIN or cid not in structure or not is_set(structure[cid].spec, path):
            continue
        value = value_in_words(path, value_at(structure[cid].spec, path))
        note = Assumption(field=path, value=value, reason=GUESSED.format(likely), by=READ)
        component = structure[cid]
        structure = structure.with_component(component.model_copy(update={"assumed": (*component.assumed, note)}))
        said.append(f"{cid}'s {field_words(path)} ({value})")
    return structure, said


def reading(answer: str, text: str, named: tuple[int, int] | None = None) -> Structure | None:
    """S of a text by the model's answer, with what became of each clause; None where the answer is no scenario.
    `named`: where the name of a crash type stands that the text only is."""
    components = parse(rooms_in_seconds(answer, text))
    if not components.keys() & {"E", "R"}:
        return None
    settings = detect(text)
    structure = described(with_bounds(_with_settings(structure_of(components, text), settings)))
    if named is None:
        return described(with_rates(accounted(structure, settings, left_out(answer))))
    link = Link(kind="text", label=text[slice(*named)], span=named)
    for component in structure.components:
        structure = structure.with_component(component.model_copy(update={"links": (link,)}))
    return structure


def _with_settings(structure: Structure, found: Settings) -> Structure:
    """S with what was found of settings: of the weather before what the model says, of the time where it says none."""
    own, told = structure.settings.spec, found.spec()
    assert isinstance(own, SettingsSpec)
    update: dict[str, Any] = {"time": own.time or told.time, "weather": told.weather or own.weather, "map": told.map,
                              "preset": told.preset}  # fmt: skip
    structure = structure.with_spec("G", **update)
    return structure.with_spec("E", model=found.model.value) if found.model else structure


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
    return described(in_order(distinct_names(structure)))


def component_of_data(cid: str, data: dict[str, Any], ids: set[str], speeds: dict[str, Any]) -> Component:
    """A component of plain data; what fits no field of its spec is noted in `unmet`. `ids`: of all that are there;
    `speeds` (m/s), by these."""
    lost: list[str] = []
    own = "ego" if cid == "E" else cid
    spec = _spec(cid[0], _known(si(_in_units(data, own, speeds, lost)), ids, own, lost), lost)
    if isinstance(spec, ObjectSpec) and spec.placement.side and no_side(spec):
        lost.append(f"side {spec.placement.side}")
        spec = spec.model_copy(update={"placement": spec.placement.model_copy(update={"side": None})})
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
