"""One sentence for each component, in plain words (shown in the panes, and the query of the retrieval)."""

import re
from functools import cache, partial
from importlib import resources
from typing import Any

import yaml

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.program import border, parted
from c2s_engine.structure.quantity import Quantity, high, in_words, low
from c2s_engine.structure.specs import (
    EgoSpec,
    Limit,
    ObjectSpec,
    Phase,
    PlaceSpec,
    RestrictionsSpec,
    SettingsSpec,
    Trigger,
)
from c2s_engine.structure.triggers import clause, is_watched


@cache
def table() -> dict[str, Any]:
    """The words of the sentences."""
    text = resources.files("c2s_engine.data").joinpath("language", "sentences.yaml").read_text(encoding="utf-8")
    words: dict[str, Any] = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    return words


def plurals(noun: str) -> list[str]:
    """The plural forms of a noun phrase, by rule (its last word takes the ending)."""
    head, _, last = noun.rpartition(" ")
    lead = f"{head} " if head else ""
    if last in IRREGULAR:
        return [lead + IRREGULAR[last]]
    if re.search(r"(s|x|z|ch|sh)$", last):
        return [f"{lead}{last}es"]
    if re.search(r"[^aeiou]y$", last):
        return [f"{lead}{last[:-1]}ies"]
    if last.endswith("man"):
        return [f"{lead}{last[:-3]}men"]
    if last.endswith("child"):
        return [f"{lead}{last}ren"]
    if last.endswith("lf"):
        return [f"{lead}{last[:-1]}ves"]
    return [f"{lead}{last}s"]


IRREGULAR = {
    "person": "persons",
    "child": "children",
    "deer": "deer",
    "sheep": "sheep",
    "moose": "moose",
    "cattle": "cattle",
    "debris": "debris",
    "people": "people",
    "bus": "buses",
    "goose": "geese",
    "works": "works",
    "wildlife": "wildlife",
    "traffic": "traffic",
}


def _metres(value: Quantity) -> str:
    a, b = low(value), high(value)
    return f"{a:.0f} m" if b - a < 0.5 else f"{a:.0f} to {b:.0f} m"


def _third(words: str) -> str:
    """A verb phrase in the third person: "cross the road" -> "crosses the road"."""
    verb, blank, rest = words.partition(" ")
    verb = f"{verb}es" if re.search(r"(o|s|x|z|ch|sh)$", verb) else f"{verb}s"
    return f"{verb}{blank}{rest}"


def _named(name: str, names: dict[str, str]) -> str:
    """How a sentence calls a component: ego, a label such as V2, or "the" and its name."""
    called = names.get(name, name)
    return called if called == "ego" else called.upper() if re.fullmatch(r"[a-z]\d+", called) else f"the {called}"


def _phase(phase: Phase, names: dict[str, str], many: bool) -> str:
    words = table()["actions"][phase.action].format(target=_named(phase.target or "ego", names))
    if phase.action == "brake" and phase.rate and low(phase.rate) >= 4:
        words += " hard"
    if phase.side and phase.action in ("lane_change", "swerve", "drift", "leave_road", "cut_out"):
        words += f" to the {phase.side}"
    if phase.abandoned:
        words = f"begin to {words} and break off"
    words += "".join(f" {manner}" for manner in _manners(phase, names))
    trigger = phase.trigger
    if trigger and is_watched(trigger):
        words += f" when {_watched(trigger, names)}"
    elif trigger and trigger.value is not None:
        pattern = table()["triggers"].get(trigger.kind)
        words += " " + pattern.format(value=low(trigger.value), place=trigger.place) if pattern else ""
        words += f", and {low(trigger.delay):g} s later" if trigger.delay is not None else ""
    if phase.until:
        words += f" until {_watched(phase.until, names)}"
    return words if many else _third(words)


def action_of(phase: Phase, structure: Structure) -> str:
    """What a phase does, to whom and to which side, as in the component's sentence, without a number."""
    kept = {name: getattr(phase, name) for name in ("action", "target", "side", "abandoned")}
    return _phase(Phase(**kept), _object_names(structure), many=False)


def phase_words(phase: Phase, structure: Structure) -> str:
    """What a phase does, and when, as in the component's sentence."""
    return _phase(phase, _object_names(structure), many=False)


def _object_names(structure: Structure) -> dict[str, str]:
    return {c.id: c.spec.name for c in structure.objects if isinstance(c.spec, ObjectSpec)}


def _watched(trigger: Trigger, names: dict[str, str]) -> str:
    one = _named(trigger.subject, names) if trigger.subject else "it"
    other = _named(trigger.of, names) if trigger.of else "it" if trigger.subject else "ego"
    return clause(trigger, one, other)


def _manners(phase: Phase, names: dict[str, str]) -> list[str]:
    """How it does what it does: in words, at which gap, with which part, with how much room."""
    said, target = table(), _named(phase.target or "ego", names)
    values = {
        "pace": phase.pace and said["paces"][phase.pace],
        "gap": phase.gap is not None and _metres(phase.gap),
        "lateral_speed": phase.lateral_speed is not None and f"{low(phase.lateral_speed):g}",
        "part": phase.part and phase.part.replace("_", " "),
        "target_part": phase.target_part and phase.target_part.replace("_", " "),
        "clearance": phase.clearance is not None and f"{low(phase.clearance):g}",
    }
    return [said["manners"][name].format(value=value, target=target) for name, value in values.items() if value]


def _steps(phases: tuple[Phase, ...], names: dict[str, str], many: bool = False) -> str:
    return ", then ".join(_phase(p, names, many) for p in phases)


def _names(names: dict[str, str] | None) -> dict[str, str]:
    return {k: v.replace("_", " ") for k, v in (names or {}).items()}


def obj(spec: ObjectSpec, names: dict[str, str] | None = None) -> str:
    """An object's sentence."""
    names, place, many = _names(names), spec.placement, spec.count > 1
    along = {"behind": "behind", "abreast": "abreast of"}.get(place.along or "", "ahead of")
    where = table()["positions"][place.position].format(
        of=_named(place.of, names), side=place.side or "right", along=along
    )
    noun = spec.type.replace("_", " ")
    what = f"{spec.count} {plurals(noun)[0]}" if many else f"{'An' if noun[0] in 'aeiou' else 'A'} {noun}"
    text = f"{what} {where}"
    if place.gap is not None:
        text += f", {_metres(place.gap)} away"
    if many and spec.spacing is not None:
        text += f", {_metres(spec.spacing)} apart"
    if place.lanes_over > 1:
        text += f", {place.lanes_over} lanes over"
    if place.lateral is not None:
        text += f", {low(place.lateral):g} m to the side"
    if place.arrives is not None:
        beside = place.position == "oncoming_lane" and place.of != "ego"
        where = f"level with {_named(place.of, names)}" if beside else "where their ways meet"
        text += f", {where} {_after(place.arrives, _named('ego', names))}"
    if place.hidden_by:
        text += f", hidden by {_named(place.hidden_by, names)}"
    if spec.speed is not None and high(spec.speed) > 0.1:
        text += f", at {in_words('speed', spec.speed)}"
    elif spec.pace:
        text += f", {table()['paces'][spec.pace]}"
    steps = _steps(spec.phases, names, many)
    return f"{text}; {'they' if many else 'it'} {steps}." if steps else f"{text}."


def _after(arrives: Quantity, ego: str) -> str:
    seconds = low(arrives)
    when = "after" if seconds > 0 else "before"
    return f"{abs(seconds):g} s {when} {ego}" if seconds else f"together with {ego}"


def ego(spec: EgoSpec, names: dict[str, str] | None = None) -> str:
    """Ego's sentence."""
    names = _names(names)
    text = f"Ego, a {spec.type.replace('_', ' ')},"
    text += (
        f" drives at {in_words('speed', spec.speed)}"
        if spec.speed is not None and high(spec.speed) > 0.1
        else " stands at first"
        if spec.speed is not None
        else f" drives {table()['paces'][spec.pace]}"
        if spec.pace
        else " drives"
    )
    steps = _steps(spec.phases, names)
    if steps:
        text += f"; it {steps}"
    reaction = "brake_hard" if spec.reaction == "brake" and spec.hard else spec.reaction
    words = table()["reactions"].get(reaction)
    if words:
        text += "; " + words.format(target=_named(spec.react_to, names) if spec.react_to else "the other")
    return text + "."


def place(spec: PlaceSpec) -> str:
    """The place's sentence."""
    words = table()
    text = words["places"][spec.kind].capitalize()
    if spec.kind == "intersection":
        if spec.arms:
            text = f"An intersection of {spec.arms} roads"
        if spec.control:
            text += f" {words['controls'][spec.control]}"
        if spec.manoeuvre:
            text += f", where ego {words['manoeuvres'][spec.manoeuvre]}"
    if spec.curve:
        text += f" to the {spec.curve}"
    if spec.lanes:
        text += (
            f", {spec.lanes} or more lanes in ego's direction" if spec.lanes > 1 else ", one lane in ego's direction"
        )
    if spec.ego_lane:
        text += f", ego in the {spec.ego_lane}"
    if spec.oncoming:
        text += ", with an oncoming lane beside"
    if spec.crosswalk and spec.kind != "crosswalk":
        text += ", with a crosswalk"
    if spec.speed_limit:
        text += f", limit {in_words('speed_limit', spec.speed_limit)}"
    return text + "."


def settings(spec: SettingsSpec) -> str:
    """The settings' sentence."""
    sky = " and ".join(table()["weather"][w] for w in spec.weather or ("clear",))
    text = f"{sky.capitalize()}, {spec.time or 'day'}"
    text += f", map {spec.map}" if spec.map else ""
    text += f", ego's light {spec.light}" if spec.light else ""
    for change in spec.light_changes:
        text += f", {'then' if spec.light else 'the light turns'} {change.to} when "
        text += clause(change.when, change.when.subject or "ego", change.when.of or "the other")
    return text + "."


def limit(spec: Limit, names: dict[str, str] | None = None) -> str:
    """What a run must keep to all along, without its full stop."""
    known = _names(names)
    shown = partial(in_words, "speed") if spec.kind == "speed" else "{:g}".format
    bounds = [f"at least {shown(spec.minimum)}"] if spec.minimum is not None else []
    bounds += [f"at most {shown(spec.maximum)}"] if spec.maximum is not None else []
    other = _named(spec.other, known) if spec.other else "anybody"
    words = table()["limits"][spec.kind].format(bounds=" and ".join(bounds), other=other)
    subject = _named(spec.subject, known)
    return f"{subject[0].upper()}{subject[1:]} {words}"


def restrictions(spec: RestrictionsSpec, names: dict[str, str] | None = None) -> str:
    """The sentences on what holds all along, and on the run's end."""
    words, known = table()["ends"], _names(names)
    kept = [f"{limit(one, names)}." for one in spec.limits]
    ends = []
    for c in spec.terminate_when:
        other = _named(c.other, known) if c.other else "the other"
        action = (c.action or "").replace("_", " ")
        values = {"subject": _named(c.subject, known), "other": other, "minimum": f"{c.minimum or 0:g}"}
        ends.append(words[c.kind].format(**values, action=action))
    if spec.duration:
        ends.append(words["time"].format(minimum=f"{spec.duration:g}"))
    kept += [f"The run ends {' or '.join(ends)}."] if ends else []
    return " ".join(kept) or "No restriction beyond the scene itself."


def described(structure: Structure) -> Structure:
    """S with a sentence for each component, from its spec."""
    for component in structure.components:
        structure = structure.with_component(with_own_sentence(component, structure))
    return structure


def with_own_sentence(component: Component, structure: Structure) -> Component:
    """A component with the sentence that its spec makes."""
    return component.model_copy(update={"description": sentence(component, structure), "generated": True})


def says_its_spec(component: Component, structure: Structure) -> bool:
    """Whether a component's sentence was made from its spec: it is to follow that."""
    return component.generated or component.description == sentence(component, structure)


def sentence(component: Component, structure: Structure) -> str:
    """What a component's spec says, amid the others of S."""
    names = _object_names(structure)
    match component.spec:
        case SettingsSpec():
            return settings(component.spec)
        case PlaceSpec():
            return place(component.spec)
        case EgoSpec():
            return ego(component.spec, names)
        case ObjectSpec():
            return obj(component.spec, names)
        case _:
            return restrictions(component.spec, names)


def with_sentence(before: Structure, after: Structure, cid: str) -> Component:
    """A component of S after a change, its sentence saying what its spec does now, if it did before; the comment that
    borders its code says the sentence, if it did."""
    component, was = after[cid], before[cid].description
    follows = component.description == was and says_its_spec(before[cid], before)
    told = with_own_sentence(component, after) if follows else component
    line, code = parted(component.code)
    if line.rstrip() == border(before[cid]):
        told = told.model_copy(update={"code": f"{border(told)}\n{code}"})
    return told


def with_updated_sentences(before: Structure, after: Structure) -> Structure:
    """S after a change, each sentence that said what the spec did saying what it does now: a sentence of the user's
    own stays."""
    for was in (c for c in before.components if c.id in after):
        component = after[was.id]
        follows = component.description == was.description and says_its_spec(was, before)
        if follows and sentence(component, after) != sentence(was, before):
            after = after.with_component(with_own_sentence(component, after))
    return after
