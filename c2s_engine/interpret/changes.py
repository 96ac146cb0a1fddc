"""The forms of change: each takes one clause and S, and gives edits with words for them, or None where it does not fit."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re
from collections.abc import Callable
from typing import Any

from c2s_engine.interpret import environment, language, scan
from c2s_engine.interpret.refer import objects_of, refer, spec_of
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, Edit, RemoveObject, SetField, SetSpec
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Placement, PlaceSpec

Found = tuple[list[Edit], str]
Form = Callable[[str, Structure], Found | None]
VEHICLES = ("car", "truck", "van", "bus", "police_car", "ambulance", "fire_truck", "motorcycle", "bicycle")
REMOVE = r"^(?:please )?(?:remove|delete|drop|get rid of|take (?:out|away)|without|no more|leave out|scrap|eliminate|no|there (?:is|are) no|stop)\b (?:the |any |all |that |those )?"


def _name(component: Component) -> str:
    return "ego" if component.id == "E" else f"{component.id} ({spec_of(component).name.replace('_', ' ')})"


def _quantity(clause: str, dimension: str) -> dict[str, Any] | None:
    return next(
        (s.data | {"at": s.start, "end": s.end} for s in scan.quantities(clause) if s.data["dimension"] == dimension),
        None,
    )


def _value(quantity: dict[str, Any]) -> Any:
    low, high = round(quantity["low"], 2), round(quantity["high"], 2)
    return low if low == high else [low, high]


def remove(clause: str, structure: Structure) -> Found | None:
    """ "Remove the rain", "without the cyclist", "delete O2"."""
    match = re.match(REMOVE, clause)
    if not match:
        return None
    rest = clause[match.end() :]
    sky = environment.weather(rest, [(0, len(rest))])
    if sky and not scan.names(rest):
        return _without_weather([f.value for f in sky], structure)
    if re.match(r"(traffic )?lights?|signals?$", rest):
        return [SetField(component="R", path="control", value="none")], "no traffic lights"
    if re.match(r"weather", rest):
        return [SetField(component="G", path="weather", value=[])], "clear weather"
    component = refer(rest, structure)
    if component is None or component.id == "E":
        return None
    return [*_release(component, structure), RemoveObject(component=component.id)], f"{_name(component)} removed"


def _without_weather(values: list[str], structure: Structure) -> Found:
    wet = {"rain": {"rain", "heavy_rain", "wet"}, "heavy_rain": {"rain", "heavy_rain", "wet"}}
    gone = set().union(*(wet.get(v, {v}) for v in values))
    left = [w for w in structure.settings.spec.weather if w not in gone]  # type: ignore[union-attr]
    edits: list[Edit] = [SetField(component="G", path="weather", value=left)]
    if structure.settings.spec.preset:  # type: ignore[union-attr]
        edits.append(SetField(component="G", path="preset", value=None))
    return edits, f"no {' or '.join(v.replace('_', ' ') for v in values)}"


def _release(component: Component, structure: Structure) -> list[Edit]:
    """Edits that make the others refer to ego instead of a component that goes."""
    edits: list[Edit] = []
    for other in structure.components:
        if other.id == component.id or not isinstance(other.spec, ObjectSpec | EgoSpec):
            continue
        spec = other.spec
        phases = tuple(
            p.model_copy(
                update={
                    "target": None if p.target == component.id else p.target,
                    "trigger": None if p.trigger and p.trigger.of == component.id else p.trigger,
                }
            )
            for p in spec.phases
            if not (
                p.target == component.id
                and p.action in ("follow", "overtake", "collide", "yield")
                and isinstance(spec, EgoSpec)
            )
        )
        update: dict[str, Any] = {"phases": phases}
        if isinstance(spec, EgoSpec):
            if spec.react_to == component.id:
                update |= {"react_to": None}
        else:
            place = spec.placement
            update["placement"] = place.model_copy(
                update={
                    "of": "ego" if place.of == component.id else place.of,
                    "hidden_by": None if place.hidden_by == component.id else place.hidden_by,
                }
            )
        changed = spec.model_copy(update=update)
        if changed != spec:
            edits.append(SetSpec(component=other.id, spec=changed))
    return edits


def retype(clause: str, structure: Structure) -> Found | None:
    """ "Make the lead a truck", "a bus instead of the van", "two cyclists instead", "replace O1 with a deer"."""
    known = [s for s in scan.names(clause) if s.kind == "actor" and (s.data["type"] not in ("vehicle", "rider"))]
    patterns = (
        r"^(?:make|turn|change|have|let)\s+(?P<who>.+?)\s+(?:in)?(?:to |be )?(?:into |be )?(?P<what>(?:an?|two|three|four|five|\d) [\w -]+)$",
        r"^(?:replace|swap|substitute|exchange)\s+(?P<who>.+?)\s+(?:with|by|for|to)\s+(?P<what>.+)$",
        r"^(?:use |have |make it |put )?(?P<what>(?:an?|two|three|four|five|\d+) [\w -]+?) instead of (?P<who>.+)$",
        r"^(?P<who>(?:the |o\d|ego|it)[\w -]*?) (?:should be|is|becomes|shall be|must be|are|should become|now is) (?P<what>(?:an?|two|three|four) [\w -]+?)(?: now| instead)?$",
        r"^(?:use |have |make it |make that |make them |with |now )?(?P<what>(?:an?|two|three|four|five|six|\d+) [\w -]+?)(?: instead| rather)$",
        r"^(?:make it |make that |make them )(?P<what>(?:an?|two|three|four|five|six|\d+) [\w -]+?)$",
    )
    for pattern in patterns:
        match = re.match(pattern, clause)
        if not match:
            continue
        named = [s for s in known if match.start("what") <= s.start < match.end("what")]
        if not named:
            continue
        kind, plural = named[0].data["type"], named[0].data["plural"]
        who = match.groupdict().get("who")
        component = refer(who, structure) if who else _akin(kind, structure)
        if component is None:
            return None
        if component.id == "E":
            if kind not in VEHICLES:
                return None
            return [
                SetField(component="E", path="type", value=kind),
                SetField(component="E", path="model", value=None),
            ], f"ego is a {kind.replace('_', ' ')}"
        edits: list[Edit] = [SetSpec(component=component.id, spec=_typed(spec_of(component), kind))]
        count = _count(match["what"]) if plural else 1
        if count != spec_of(component).count:
            edits.append(SetField(component=component.id, path="count", value=count))
        return (
            edits,
            f"{component.id} is now {count if count > 1 else 'a'} {kind.replace('_', ' ')}{'s' if count > 1 else ''}",
        )
    return None


def _count(what: str) -> int:
    first = what.split()[0]
    return min(8, int(first) if first.isdigit() else int(language.table("actors")["counts"].get(first, 2)))


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
    if (
        spec.name == spec.type
        or spec.name in language.actor_nouns()
        or spec.name.replace("_", " ") in language.actor_nouns()
    ):
        update["name"] = kind
    if kind not in (*VEHICLES, "pedestrian", "child", "animal"):
        update |= {"phases": (), "speed": None}
    elif walks != walked:
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
        keep = {"stationary", "wait", "stop", "start", "collide"}
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


def speed(clause: str, structure: Structure) -> Found | None:
    """ "Ego at 50 km/h", "the lead drives 20 km/h", "faster", "10 km/h slower", "twice as fast"."""
    quantity = _quantity(clause, "speed")
    relative = re.search(
        r"\b(faster|slower|quicker|speed up|slow(er)? down|twice as fast|half as fast|double|halve)\b", clause
    )
    if quantity is None and not relative or re.search(r"\blimit\b", clause):
        return None
    component = refer(clause, structure, alone=True) or (
        structure.ego if not structure.objects or not re.search(r"\b(it|its)\b", clause) else None
    )
    if component is None:
        return None
    spec: Any = component.spec
    now = spec.speed
    if relative is None and quantity is not None:
        value = _value(quantity)
    else:
        base = middle(now) if now is not None else 10.0
        word = relative[1] if relative else ""
        down = word in ("slower", "half as fast", "halve") or word.startswith("slow")
        if quantity is not None:
            value = base - quantity["low"] if down else base + quantity["low"]
        else:
            value = base * (
                2
                if word in ("twice as fast", "double")
                else 0.5
                if word in ("half as fast", "halve")
                else 0.75
                if down
                else 1.3
            )
        value = round(max(0.5, value), 2)
    edits: list[Edit] = [SetField(component=component.id, path="speed", value=value)]
    shown = value if isinstance(value, float | int) else sum(value) / 2
    return edits, f"{_name(component)} at {shown * 3.6:.0f} km/h"


def distance(clause: str, structure: Structure) -> Found | None:
    """ "20 m further away", "10 m closer", "at 30 m", "set the gap to 40 m", "twice as far"."""
    quantity = _quantity(clause, "distance")
    relative = re.search(
        r"\b(further|farther|more distant|closer|nearer|less|more|twice as far|double the (?:gap|distance)|half the (?:gap|distance))\b",
        clause,
    )
    if quantity is None and (
        relative is None or not re.search(r"away|closer|nearer|gap|distance|far|ahead|behind", clause)
    ):
        return None
    component = refer(clause, structure)
    if component is None or component.id == "E":
        component = _only(structure)
    if component is None:
        return None
    spec = spec_of(component)
    now = spec.placement.gap
    base = middle(now) if now is not None else 25.0
    if relative is None and quantity is not None:
        value: Any = _value(quantity)
    else:
        word = relative[1] if relative else ""
        nearer = word in ("closer", "nearer", "less") or word.startswith("half")
        if quantity is not None:
            value = base - quantity["low"] if nearer else base + quantity["low"]
        else:
            value = base * (
                2
                if word.startswith(("twice", "double"))
                else 0.5
                if word.startswith("half")
                else 0.6
                if nearer
                else 1.6
            )
        value = round(max(2.0, value), 1)
    return [
        SetField(component=component.id, path="placement.gap", value=value)
    ], f"{_name(component)}: gap {value if isinstance(value, list) else f'{value:g}'} m"


def _only(structure: Structure) -> Component | None:
    return structure.objects[0] if structure.objects else None


MIRROR = {
    "left": {"right_lane": "left_lane", "crossing_right": "crossing_left"},
    "right": {"left_lane": "right_lane", "crossing_left": "crossing_right"},
}


def sides(clause: str, structure: Structure) -> Found | None:
    """ "Start from the left", "the pedestrian comes from the right", "on the other side"."""
    match = re.search(
        r"\b(?:from|on|to|at|in)(?: the| its)? (left|right|other|opposite)(?:-hand)?(?: side| lane| hand)?\b", clause
    )
    if not match or re.search(r"\bturn|\bchange", clause):
        return None
    component = refer(clause, structure)
    if component is None or component.id == "E":
        sided = [
            c
            for c in structure.objects
            if spec_of(c).placement.side or spec_of(c).placement.position in (*MIRROR["left"], *MIRROR["right"])
        ]
        component = sided[0] if sided else _only(structure)
    if component is None:
        return None
    spec = spec_of(component)
    place = spec.placement
    now = place.side or ("left" if "left" in place.position else "right" if "right" in place.position else "right")
    side = match[1] if match[1] in ("left", "right") else ("left" if now == "right" else "right")
    update: dict[str, Any] = {"position": MIRROR[side].get(place.position, place.position)}
    if place.side is not None or place.position in (
        "roadside",
        "sidewalk",
        "parked",
        "partly_in_lane",
        "beside",
        "intersection_exit",
    ):
        update["side"] = side
    if update["position"] in ("ahead", "behind"):
        update |= (
            {"position": f"{side}_lane", "along": place.position}
            if spec.type in VEHICLES
            else {"position": "roadside", "side": side}
        )
    swapped = {"left": "right", "right": "left"}
    turned = side != now
    phases = tuple(p.model_copy(update={"side": swapped[p.side]}) if p.side and turned else p for p in spec.phases)
    changed = spec.model_copy(
        update={"placement": Placement.model_validate(place.model_dump() | update), "phases": phases}
    )
    return [SetSpec(component=component.id, spec=changed)], f"{_name(component)} on the {side}"


def setting(clause: str, structure: Structure) -> Found | None:
    """ "At night", "in heavy rain", "add fog", "in Town03", "the light is red"."""
    edits: list[Edit] = []
    said = []
    whole = [(0, len(clause))]
    named = environment.named(clause)
    if "map" in named:
        edits.append(SetField(component="G", path="map", value=named["map"].value))
        said.append(named["map"].value)
    if "preset" in named:
        edits.append(SetField(component="G", path="preset", value=named["preset"].value))
        said.append(named["preset"].value)
    sky, time, light = (
        environment.weather(clause, whole),
        environment.time_of_day(clause, whole),
        environment.light(clause, whole),
    )
    if re.search(r"\b(clear|sunny|dry|fine|nice)\b", clause) and not sky:
        sky = [environment.Found("clear", 0.9, (0, 1))]
    if len(scan.names(clause)) > 1 or (
        scan.names(clause) and not light and not re.search(r"weather|rain|fog|night|day|snow", clause)
    ):
        sky, time = [], None
    if sky and "preset" not in named:
        values = [f.value for f in sky]
        old = [w for w in structure.settings.spec.weather if w != "clear"]  # type: ignore[union-attr]
        also = re.search(r"\b(add|also|and|plus|as well|too)\b", clause)
        new = ["clear"] if values == ["clear"] else list(dict.fromkeys([*(old if also else []), *values]))
        if "heavy_rain" in new and "rain" in new:
            new.remove("rain")
        edits.append(SetField(component="G", path="weather", value=new))
        said.append(", ".join(w.replace("_", " ") for w in new))
    if time is not None and "preset" not in named:
        edits.append(SetField(component="G", path="time", value=time.value))
        said.append(time.value)
    if (sky or time is not None) and structure.settings.spec.preset and "preset" not in named:  # type: ignore[union-attr]
        edits.append(SetField(component="G", path="preset", value=None))
    if light and re.search(r"light|signal|red|green", clause) and structure.place.spec.kind == "intersection":  # type: ignore[union-attr]
        edits.append(SetField(component="G", path="light", value=light[0].value))
        if structure.place.spec.control != "signal":  # type: ignore[union-attr]
            edits.append(SetField(component="R", path="control", value="signal"))
        said.append(f"ego's light {light[0].value}")
    return (edits, "; ".join(said)) if edits else None


def road(clause: str, structure: Structure) -> Found | None:
    """ "On a motorway", "at a T-junction with traffic lights", "three lanes", "in a left bend", "limit 50 km/h"."""
    from c2s_engine.interpret import place

    if len(scan.names(clause)) > 0 and not re.search(r"^(on|at|in|put it|move it|make it|let it|it )", clause):
        return None
    found = place.read(clause, [(0, len(clause))], scan.quantities(clause))
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
    lanes = re.search(r"\b(one|two|three|four|[1-4]) lanes?\b", clause)
    if found.lanes or lanes:
        words = {"one": 1, "two": 2, "three": 3, "four": 4}
        update["lanes"] = found.lanes or words.get(lanes[1]) or int(lanes[1])  # type: ignore[index]
    if found.speed_limit:
        update["speed_limit"] = round(found.speed_limit, 2)
    if found.oncoming is not None:
        update["oncoming"] = found.oncoming
    if found.crosswalk and kind != "crosswalk":
        update["crosswalk"] = True
    turn = re.search(r"\bego (?:should |must |shall )?(?:turns?|goes|go) (left|right|straight)", clause)
    if turn and old.kind == "intersection":
        update["manoeuvre"] = turn[1]
    update = {k: v for k, v in update.items() if getattr(old, k) != v}
    if not update:
        return None
    return [
        SetSpec(component="R", spec=PlaceSpec.model_validate(old.model_dump() | update))
    ], "the place: " + ", ".join(f"{k} {v}" for k, v in update.items() if v is not None)


def more(clause: str, structure: Structure) -> Found | None:
    """ "Add a cyclist on the right", "another car behind ego": what the clause says is read like a scene."""
    match = re.match(
        r"^(?:add|include|insert|introduce|bring in|put(?: in)?|place|there (?:is|are) also|also(?: add)?|plus|and|with|have)\s+(?=(?:an?|another|two|three|four|some|several|more|one more)\b)",
        clause,
    )
    if not match and not re.match(r"^(another|one more)\b", clause):
        return None
    from c2s_engine.interpret.embedded import EmbeddedInterpreter, InterpretError

    rest = re.sub(r"^(one more|more)\b", "another", clause[match.end() :] if match else clause)
    rest = re.sub(r"^another\b", "a", rest)
    sentence = (
        f"There is {rest}." if not re.search(r"\b(that|which|who|crosses|drives|stands|is)\b", rest) else f"{rest}."
    )
    try:
        read = EmbeddedInterpreter().interpret(f"Ego drives along. {sentence}").structure
    except InterpretError:
        return None
    edits: list[Edit] = []
    number = int(structure.next_object_id()[1:])
    for component in read.objects:
        spec = spec_of(component)
        taken = {spec_of(c).name for c in structure.objects}
        name = spec.name if spec.name not in taken else f"{spec.name}_{number}"
        edits.append(
            AddObject(
                spec=spec.model_copy(
                    update={
                        "name": name,
                        "placement": spec.placement.model_copy(update={"of": "ego", "hidden_by": None}),
                    }
                ),
                description=component.description,
                component=f"O{number}",
            )
        )
        number += 1
    return (edits, ", ".join(f"{e.component} added" for e in edits if isinstance(e, AddObject))) if edits else None


def behaviour(clause: str, structure: Structure) -> Found | None:
    """ "The lead should stop", "let the car turn left instead", "ego does not brake", "it runs the red light"."""
    from c2s_engine.interpret.embedded import EmbeddedInterpreter, InterpretError

    body = re.sub(r"^(?:let|have|make)\s+", "", clause)
    body = re.sub(r"\b(should|shall|must|has to|is to|will|now|instead)\b ?", "", body).strip()
    component = refer(body, structure)
    if component is None:
        return None
    if component.id == "E":
        if re.search(r"(not|n't|never|without) (brak|react|stop)|no reaction|ignores", clause):
            return [
                SetField(component="E", path="reaction", value="none"),
                SetField(component="E", path="hard", value=False),
            ], "ego does not react"
        if re.search(r"evade|swerve|steer|avoid|change lane|lane change", body):
            return [SetField(component="E", path="reaction", value="evade")], "ego evades"
        if re.search(r"\bbrak|\bstop", body):
            hard = bool(re.search(r"hard|emergency|sharply|suddenly|full", body))
            return [
                SetField(component="E", path="reaction", value="brake"),
                SetField(component="E", path="hard", value=hard),
            ], f"ego brakes{' hard' if hard else ''}"
        if re.search(r"\bfollow", body):
            return [SetField(component="E", path="reaction", value="follow")], "ego follows"
        if re.search(r"yield|give way|wait", body):
            return [SetField(component="E", path="reaction", value="yield")], "ego yields"
        if (
            turn := re.search(r"\bturns? (left|right)|go(?:es)? (straight)", body)
        ) and structure.place.spec.kind == "intersection":  # type: ignore[union-attr]
            return [SetField(component="R", path="manoeuvre", value=turn[1] or turn[2])], f"ego: {turn[1] or turn[2]}"
        return None
    spec = spec_of(component)
    noun = spec.type.replace("_", " ")
    action = re.sub(
        r"^(the |o\d+\b|it\b|that )?([\w-]+ ){0,2}?(?=\b(brak|stop|turn|cut|chang|swerv|drift|cross|run|walk|accelerat|overtak|revers|stand|stay|wait|go|driv|leav|enter|pull|yield|collid|hit|slow))",
        "",
        body,
    )
    setting_words = "at an intersection with traffic lights " if structure.place.spec.kind == "intersection" else ""  # type: ignore[union-attr]
    try:
        read = (
            EmbeddedInterpreter().interpret(f"Ego drives {setting_words}. The {noun} ahead of ego {action}.").structure
        )
    except InterpretError:
        return None
    same = [c for c in read.objects if spec_of(c).type == spec.type and spec_of(c).phases]
    if not same:
        return None
    phases = spec_of(same[0]).phases
    return [
        SetSpec(component=component.id, spec=spec.model_copy(update={"phases": phases}))
    ], f"{_name(component)}: {', then '.join(p.action.replace('_', ' ') for p in phases)}"


def length(clause: str, structure: Structure) -> Found | None:
    """ "Run for 30 s", "stop after 20 seconds"."""
    quantity = _quantity(clause, "time")
    if (
        quantity is None
        or not re.search(r"\b(run|last|simulate|duration|end|terminate|stop|length|scenario)\b", clause)
        or scan.names(clause)
    ):
        return None
    value = min(120.0, max(1.0, quantity["high"]))
    return [SetField(component="T", path="duration", value=value)], f"the run lasts {value:g} s"


FORMS: tuple[Form, ...] = (length, more, retype, remove, speed, distance, setting, sides, road, behaviour)
