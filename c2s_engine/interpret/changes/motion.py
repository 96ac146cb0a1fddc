"""Changes of where somebody is and how ego reacts: distance, side, reaction."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, base_of, from_to, name_of, quantity_of, value_of
from c2s_engine.interpret.changes.in_words import in_words
from c2s_engine.interpret.changes.phases import afterwards, awaited
from c2s_engine.interpret.changes.refer import actions_named, doing, refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.surroundings import environment
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField, SetSpec
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement


def _table() -> dict[str, Any]:
    found: dict[str, Any] = language.table("refine")
    return found


def distance(clause: str, structure: Structure) -> Found | None:
    """ "20 m further away", "10 m closer", "at 30 m", "set the gap to 40 m", "twice as far"."""
    told = re.sub(_table()["told"]["meanwhile"], " ", clause)
    quantity = quantity_of(told, "distance")
    relative, wider = _factor(clause, "further"), _factor(clause, "wider")
    if quantity is None and (
        relative is None or not re.search(r"away|clos|near|furth|gap|distance|far|ahead|behind", clause)
    ):
        return None
    component = refer(clause, structure)
    if component is not None and component.id == "E":
        component = refer(re.sub(r"\bego\b", " ", clause), structure, alone=False)
    if component is None or component.id == "E":
        component = next(iter(structure.objects), None)
    component = _placed_from(component, _named_too(clause, component, structure)) if component is not None else None
    if component is None:
        return None
    spec = spec_of(component)
    between = re.search(r"\bbetween (?:the |each |them\b|one )|\bapart\b|\bin between\b", clause)
    if between and spec.count > 1 and quantity is not None:
        edit = SetField(component=component.id, path="spacing", value=value_of(quantity))
        return [edit], f"{name_of(component)}: {quantity['low']:g} m between them"
    if quantity is not None and not re.search(_table()["so_much_further"], clause):
        relative = wider = None  # a distance to have, not one more or less
    factor = _by_a_share(clause, relative or wider)
    if quantity is not None and factor is None:
        value = value_of(quantity)
        words = f"gap {value if isinstance(value, list) else f'{value:g}'} m"
    else:
        base = base_of(component, "placement.gap", 25.0)
        times = factor or 1.0
        more = base[0] * times if quantity is None else base[0] + quantity["low"] * (1 if times > 1 else -1)
        value = round(max(2.0, more), 1)
        words = from_to("gap", base, value, "m")
    edit = SetField(component=component.id, path="placement.gap", value=value)
    return [edit], f"{name_of(component)}: {words}"


def _named_too(clause: str, component: Component, structure: Structure) -> Component | None:
    """The other object that a clause names, where it names one."""
    named = [refer(clause[s.start : s.end], structure, alone=False) for s in scan.names(clause) if s.kind == "actor"]
    return next((n for n in named if n is not None and n.id not in ("E", component.id)), None)


def _placed_from(component: Component, other: Component | None) -> Component | None:
    """Whose gap a distance between two is; None where neither is placed by the other: then it is read as a place."""
    if other is None or spec_of(component).placement.of == other.id:
        return component
    return other if spec_of(other).placement.of == component.id else None


def is_relative(clause: str) -> bool:
    """Whether a distance is told by how much more or less it is to be."""
    return bool(re.search(_table()["so_much_further"], clause)) or _factor(clause, "further") is not None


def _factor(clause: str, rows: str) -> float | None:
    """What a distance is multiplied by where it is to be another one: "make the gap bigger", "twice as far"."""
    found = [(m.start(), factor) for pattern, factor in _table()[rows] if (m := re.search(pattern, clause))]
    return min(found)[1] if found else None


def _by_a_share(clause: str, factor: float | None) -> float | None:
    """The factor where it is told by how much of it a distance changes: "10 % more distance", "by a third"."""
    pace = _table()["pace"]
    share = next((s for pattern, s in pace["parts"] if re.search(pattern, clause)), None)
    if factor is None or share is None or share >= 1 > factor:
        return factor
    return 1 + share if factor > 1 else 1 - share


MIRROR = {
    "left": {"right_lane": "left_lane", "crossing_right": "crossing_left"},
    "right": {"left_lane": "right_lane", "crossing_left": "crossing_right"},
}


def sides(clause: str, structure: Structure) -> Found | None:
    """ "Start from the left", "the pedestrian comes from the right", "on the other side"."""
    match = re.search(
        r"\b(?:from|on|to|at|in)(?: the| its)? (left|right|other|opposite)(?:-hand)?(?: side| lane| hand)?\b", clause
    )
    if not match:
        return None
    component = refer(clause, structure)
    if component is None or not isinstance(component.spec, ObjectSpec):
        return None
    spec = component.spec
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
    turned = side != now
    phases = tuple(p.model_copy(update={"side": OPPOSITE[p.side]}) if p.side and turned else p for p in spec.phases)
    changed = spec.model_copy(
        update={"placement": Placement.model_validate(place.model_dump() | update), "phases": phases}
    )
    return [SetSpec(component=component.id, spec=changed)], f"{name_of(component)} on the {side}"


def reaction(clause: str, structure: Structure) -> Found | None:
    """ "Ego does not brake", "ego swerves": how ego reacts."""
    if only := re.search(_table()["reacts_to"], clause):
        return _reacting_to(only["whom"], structure)
    body = re.sub(r"^(?:let|have|make)\s+", "", clause)
    body = re.sub(r"\b(should|shall|must|has to|is to|will|now|instead)\b ?", "", body).strip()
    component = refer(body, structure)
    if component is None:
        return None
    if component.id == "E":
        if re.search(
            r"(not|n't|never|without) (brak|react|stop|swerv|evad|yield|giv\w+ way)|no reaction|ignores", clause
        ):
            return [
                SetField(component="E", path="reaction", value="none"),
                SetField(component="E", path="hard", value=False),
            ], "ego does not react"
        evades = re.search(r"evade|swerve|steer|avoid|change lane|lane change", body)
        if evades:
            return [SetField(component="E", path="reaction", value="evade")], "ego evades"
        if re.search(r"\bbrak|\bstop", body):
            hard = bool(re.search(r"hard|emergency|sharply|suddenly|full", body))
            return [
                SetField(component="E", path="reaction", value="brake"),
                SetField(component="E", path="hard", value=hard),
            ], f"ego brakes{' hard' if hard else ''}"
    return None


def _reacting_to(whom: str, structure: Structure) -> Found | None:
    """To whom ego reacts; it brakes for him where it did not react."""
    other, ego = refer(whom, structure, alone=False), structure.ego.spec
    if other is None:
        return None
    edits: list[Edit] = [SetField(component="E", path="react_to", value=other.id)]
    if isinstance(ego, EgoSpec) and ego.reaction == "none":
        edits.append(SetField(component="E", path="reaction", value="brake"))
    return edits, f"ego reacts to {name_of(other)}"


def rate(clause: str, structure: Structure) -> Found | None:
    """ "Brake rate 8 m/s2", "make the car brake harder": how hard somebody does what he does."""
    table = _table()["rates"]
    wanted = quantity_of(clause, "acceleration")
    change = next((f for pattern, f in table["factors"] if re.search(pattern, clause)), None)
    actions = next((a for pattern, a in table["actions"] if re.search(pattern, clause)), ())
    weather = environment.weather(clause, [(0, len(clause))])
    if not actions and not scan.names(clause) and not weather:
        actions = table["actions"][0][1]
    if not actions or wanted is None and change is None:
        return None
    if re.search(r"\b(?:when|once|as soon as|if|until)\b", clause):
        return None  # it says when, too
    doing = [c for c in (structure.ego, *structure.objects) if any(p.action in actions for p in _phases(c))]
    named = refer(clause, structure, alone=False)
    component = named if named in doing else doing[0] if doing and named is None else None
    if component is None:
        return None
    goal = quantity_of(clause, "speed") if re.search(r"\bto (?:about |around )?\d", clause) else None
    reached: dict[str, Any] = {"speed": value_of(goal)} if goal else {}
    usual = float(language.table("defaults")["rates"]["soft"]["value"])
    phases, words = [], ""
    for number, phase in enumerate(_phases(component)):
        if phase.action in actions:
            base = base_of(component, f"phases.{number}.rate", usual)
            value = value_of(wanted) if wanted else round(min(9.0, max(0.5, base[0] * (change or 1.0))), 2)
            said = f"{middle(value):.1f} m/s2" if wanted else from_to("rate", base, value, "m/s2")
            words = words or said
            phase = phase.model_copy(update={"rate": value, **reached})
        phases.append(phase)
    edit = SetField(component=component.id, path="phases", value=tuple(phases))
    return [edit], f"{name_of(component)}: {words}"


def _phases(component: Component) -> tuple[Phase, ...]:
    return component.spec.phases if isinstance(component.spec, EgoSpec | ObjectSpec) else ()


def begun_by(clause: str, structure: Structure) -> Found | None:
    """ "Ego brakes when the BMW cuts in": what somebody does for his pace begins when another does what S says."""
    if re.search(_table()["told"]["denies"], clause) or quantity_of(clause, "distance") or quantity_of(clause, "speed"):
        return None
    waited = awaited(clause, structure)
    if waited is None or waited.kind != "action" or waited.action is None:
        return None
    then = afterwards(clause, structure)
    main = then[0] if then else " ".join(re.sub(_table()["told"]["meanwhile"], " ", clause).split())
    moment = clause.replace(main, " ")
    who = refer(main, structure, alone=False)
    other = structure["E" if waited.of == "ego" or not waited.of else waited.of]
    if who is None or who.id == other.id or not doing(moment, (waited.action,)):
        return None
    if waited.action not in {p.action for p in _phases(other)}:
        return None
    act = next((a for a in actions_named(main) if a in ("brake", "stop", "accelerate")), None)
    if act is None:
        return None
    hard = float(language.table("defaults")["rates"]["hard"]["value"]) if re.search(r"\bhard\b", main) else None
    phases = list(_phases(who))
    at = next((i for i, p in enumerate(phases) if p.action == act), None)
    if at is None:
        phases.append(Phase(action=act, trigger=waited, rate=hard))
    else:
        phases[at] = phases[at].model_copy(update={"trigger": waited, **({"rate": hard} if hard else {})})
    edits: list[Edit] = [SetField(component=who.id, path="phases", value=tuple(phases))]
    return edits, in_words(edits, structure)
