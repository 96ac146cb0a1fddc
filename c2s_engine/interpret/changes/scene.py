"""Changes of the scene itself: settings, road, length."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, quantity_of, value_of
from c2s_engine.interpret.changes.refer import doing, refer, spec_of
from c2s_engine.interpret.reading import amounts, scan
from c2s_engine.interpret.surroundings import environment
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import Edit, SetField, SetSpec
from c2s_engine.structure.quantity import in_words
from c2s_engine.structure.specs import Condition, LightChange, PlaceSpec, RestrictionsSpec, SettingsSpec, Trigger


def setting(clause: str, structure: Structure) -> Found | None:
    """ "At night", "in heavy rain", "add fog", "in Town03", "the light is red"."""
    edits: list[Edit] = []
    said = []
    _told, clause = clause, _instead(clause)
    whole = [(0, len(clause))]
    named = environment.named(clause)
    if "map" in named:
        edits.append(SetField(component="G", path="map", value=named["map"].value))
        said.append(named["map"].value)
    sky, time, light = (
        environment.weather(clause, whole),
        environment.time_of_day(clause, whole),
        environment.light(clause, whole),
    )
    if re.search(language.table("refine")["fair"], clause) and not sky:
        sky = [environment.Found("clear", 0.9, (0, 1))]
    if len(scan.names(clause)) > 1 or (scan.names(clause) and not light):
        sky, time = [], None
    if sky and "preset" not in named:
        values = [f.value for f in sky]
        old = [w for w in structure.settings.spec.weather if w != "clear"]  # type: ignore[union-attr]
        also = re.search(r"\b(add|also|plus|as well|too)\b|^and\b", clause)
        if re.search(language.table("refine")["weaker"], clause):
            values = list(dict.fromkeys("rain" if v == "heavy_rain" else v for v in values))
        elif "heavy_rain" in old:
            values = ["heavy_rain" if v == "rain" else v for v in values]
        rains = language.table("refine")["rains"]
        old = [w for w in old if not (w in rains and set(values) & set(rains))]
        new = ["clear"] if values == ["clear"] else list(dict.fromkeys([*(old if also else []), *values]))
        edits.append(SetField(component="G", path="weather", value=new))
        said.append(", ".join(w.replace("_", " ") for w in new))
    if time is not None and "preset" not in named:
        edits.append(SetField(component="G", path="time", value=time.value))
        said.append(time.value)
    if light and structure.place.spec.kind == "intersection":  # type: ignore[union-attr]
        moment = quantity_of(clause, "time") if not re.search(r"\bbefore\b", clause) else None
        changed, words = _light(light[0].value, moment, structure)
        edits += changed
        said.append(f"ego's light {words}")
    return (edits, "; ".join(said)) if edits else None


def _light(shown: str, moment: dict[str, Any] | None, structure: Structure) -> tuple[list[Edit], str]:
    """Edits by which ego's light shows that, at first or from a moment on (s), and what they do."""
    spec = structure.settings.spec
    assert isinstance(spec, SettingsSpec)
    if moment is None:
        return [SetField(component="G", path="light", value=shown)], shown
    change = LightChange(to=shown, when=Trigger(kind="time", value=value_of(moment)))  # type: ignore[arg-type]
    edits: list[Edit] = [SetField(component="G", path="light_changes", value=(change,))]
    before = spec.light if spec.light not in (None, shown) else "green" if shown != "green" else "red"
    if before != spec.light:
        edits.append(SetField(component="G", path="light", value=before))
    return edits, f"{before}, then {shown} after {in_words('duration', change.when.value or 0.0)}"


def _instead(clause: str) -> str:
    """The clause without what is given up: the rain of "replace the rain by fog", "fog instead of rain"."""
    for pattern in language.table("refine")["given_up"]:
        if match := re.match(pattern, clause):
            return match["new"]
    return clause


def road(clause: str, structure: Structure) -> Found | None:
    """ "On a motorway", "at a T-junction with traffic lights", "three lanes", "in a left bend", "limit 50 km/h"."""
    from c2s_engine.interpret.surroundings import place

    if re.search(r"\bo\d\b", clause):
        return None
    named = [s for s in scan.names(clause) if not re.match(r" (?:lights?|signals?)\b", clause[s.end :])]
    if named and not re.search(r"^(on|at|in|put it|move it|make it|let it|it )", clause):
        return None
    clause = _instead(clause)
    numbers = amounts.quantities(clause) or amounts.bare_speeds(clause)
    found = place.read(clause, [(0, len(clause))], numbers)
    old = structure.place.spec
    assert isinstance(old, PlaceSpec)
    update: dict[str, Any] = {}
    kind = found.kind or ("crosswalk" if found.crosswalk else None)
    if kind and not (kind == "intersection" and old.kind == "intersection"):
        update["kind"] = kind
        if kind != "intersection":
            update |= {"arms": None, "control": None, "manoeuvre": None}
        else:
            update["manoeuvre"] = old.manoeuvre or "straight"
        if kind == "motorway":
            update |= {"lanes": max(2, old.lanes or 2), "oncoming": None, "crosswalk": None, "sidewalk": None}
        update["curve"] = found.curve if kind == "curve" else None
    if found.arms:
        update["arms"] = found.arms
    if found.control and (kind or old.kind) == "intersection":
        update["control"] = found.control
    lanes = re.search(r"\b(one|two|three|four|[1-4]) lanes?\b(?![ -]chang)", clause)
    if found.lanes or lanes:
        words = {"one": 1, "two": 2, "three": 3, "four": 4}
        update["lanes"] = (words.get(lanes[1]) or int(lanes[1])) if lanes else found.lanes
    if found.speed_limit:
        update["speed_limit"] = round(found.speed_limit, 2)
    update = {k: v for k, v in update.items() if getattr(old, k) != v}
    if not update:
        return None
    return [
        SetSpec(component="R", spec=PlaceSpec.model_validate(old.model_dump() | update))
    ], "the place: " + ", ".join(f"{k} {v}" for k, v in update.items() if v is not None)


def own_lane(clause: str, structure: Structure) -> Found | None:
    """ "Put ego in the left lane", "ego should start in the rightmost lane"."""
    match = re.match(language.table("refine")["ego_lane"], clause)
    place = structure.place.spec
    if match is None or not isinstance(place, PlaceSpec):
        return None
    lane = language.table("refine")["ego_lanes"].get(match["lane"], match["lane"])
    update: dict[str, Any] = {"ego_lane": lane, "lanes": max(place.lanes or 0, 3 if lane == "middle" else 2)}
    found: list[Edit] = [SetSpec(component="R", spec=PlaceSpec.model_validate(place.model_dump() | update))]
    words = f"ego in the {lane} lane"
    for other in structure.objects:  # who was in the lane beside ego's, beyond which there is none, is in ego's now
        at = spec_of(other).placement
        if at.of == "ego" and (lane, at.position) in (("rightmost", "right_lane"), ("leftmost", "left_lane")):
            line = "behind" if at.along == "behind" else "ahead"
            now = at.model_copy(update={"position": line, "along": None})
            found.append(SetField(component=other.id, path="placement", value=now))
            words += f", {line} of it {other.id}" if line == "ahead" else f", behind it {other.id}"
    return found, words


def ending(clause: str, structure: Structure) -> Found | None:
    """ "End the run as soon as ego has stopped", "stop the simulation when they collide"."""
    table = language.table("refine")["ends"]
    match = re.match(table["said"], clause)
    if match is None:
        return None
    found = _ended(match["when"], structure)
    if found is None:
        return None  # how long it lasts
    if found is None:
        return [], "a run can end after a time, or when someone stops, acts, comes within a distance or collides"
    condition, words = found
    old = structure.restrictions.spec
    assert isinstance(old, RestrictionsSpec)
    kept = tuple(c for c in old.terminate_when if c.kind != condition.kind)
    return [SetField(component="T", path="terminate_when", value=(*kept, condition))], f"the run ends {words}"


def _ended(when: str, structure: Structure) -> tuple[Condition, str] | None:
    """The condition that ends the run, and how it is told."""
    table = language.table("refine")["ends"]
    if said := re.match(table["stopped"], when):
        subject = _reference(said["who"], structure) or "ego"
        return Condition(kind="stopped", subject=subject), f"when {subject} stands"
    who = refer(when, structure, alone=False)
    acts = [p.action for p in getattr(who.spec, "phases", ()) if doing(when, (p.action,))] if who is not None else []
    if who is None or not acts:
        return None
    name = "ego" if who.id == "E" else who.id
    return Condition(kind="action", subject=name, action=acts[0]), f"when {name} does {acts[0].replace('_', ' ')}"


def _reference(words: str, structure: Structure) -> str | None:
    found = refer(words, structure, alone=False)
    return None if found is None else "ego" if found.id == "E" else found.id


def length(clause: str, structure: Structure) -> Found | None:
    """ "Run for 30 s", "stop after 20 seconds"."""
    quantity = quantity_of(clause, "time")
    if (
        quantity is None
        or not re.search(r"\b(run|last|simulat\w+|duration|end|terminate|stop|length|scenario)\b|^[\d.]+ ?\w+$", clause)
        or scan.names(clause)
    ):
        return None
    value = min(120.0, max(1.0, quantity["high"]))
    return [SetField(component="T", path="duration", value=value)], f"the run lasts {value:g} s"
