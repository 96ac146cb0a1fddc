"""Changes of who is there: removed, replaced, added."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.chosen import ORDINALS, in_role, matching_modifiers
from c2s_engine.interpret.changes.forms import ALREADY, Found, name_of
from c2s_engine.interpret.changes.how_many import count_of
from c2s_engine.interpret.changes.meant import is_there
from c2s_engine.interpret.changes.refer import objects_of, refer, spec_of
from c2s_engine.interpret.changes.removal_edits import removal_edits
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.surroundings import environment
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField, SetSpec, apply
from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.structure.vocabulary import VEHICLES


def remove(clause: str, structure: Structure) -> Found | None:
    """ "Remove the rain", "without the cyclist", "delete O2", "remove everything but the pedestrian"."""
    table = language.table("refine")
    match = next((m for p in table["removes"] if (m := re.match(p, clause))), None)
    if not match:
        return None
    rest = match["what"]
    sky = environment.weather(rest, [(0, len(rest))])
    if sky:
        return _without_weather([f.value for f in sky], structure)
    if re.match(r"(traffic )?lights?|signals?$", rest):
        if getattr(structure.place.spec, "control", None) not in (None, "signal", "none"):
            return [], "there are signs instead of traffic lights"
        return [SetField(component="R", path="control", value="none")], "no traffic lights"
    if re.match(r"(?:stop|yield|give[- ]way) signs?$", rest):
        return [SetField(component="R", path="control", value="none")], "no signs"
    coming = [c for c in structure.objects if spec_of(c).placement.position in ("oncoming_lane", "opposite_approach")]
    if coming and re.match(r"oncoming (?:traffic|vehicles|cars)$", rest):
        return removal_edits(coming, structure), "no oncoming traffic"
    if match[0].startswith(("stop ", "please stop ")) or _tells_more(rest):
        return None
    names = [n for n in re.split(r",? and |, | or ", rest) if n]
    found = [refer(name, structure, alone=len(names) == 1) for name in names]
    several = [c for c in found if c is not None and c.id != "E"]
    if len(names) > 1 and len({c.id for c in several}) == len(names):
        return removal_edits(several, structure), f"{', '.join(name_of(c) for c in several)} removed"
    component = refer(rest, structure, alone=len(structure.objects) == 1)
    if component is None or component.id == "E" or not is_there(rest, component):
        return None
    if (some := _some_of(rest, component)) is not None:
        return some
    alike = [c for c in structure.objects if spec_of(c).type == spec_of(component).type]
    meant = _matching_modifiers(rest, alike, structure.text) if len(alike) > 1 else None
    if meant is not None and component not in meant:
        if len(meant) != 1:
            return [], f"it is not clear which “{rest}” is: say {' or '.join(name_of(c) for c in meant or alike)}"
        component = meant[0]
    return removal_edits([component], structure), f"{name_of(component)} removed"


def _matching_modifiers(rest: str, alike: list[Component], text: str) -> list[Component] | None:
    """Those of one type whom a phrase can mean by the words before its noun; None where that is known otherwise."""
    noun = next((s for s in scan.names(rest) if s.kind == "actor"), None)
    if noun is None or len(in_role(noun.data["roles"], alike)) < len(alike):
        return None
    return matching_modifiers(rest[: noun.end - len(noun.data["noun"])], alike, text)


def _tells_more(rest: str) -> bool:
    """Whether what stands where one is named who is to go tells what he does or when: "no, after stopping the kid runs
    back" takes nobody away."""
    first = next((s for s in scan.names(rest) if s.kind in ("actor", "label")), None)
    if first is None:
        return False
    return bool(_MOMENT.search(rest[: first.start]) or _PREDICATE.match(rest[first.end :]))


_MOMENT = re.compile(r"\b(?:after|before|when|while|once|until|if|as soon as)\b")
_PREDICATE = re.compile(
    r" (?:should|shall|must|will|can|may|has to|does|do|is|are|was|were)\b|"
    r" (?!(?:as|its|his|this|across|towards|besides|always)\b)[a-z]{2,}(?<![su])s\b(?! (?:and|or)\b|$)"
)


def _some_of(who: str, component: Component) -> Found | None:
    """Some of those who are told of together are taken away: "one of the parked cars", "the second parked car"."""
    spec, said = spec_of(component), re.sub(r"^(?:just|only|but) ", "", who)
    if spec.count < 2:
        return None
    number = re.match(r"(?:the )?(\w+) of |(\d+|one|an?|two|three|four|five|six) ", said)
    named = next((s for s in scan.names(said) if s.kind == "actor"), None)
    words = said[: named.start].split() if named is not None else []
    single = named is not None and not named.data.get("plural", False)
    if number is not None and (number[1] or number[2]) not in ("all", "both", "each", "every"):
        gone_now = 1 if (number[1] or "") in ORDINALS else count_of(number[1] or number[2], spec.count)
    elif single and set(words) & {*ORDINALS, "other"}:
        gone_now = 1
    else:
        return None
    left = spec.count - gone_now
    if left < 1:
        return None
    fewer = spec.model_copy(update={"count": left, "spacing": spec.spacing if left > 1 else None})
    return [SetSpec(component=component.id, spec=fewer)], f"{name_of(component)}: {left}"


def _without_weather(values: list[str], structure: Structure) -> Found:
    now = structure.settings.spec.weather  # type: ignore[union-attr]
    rains = {"rain", "heavy_rain"}
    wet = {*rains, "wet"} if rains & set(now) else rains  # a road that is wet without rain stays so
    away = set().union(*(wet if v in rains else {v} for v in values))
    left = [w for w in now if w not in away]
    edits: list[Edit] = [SetField(component="G", path="weather", value=left)]
    return edits, f"no {' or '.join(v.replace('_', ' ') for v in values)}"


def retype(clause: str, structure: Structure) -> Found | None:
    """ "Make the lead a truck", "a bus instead of the van", "two cyclists instead", "replace O1 with a deer"."""
    known = [s for s in scan.names(clause) if s.kind == "actor" and (s.data["type"] not in ("vehicle", "rider"))]
    table = language.table("refine")
    for pattern in table["retypes"]:
        match = re.match(pattern, clause)
        if not match:
            continue
        named = [s for s in known if match.start("what") <= s.start < match.end("what")]
        if not named:
            continue
        kind, plural = named[0].data["type"], named[0].data.get("plural", False)
        if pattern == table["how_many"] and (not objects_of(structure, kind)):
            continue
        who = match.groupdict().get("who") or ""
        if re.search(r"\b(?:driver|rider|passenger)\b", who):
            return [], f"“{clause}”: who drives is no part of S"
        alike = who in ("", "it", "that", "this", "one", "just one", "only one", "a single one")
        rest = _behind(clause[named[0].end : match.end("what")], match.groupdict().get("rest"))
        component = _akin(kind, structure) if alike else refer(who.split(" and ")[0] if plural else who, structure)
        definite = clause[: named[0].start].endswith("the ") and not alike
        itself = definite and component is refer(f"the {clause[named[0].start : named[0].end]}", structure)
        if component is None or itself and spec_of(component).type == kind:
            return None
        if component.id == "E":
            if kind not in VEHICLES:
                return None
            typed: list[Edit] = [
                SetField(component="E", path="type", value=kind),
                SetField(component="E", path="model", value=None),
            ]
            more, said = _rest(rest, "ego", typed, structure)
            return [*typed, *more], "; ".join([f"ego is a {kind.replace('_', ' ')}", *said])
        edits: list[Edit] = [SetSpec(component=component.id, spec=_typed(spec_of(component), kind))]
        count = count_of(match["what"], spec_of(component).count) if plural else 1
        if count != spec_of(component).count:
            edits.append(SetField(component=component.id, path="count", value=count))
        noun, called = kind.replace("_", " "), named[0].data.get("noun") or kind
        alike = called != noun and len(edits) == 1 and _typed(spec_of(component), kind) == spec_of(component)
        if alike and not match.groupdict().get("rest") and not re.search(table["at_rest"], match["what"]):
            return [], f"{ALREADY}: “{called}” is the type {noun} in S, which {name_of(component)} has"
        what = f"{count} {language.plurals(noun)[0]}" if count > 1 else f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"
        _besides(who, component, structure)
        if re.search(table["at_rest"], match["what"]):
            edits += [
                SetField(component=component.id, path="speed", value=0.0),
                SetField(component=component.id, path="phases", value=(Phase(action="stationary"),)),
            ]
        more, said = _rest(rest, component.id.lower(), edits, structure)
        return [*edits, *more], "; ".join([f"{component.id} is now {what}", *said])
    return None


def _behind(what: str, rest: str | None) -> str | None:
    """What is said of the new one behind its noun: "a pallet 200 m ahead in the left lane"."""
    place = re.match(r" (?:\d[\d.]* ?(?:m|metres|meters)\b|(?:on|in|at|behind|beside|ahead of) ).*", what)
    return f"{place[0].strip()}{rest or ''}" if place else rest


def _besides(who: str, component: Component, structure: Structure) -> Component | None:
    """The second one of "the tractor and the car", both of whom become one."""
    joined = re.match(r"(?P<one>.+?) and (?P<other>.+)$", who)
    other = refer(joined["other"], structure, alone=False) if joined else None
    return other if other is not None and other.id not in ("E", component.id) else None


def _rest(rest: str | None, who: str, edits: list[Edit], structure: Structure) -> tuple[list[Edit], list[str]]:
    """What is said of the new one besides its type: "a police car with 60 km/h", "a child running"."""
    from c2s_engine.interpret.changes.refine import edits_of

    if not rest:
        return [], []
    for edit in edits:
        structure = apply(structure, edit)
    table = language.table("refine")
    rest = re.sub(table["with_it"], "", rest.strip(" ,"))
    verb = "is " if re.match(r"\w+ing\b|\d[\d.]* ?m", rest) else "comes " if rest.startswith("from") else ""
    return edits_of(f"{who} {verb}{re.sub(r'^(?:that|which|who) ', '', rest)}", structure) if rest else ([], [])


def _akin(kind: str, structure: Structure) -> Component | None:
    """The object that most likely is replaced: of the same type, else of the same sort, else the only one."""
    same = objects_of(structure, kind)
    if same:
        return same[0]
    persons = ("pedestrian", "child", "animal", "bicycle")
    sort = [c for c in structure.objects if (spec_of(c).type in persons) == (kind in persons)]
    pick = sort or list(structure.objects)
    return pick[0] if pick else None


def _typed(spec: ObjectSpec, kind: str) -> ObjectSpec:
    """The spec with another type; actions and places that the new type cannot do become their like."""
    walks = kind in ("pedestrian", "child", "animal")
    walked = spec.type in ("pedestrian", "child", "animal")
    update: dict[str, Any] = {"type": kind, "model": None}
    thing = spec.type not in VEHICLES and spec.name.replace("_", " ") in language.actor_nouns()
    if thing or spec.name == spec.type or spec.name in language.actor_nouns():
        update["name"] = kind
    if walks != walked:
        turned = (
            {"cross_road": "enter_road", "move_along": "keep_lane"}
            if walked
            else {
                "enter_road": "cross_road",
                "keep_lane": "move_along",
                "cut_in": "cross_road",
                "go_straight": "cross_road",
            }
        )
        keep = {"stationary", "wait", "stop", "start", "collide", "move_along", "cross_road"}
        phases = tuple(
            p.model_copy(update={"action": turned.get(p.action, p.action)})
            for p in spec.phases
            if p.action in turned or p.action in keep
        )
        if kind == "bicycle":
            phases = spec.phases
        update["phases"] = phases
        speeds = language.table("defaults")["types"]
        update["speed"] = float(speeds.get(kind, {"value": 8.0})["value"]) if spec.speed is not None else None
    return spec.model_copy(update=update)
