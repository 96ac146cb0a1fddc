"""What in the text each field of S rests on."""

import math
from collections.abc import Iterator
from typing import get_args

from c2s_engine.interpret import language
from c2s_engine.interpret.composing.run_limits import limits_of
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.components import Component, Link, Structure
from c2s_engine.structure.leaves import leaves
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec, SettingsSpec
from c2s_engine.structure.vocabulary import Action

STATES = ("travel", "stationary", "keep_lane", "move_along", "go_straight")
"""Acts that a speed or a start says, too."""
VALUES = ("speed", "distance", "time", "acceleration")
"""Dimensions of values that fields hold as they are told."""


def linked(scene: Scene, structure: Structure) -> Structure:
    """S, each component with the words that its fields rest on; whom it names comes first."""
    for entity, cid in owners(scene, structure).items():
        component = structure[cid]
        first = "" if cid == "E" else "type"  # that somebody is there
        links = [_link(scene, (m.start, m.end), "" if n else first) for n, m in enumerate(entity.mentions)]
        links += [_of_event(scene, component, e) for e in scene.clauses.events if _is_action_of(scene, entity, e)]
        if (speed := scene.speeds.get(entity)) is not None:
            links.append(_link(scene, (speed[2], speed[3]), "speed"))
        structure = _with(structure, cid, links)
    settings = scene.settings
    single = {"time": settings.time, "map": settings.map, "preset": settings.preset}
    found = [_link(scene, f.span, "weather") for f in settings.weather]
    found += [_link(scene, f.span, name) for name, f in single.items() if f]
    if isinstance(spec := structure.settings.spec, SettingsSpec) and spec.light is not None:
        found += [_link(scene, f.span, "light") for f in scene.light]
    structure = _with(structure, "G", found)
    if settings.ego_model:
        structure = _with(structure, "E", [_link(scene, settings.ego_model.span, "model")])
    named = PlaceSpec.model_fields
    place = [_link(scene, s, name if name in named else "kind") for name, s in scene.road.spans.items()]
    structure = _with(structure, "R", place)
    bounds = [_link(scene, told.span, f"limits.{i}") for i, (told, _) in enumerate(limits_of(scene, scene.ids))]
    return _with(structure, "T", bounds + [_link(scene, s, "terminate_when") for s in scene.endings])


def owners(scene: Scene, structure: Structure) -> dict[Entity, str]:
    """Whom of the scene each component stands for."""
    ids = {e: "E" if cid == "ego" else cid for e, cid in scene.ids.items()}
    return {e: cid for e, cid in ids.items() if cid in structure}


def _is_action_of(scene: Scene, entity: Entity, event: Event) -> bool:
    """Whether it is something that the entity does, or is said not to do."""
    mine = event.agent is entity or entity in event.also and event.patient is not entity
    return mine and (event.done or event.mode == "negated")


def _of_event(scene: Scene, component: Component, event: Event) -> Link:
    word = scene.words[event.word]
    field = "" if event.mode == "negated" else field_of(component, event.act)
    return _link(scene, (word.start, word.end), field)


def missing_actions(scene: Scene, structure: Structure) -> Iterator[tuple[Event, str]]:
    """What somebody of S does by the text, as an action would say it, and S does not: with the component."""
    acts = language.table("acts")
    turns = getattr(structure.place.spec, "manoeuvre", None) is not None
    for entity, cid in owners(scene, structure).items():
        for event in scene.clauses.events:
            steps = event.act in acts["phases"] or event.act in get_args(Action)
            if not (steps and event.done and _is_action_of(scene, entity, event)) or event.act in STATES:
                continue
            if cid == "E" and turns and event.act in ("turn", "u_turn"):
                continue
            if not field_of(structure[cid], event.act):
                yield event, cid


def unmatched_values(scene: Scene, structure: Structure) -> Iterator[tuple[int, int]]:
    """Where values stand in the text that no field of S has; times also as the way that is driven in them."""
    held = [n for c in structure.components for n in _numbers(c.spec.model_dump())]
    speeds = [n for c in (structure.ego, *structure.objects) for n in _numbers(getattr(c.spec, "speed", None))]
    for span in (s for s in scene.spans if s.kind == "quantity" and s.data["dimension"] in VALUES):
        ends = (span.data["low"], span.data["high"], (span.data["low"] + span.data["high"]) / 2)
        if span.data["dimension"] == "time":
            ends = (*ends, *(end * speed for end in ends for speed in speeds))
        if not any(math.isclose(n, end, rel_tol=0.02, abs_tol=0.06) for n in held for end in ends):
            yield span.start, span.end


def _numbers(value: object) -> list[float]:
    """The numbers in plain data."""
    return [float(n) for n in leaves(value) if isinstance(n, int | float) and not isinstance(n, bool)]


def field_of(component: Component, act: str) -> str:
    """The field of a component that holds an act of the text; empty where none does."""
    spec = component.spec
    if not isinstance(spec, EgoSpec | ObjectSpec):
        return ""
    acts, actions = language.table("acts"), [p.action for p in spec.phases]
    if act in actions:
        return f"phases.{actions.index(act)}"  # type: ignore[arg-type]
    if isinstance(spec, EgoSpec) and spec.reaction in acts["reactions"].get(act, ()):
        return "reaction"
    for i, action in enumerate(actions):
        if action in acts["phases"].get(act, ()):
            return f"phases.{i}"
    return "speed" if act in ("travel", "stationary") and spec.speed is not None else ""


def _link(scene: Scene, span: tuple[int, int], field: str = "") -> Link:
    return Link(kind="text", label=scene.text[span[0] : span[1]], span=span, field=field)


def _with(structure: Structure, cid: str, links: list[Link]) -> Structure:
    component = structure[cid]
    return structure.with_component(component.model_copy(update={"links": (*component.links, *dict.fromkeys(links))}))
