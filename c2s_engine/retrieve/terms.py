"""What a component is about, in the vocabulary's words, and how far what a snippet is about agrees with it."""

from collections.abc import Collection
from typing import get_args

from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.leaves import leaves
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec, RestrictionsSpec

ACTIONS = {*get_args(v.Action), *get_args(v.Reaction)} - {"none"}
TYPES, POSITIONS = set(get_args(v.ObjectType)), set(get_args(v.Position))
PLACES, CONDITIONS = set(get_args(v.PlaceKind)), set(get_args(v.ConditionKind))
DETAILS = ("manoeuvre", "control", "ego_lane")
_RIDERS = {"bicycle"}
_PERSONS = v.ON_FOOT
_GROUPS: tuple[set[str], ...] = (set(v.MOTOR), _RIDERS, set(_PERSONS), TYPES - set(v.VEHICLES) - _PERSONS)
_ALIKE = {"road": {"straight"}, "straight": {"road"}}
"""Kinds of place that do for each other."""
_STANDING = {"parked", "roadside", "partly_in_lane"}
_MANOEUVRES = {"left": "turn_left", "right": "turn_right", "straight": "go_straight", "u_turn": "u_turn"}
_JUNCTION = {"crossing_left", "crossing_right", "opposite_approach"}


def terms_of(structure: Structure, cid: ComponentId) -> tuple[str, ...]:
    """The words for what a component does and is, and where: what its snippets are to be about."""
    spec = structure[cid].spec
    if isinstance(spec, PlaceSpec):
        return (spec.kind, *(f"{field}={getattr(spec, field)}" for field in DETAILS if getattr(spec, field)))
    if isinstance(spec, RestrictionsSpec):
        kinds = [c.kind for c in (*spec.require, *spec.terminate_when)]
        return tuple(dict.fromkeys([*kinds, *(["time"] if spec.duration else [])]))
    if isinstance(spec, ObjectSpec):
        actions = [p.action for p in spec.phases] or _implicit_actions(spec)
        return tuple(dict.fromkeys((spec.type, spec.placement.position, *actions)))
    return _of_ego(spec, structure.place.spec) if isinstance(spec, EgoSpec) else ()


def imported_terms(structure: Structure, cid: ComponentId) -> dict[str, tuple[str, ...]]:
    """Those of them that the spec of an imported component was read to say, as a snippet's head has them by field."""
    spec = structure[cid].spec
    said = {*leaves(spec.model_dump(exclude_defaults=True, exclude={"component"})), getattr(spec, "type", "")}
    said |= {*_MANOEUVRES.values()} if cid == "E" else set()
    found: dict[str, list[str]] = {}
    for term in terms_of(structure, cid):
        detail, _, word = term.rpartition("=")
        if word in said:
            found.setdefault(f"{detail}s" if detail else _section(word, cid[0]), []).append(word)
    return {section: tuple(words) for section, words in found.items()}


def _section(word: str, kind: str) -> str:
    """The field of a snippet's head that a word stands in."""
    if kind == "R":
        return "places"
    if kind == "T":
        return "conditions"
    if word in TYPES:
        return "types"
    if kind == "E" and word in get_args(v.Reaction):
        return "reactions"
    return "positions" if word in POSITIONS else "actions"



def _implicit_actions(spec: ObjectSpec) -> list[str]:
    """What an object does of which no phase tells."""
    position = spec.placement.position
    stands = spec.speed == 0 or position in _STANDING and spec.speed is None
    if stands or spec.type in _GROUPS[3]:
        return ["stationary"]
    if spec.type in _PERSONS | _RIDERS:
        return ["move_along"]
    return ["go_straight"] if position in _JUNCTION else ["keep_lane"]


def _of_ego(spec: EgoSpec, place: object) -> tuple[str, ...]:
    actions: list[str] = [p.action for p in spec.phases]
    if isinstance(place, PlaceSpec) and place.kind == "intersection" and place.manoeuvre:
        actions.append(_MANOEUVRES[place.manoeuvre])
    if spec.reaction != "none":
        actions.append(spec.reaction)
    return tuple(dict.fromkeys((spec.type, *(actions or ["keep_lane"]))))


def agreement(component: str, wanted: Collection[str], has: Collection[str]) -> float | None:
    """From 0 (about something else) to 1, by what a component of that kind is told by; None: nothing is known of it."""
    wanted, has = set(wanted), set(has)
    if not has or not wanted:
        return None
    if component == "R":
        return _of_place(wanted, has)
    if component == "T":
        return _shared(wanted & CONDITIONS, has & CONDITIONS)
    done, kind = _shared(wanted & ACTIONS, has & ACTIONS), _kind(wanted & TYPES, has & TYPES)
    if component == "E":
        return done and 0.7 * done + 0.3 * (kind == 1)
    return done and kind and 0.5 * done + 0.2 * kind + 0.3 * bool(wanted & has & POSITIONS)


def _of_place(wanted: set[str], has: set[str]) -> float:
    """By kind, then by what is told of its details: the same is better than nothing, nothing better than another."""
    kind = 1.0 if wanted & has & PLACES else 0.6 if any(_ALIKE.get(w, set()) & has for w in wanted) else 0.0
    fits = []
    for told in wanted:
        field, is_detail, _ = told.partition("=")
        if is_detail:
            other = any(h.startswith(f"{field}=") for h in has)
            fits.append(1.0 if told in has else 0.0 if other else 0.5)
    return kind and 0.6 * kind + 0.4 * (sum(fits) / len(fits) if fits else 0.5)


def _shared(one: set[str], other: set[str]) -> float:
    """Twice what is common over what there is."""
    return 2 * len(one & other) / (len(one) + len(other)) if one or other else 0.0


def _kind(wanted: set[str], has: set[str]) -> float:
    """How near the types are: the same, of one group, riders and those who drive or walk; a type untold is a car."""
    wanted, has = wanted or {"car"}, has or {"car"}
    if wanted & has:
        return 1.0
    groups = [{i for i, group in enumerate(_GROUPS) if group & types} for types in (wanted, has)]
    if groups[0] & groups[1]:
        return 0.6
    return 0.2 if 1 in groups[0] | groups[1] and 3 not in groups[0] | groups[1] else 0.0
