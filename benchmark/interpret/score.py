"""Compares S with what a text says: one verdict per expectation, filed under the stage that answers for it."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

from dataclasses import dataclass
from itertools import permutations
from typing import Any

from c2s_bench.interpret import record_terms
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import high, low

STAGES = ("actors", "types", "actions", "order", "relations", "numbers", "environment", "road", "surplus", "turns")


@dataclass(frozen=True)
class Verdict:
    """One expectation: the stage, whether it holds, and in words what it was."""

    stage: str
    holds: bool
    what: str


def judge(structure: Structure, expect: dict[str, Any]) -> list[Verdict]:
    """All verdicts on one text."""
    found: list[Verdict] = []
    place, ego = structure.place.spec, structure.ego.spec
    match = _match(structure, expect.get("actors", []))
    names = {"ego": "ego"} | {a["as"]: c.id for a, c in match if c is not None}
    for actor, component in match:
        if actor.get("optional") and component is None:
            continue
        found += _actor(structure, actor, component, names)
    for event in expect.get("ego", {}).get("does", []):
        found.append(_event(structure, structure.ego, event, names, "ego"))
    speed = expect.get("ego", {}).get("speed_kmh")
    if speed:
        found.append(Verdict("numbers", _within(ego.speed, speed), f"ego speed {speed}"))  # type: ignore[union-attr]
    kind = expect.get("ego", {}).get("type")
    if kind:
        found.append(Verdict("types", bool(record_terms.types_of(ego.type) & set(_list(kind))), f"ego {kind}"))  # type: ignore[union-attr]
    found += _order(structure, expect.get("order", []), names)
    found += _road(structure, place, expect)
    found += _environment(structure, expect.get("environment", {}))
    used = {c.id for _, c in match if c is not None}
    for component in structure.objects:
        if component.id not in used and component.spec.type in record_terms.MOVERS and record_terms._moves(component.spec):  # type: ignore[union-attr,arg-type]
            found.append(Verdict("surplus", False, f"surplus {component.spec.name}"))  # type: ignore[union-attr]
    return found


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


def _within(value: Any, bounds: list[float]) -> bool:
    return value is not None and low(value) * 3.6 >= bounds[0] - 0.5 and high(value) * 3.6 <= bounds[1] + 0.5


def _match(structure: Structure, actors: list[dict[str, Any]]) -> list[tuple[dict[str, Any], Component | None]]:
    """The assignment of expected actors to objects that satisfies most."""
    objects: list[Component | None] = list(structure.objects)
    objects += [None] * len(actors)
    if len(actors) > 5 or len(objects) > 9:
        objects = objects[: 9 if len(actors) <= 4 else 8]
        actors = actors[:5]
    best: tuple[float, tuple[Component | None, ...]] = (-1.0, ())
    for chosen in dict.fromkeys(permutations(objects, len(actors))) if actors else ((),):
        names = {"ego": "ego"} | {a["as"]: c.id for a, c in zip(actors, chosen, strict=True) if c is not None}
        score = sum(v.holds for a, c in zip(actors, chosen, strict=True) for v in _actor(structure, a, c, names))
        if score > best[0]:
            best = (score, chosen)
    return list(zip(actors, best[1], strict=True))


def _actor(
    structure: Structure, actor: dict[str, Any], component: Component | None, names: dict[str, str]
) -> list[Verdict]:
    label = actor["as"]
    found = [Verdict("actors", component is not None, f"{label} is there")]
    spec: Any = component.spec if component is not None else None
    found.append(
        Verdict(
            "types",
            spec is not None and bool(record_terms.types_of(spec.type) & set(_list(actor.get("type", "any")))),
            f"{label} is {actor.get('type')}",
        )
    )
    count = actor.get("count")
    if isinstance(count, int):
        found.append(Verdict("numbers", spec is not None and spec.count == count, f"{label} x {count}"))
    starts = actor.get("starts", {})
    if starts:
        found += _starts(actor, spec, names)
    if actor.get("speed_kmh"):
        found.append(
            Verdict(
                "numbers",
                spec is not None and _within(spec.speed, actor["speed_kmh"]),
                f"{label} speed {actor['speed_kmh']}",
            )
        )
    for event in actor.get("does", []):
        found.append(_event(structure, component, event, names, label))
    return found


def _starts(actor: dict[str, Any], spec: Any, names: dict[str, str]) -> list[Verdict]:
    label, starts = actor["as"], actor["starts"]
    relations, lanes = record_terms.relations_of(spec) if spec is not None else (set(), set())
    of = starts.get("of")
    direct = spec is not None and (
        of is None and spec.placement.of == "ego" or of is not None and spec.placement.of == names.get(of) or of is None
    )
    found = []
    if "relation" in starts:
        group = spec is not None and of is not None and names.get(of) is None
        found.append(
            Verdict(
                "relations",
                bool(direct or group or spec is not None) and starts["relation"] in relations,
                f"{label} {starts['relation']}",
            )
        )
    if "lane" in starts:
        found.append(Verdict("relations", starts["lane"] in lanes, f"{label} lane {starts['lane']}"))
    if "gap_m" in starts and spec is not None and spec.placement.gap is not None:
        a, b = starts["gap_m"]
        found.append(
            Verdict("numbers", low(spec.placement.gap) >= a and high(spec.placement.gap) <= b, f"{label} gap {a}-{b}")
        )
    elif "gap_m" in starts and starts["gap_m"][0] > 10:
        found.append(Verdict("numbers", False, f"{label} gap {starts['gap_m']}"))
    if "hidden_behind" in starts:
        found.append(
            Verdict(
                "relations",
                spec is not None and spec.placement.hidden_by == names.get(starts["hidden_behind"], "?"),
                f"{label} hidden by {starts['hidden_behind']}",
            )
        )
    return found


def _event(structure: Structure, component: Component | None, event: Any, names: dict[str, str], label: str) -> Verdict:
    name, target = (next(iter(event.items()))) if isinstance(event, dict) else (event, None)
    if name == "any_of":
        verdicts = [_event(structure, component, e, names, label) for e in target or ()]
        return Verdict("actions", any(v.holds for v in verdicts), f"{label} any of {target}")
    goal = names.get(target, "?") if target else None
    holds = component is not None and record_terms.shows(component.spec, name, goal, structure.place.spec, structure.ego.spec)  # type: ignore[arg-type]
    return Verdict("actions", holds, f"{label} {name}" + (f" {target}" if target else ""))


def _order(structure: Structure, order: list[list[str]], names: dict[str, str]) -> list[Verdict]:
    """`[who, action, action...]`: the phases in that order."""
    found = []
    for who, *actions in order:
        component = (
            structure.ego if who == "ego" else structure[names[who]] if names.get(who, "") in structure else None
        )
        phases = [p.action for p in component.spec.phases] if component is not None else []  # type: ignore[union-attr]
        at = [phases.index(a) if a in phases else -1 for a in actions]
        found.append(Verdict("order", -1 not in at and at == sorted(at), f"{who}: {' then '.join(actions)}"))
    return found


def _road(structure: Structure, place: Any, expect: dict[str, Any]) -> list[Verdict]:
    road, found = expect.get("road", {}), []

    def add(holds: bool, what: str) -> None:
        found.append(Verdict("road", holds, what))

    if "lanes_same_direction" in road:
        need = road["lanes_same_direction"]["min"]
        add((place.lanes or (3 if place.kind == "motorway" else 1)) >= need, f"lanes {need}")
    if "oncoming_lane" in road:
        add((place.oncoming is True) == road["oncoming_lane"], f"oncoming {road['oncoming_lane']}")
    if "intersection" in road:
        value = road["intersection"]
        is_one = place.kind in ("intersection", "roundabout")
        add(
            {
                "none": not is_one and place.kind != "road",
                "any": is_one,
                "3way": is_one and place.arms == 3,
                "4way": is_one and place.arms == 4,
            }[value],
            f"intersection {value}",
        )
    if "signalized" in road:
        add((place.control == "signal") == road["signalized"], f"signalized {road['signalized']}")
    if road.get("curve"):
        add(place.kind == "curve", "curve")
    if road.get("straight"):
        add(place.kind in ("straight", "motorway"), "straight")
    for item in expect.get("infrastructure", []):
        what = item["is"]
        holds = {
            "traffic_light": place.control == "signal" and ("state" not in item or structure.settings.spec.light == item["state"]),  # type: ignore[union-attr]
            "stop_sign": place.control == "stop" or any(o.spec.type == "stop_sign" for o in structure.objects),  # type: ignore[union-attr]
            "yield_sign": place.control == "yield", "crosswalk": bool(place.crosswalk) or place.kind == "crosswalk",
            "speed_limit": place.speed_limit is not None and abs(place.speed_limit * 3.6 - item.get("kmh", 0)) <= 2,
        }[what]  # fmt: skip
        add(holds, f"{item}")
    for item in expect.get("temporary", []):
        add(item["is"] in record_terms.temporary(structure), f"temporary {item['is']}")
    return found


def _environment(structure: Structure, expect: dict[str, Any]) -> list[Verdict]:
    spec: Any = structure.settings.spec
    sky = spec.weather or ("clear",)
    found = [Verdict("environment", w in sky, f"weather {w}") for w in _list(expect.get("weather", []))]
    if "time" in expect:
        found.append(Verdict("environment", (spec.time or "day") == expect["time"], f"time {expect['time']}"))
    return found
