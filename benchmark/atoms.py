"""A record's expectations as atoms: single statements, each true or false of one rollout (FORMAT.md)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from c2s_engine.structure.facts import EGO, ObjectFacts, RunFacts

Layer = Literal["RL", "TI", "TM", "DO", "EN"]
LAYERS: tuple[Layer, ...] = ("RL", "TI", "TM", "DO", "EN")
KMH = 3.6
SPEED_LIMIT_TOLERANCE = 2.0  # km/h
UNAVAILABLE_WEATHER = frozenset({"snow"})  # no simulator at hand has it
SLACK = 1e-6

Binding = Mapping[str, Sequence[ObjectFacts]]
"""The objects that stand for each expected actor in one rollout; `ego` for itself."""


@dataclass(frozen=True)
class Atom:
    """One statement. `who` is the actor that it is about (None: the scene); `text` is how it is shown."""

    layer: Layer
    text: str
    kind: str
    value: Any = None
    who: str | None = None
    excluded: str = ""  # why it is not scored


@dataclass(frozen=True)
class Actor:
    """An expected actor with its atoms; the first of them is its presence."""

    name: str
    types: frozenset[str]
    atoms: tuple[Atom, ...]
    count: int = 1
    exactly: bool = False  # the record gives a number that must not be exceeded
    open_ended: bool = False  # {min: N}
    optional: bool = False


@dataclass(frozen=True)
class Expectation:
    """A whole record: what is expected of the scene, of ego and of each actor."""

    scene: tuple[Atom, ...]
    ego: tuple[Atom, ...]
    actors: tuple[Actor, ...]

    @property
    def atoms(self) -> tuple[Atom, ...]:
        return (*self.scene, *self.ego, *(a for actor in self.actors for a in actor.atoms))


def expectation(expect: Mapping[str, Any]) -> Expectation:
    """The atoms of a record's `expect`."""
    ego = expect.get("ego") or {}
    atoms = [Atom("DO", f"ego is a {_words(ego['type'])}", "type", _set(ego["type"]), EGO)] if "type" in ego else []
    atoms += _body(EGO, ego)
    return Expectation(tuple(_scene(expect)), tuple(atoms), tuple(_actor(a) for a in expect.get("actors") or ()))


def _scene(expect: Mapping[str, Any]) -> Iterator[Atom]:
    for key, value in (expect.get("road") or {}).items():
        shown = f"at least {value['min']}" if isinstance(value, dict) else _plain(value)
        yield Atom("RL", f"road {key}: {shown}", key, value["min"] if isinstance(value, dict) else value)
    for thing in expect.get("infrastructure") or ():
        state, kmh = thing.get("state"), thing.get("kmh")
        shown = f" {state}" if state else f" {kmh} km/h" if kmh else ""
        yield Atom("TI", thing["is"] + shown, thing["is"], state or kmh)
    for thing in expect.get("temporary") or ():
        yield Atom("TM", thing["is"], "temporary", thing["is"])
    environment = expect.get("environment") or {}
    for word in sorted(_set(environment.get("weather", []))):
        why = "no simulator at hand has it" if word in UNAVAILABLE_WEATHER else ""
        yield Atom("EN", f"weather {word}", "weather", word, excluded=why)
    if "time" in environment:
        yield Atom("EN", f"time {environment['time']}", "time", environment["time"])


def _actor(actor: Mapping[str, Any]) -> Actor:
    name, count = actor["as"], actor.get("count", 1)
    least = count["min"] if isinstance(count, dict) else count
    types = _set(actor["type"])
    number = "" if "count" not in actor else f"at least {least} " if isinstance(count, dict) else f"{least} "
    atoms = [Atom("DO", f"{name}: {number}{_words(actor['type'])}", "presence", types, name)]
    starts = actor.get("starts") or {}
    of = starts.get("of", EGO)
    for key in [k for k in ("relation", "lane", "gap_m", "hidden_behind") if k in starts]:
        value = starts[key]
        shown = f"{value[0]} to {value[1]}" if isinstance(value, list) else value
        seen_from = f" of {of}" if of != EGO and key != "hidden_behind" else ""
        plain = tuple(value) if isinstance(value, list) else value
        stored = value if key == "hidden_behind" else (plain, of)
        atoms.append(Atom("DO", f"{name}: starts {key}: {shown}{seen_from}", key, stored, name))
    return Actor(
        name,
        types,
        (*atoms, *_body(name, actor)),
        least,
        exactly="count" in actor and not isinstance(count, dict),
        open_ended=isinstance(count, dict),
        optional=bool(actor.get("optional")),
    )


def _body(name: str, thing: Mapping[str, Any]) -> Iterator[Atom]:
    if "speed_kmh" in thing:
        low, high = thing["speed_kmh"]
        yield Atom("DO", f"{name}: speed {low} to {high} km/h", "speed", (low, high), name)
    for event in thing.get("does") or ():
        choices = event["any_of"] if isinstance(event, dict) and "any_of" in event else [event]
        pairs = tuple(next(iter(c.items())) if isinstance(c, dict) else (c, None) for c in choices)
        shown = " or ".join(e if other is None else f"{e} {other}" for e, other in pairs)
        yield Atom("DO", f"{name}: {shown}", "event", pairs, name)


def scene_holds(atom: Atom, facts: RunFacts) -> bool:
    """Whether an atom about the scene holds in a rollout."""
    road, value = facts.road, atom.value
    match atom.kind:
        case "lanes_same_direction":
            return road.lanes_same_direction >= value
        case "intersection":
            return road.intersection != "none" if value == "any" else road.intersection == value
        case "oncoming_lane" | "signalized" | "curve" | "straight":
            return getattr(road, atom.kind) == value
        case "traffic_light":
            return facts.light == value if value else "traffic_light" in facts.infrastructure
        case "speed_limit":
            return any(abs(limit - value) <= SPEED_LIMIT_TOLERANCE + SLACK for limit in facts.speed_limits_kmh)
        case "stop_sign" | "yield_sign" | "crosswalk":
            return atom.kind in facts.infrastructure
        case "temporary":
            return value in facts.temporary
        case "weather":
            return value in facts.weather
        case "time":
            return value in facts.time
    raise ValueError(f"an atom about the scene cannot be a {atom.kind}")


def object_holds(atom: Atom, thing: ObjectFacts, binding: Binding) -> bool:
    """Whether an atom holds of one object, where the named actors are those of `binding`."""
    value = atom.value
    match atom.kind:
        case "presence" | "type":
            return has_type(thing, value)
        case "speed":
            held = thing.held_speed
            return held is not None and value[0] - SLACK <= held * KMH <= value[1] + SLACK
        case "hidden_behind":
            return any(other.name in thing.hidden_behind for other in binding.get(value, ()))
        case "event":
            return any(_shows(thing, event, other, binding) for event, other in value)
    wanted, of = value
    facts = [thing.starts[o.name] for o in binding.get(of, ()) if o.name in thing.starts]
    match atom.kind:
        case "relation":
            return any(wanted in f.relations for f in facts)
        case "lane":
            return any(wanted in f.lanes for f in facts)
        case "gap_m":
            return any(wanted[0] - SLACK <= f.gap <= wanted[1] + SLACK for f in facts)
    raise ValueError(f"an atom about an object cannot be a {atom.kind}")


def has_type(thing: ObjectFacts, types: frozenset[str]) -> bool:
    """Whether an object is of one of those types (`any` is whatever there is)."""
    return "any" in types or not types.isdisjoint(thing.types)


def names(atom: Atom) -> frozenset[str]:
    """The actors other than ego on whose identity an atom depends."""
    if atom.kind == "event":
        found = {other for _, other in atom.value if other}
    elif atom.kind in ("relation", "lane", "gap_m"):
        found = {atom.value[1]}
    else:
        found = {atom.value} if atom.kind == "hidden_behind" else set()
    return frozenset(found - {EGO})


def _shows(thing: ObjectFacts, event: str, other: str | None, binding: Binding) -> bool:
    if other is None:
        return thing.shows(event)
    return any(thing.shows(event, o.name) for o in binding.get(other, ()))


def _set(words: Any) -> frozenset[str]:
    return frozenset(words if isinstance(words, list) else [words])


def _words(words: Any) -> str:
    return " or ".join(words) if isinstance(words, list) else str(words)


def _plain(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
