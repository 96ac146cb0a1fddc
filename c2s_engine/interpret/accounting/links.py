"""What in the text each field of S rests on."""

from c2s_engine.interpret import language
from c2s_engine.interpret.composing.run_limits import limits_of
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.components import Component, Link, Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec


def linked(scene: Scene, structure: Structure) -> Structure:
    """S, each component with the words that its fields rest on; whom it names comes first."""
    for entity, cid in owners(scene, structure).items():
        component = structure[cid]
        links = [_link(scene, (m.start, m.end)) for m in entity.mentions]
        links += [_of_event(scene, component, e) for e in scene.clauses.events if _tells_of(scene, entity, e)]
        if (speed := scene.speeds.get(entity)) is not None:
            links.append(_link(scene, (speed[2], speed[3]), "speed"))
        structure = _with(structure, cid, links)
    settings = scene.settings
    single = {"time": settings.time, "map": settings.map, "preset": settings.preset}
    found = [_link(scene, f.span, "weather") for f in settings.weather]
    found += [_link(scene, f.span, name) for name, f in single.items() if f]
    found += [_link(scene, f.span, "light") for f in scene.light if structure.settings.spec.light is not None]
    structure = _with(structure, "G", found)
    if settings.ego_model:
        structure = _with(structure, "E", [_link(scene, settings.ego_model.span, "model")])
    named = PlaceSpec.model_fields
    place = [_link(scene, s, name if name in named else "") for name, s in scene.road.spans.items()]
    structure = _with(structure, "R", place)
    bounds = [_link(scene, told.span, f"limits.{i}") for i, (told, _) in enumerate(limits_of(scene, scene.ids))]
    return _with(structure, "T", bounds + [_link(scene, s, "terminate_when") for s in scene.endings])


def owners(scene: Scene, structure: Structure) -> dict[Entity, str]:
    """Whom of the scene each component stands for."""
    ids = {e: "E" if cid == "ego" else cid for e, cid in scene.ids.items()}
    return {e: cid for e, cid in ids.items() if cid in structure}


def _tells_of(scene: Scene, entity: Entity, event: Event) -> bool:
    """Whether it is something that the entity does, or is said not to do."""
    mine = event.agent is entity or entity in event.also and event.patient is not entity
    return mine and (event.done or event.mode == "negated")


def _of_event(scene: Scene, component: Component, event: Event) -> Link:
    word = scene.words[event.word]
    field = "" if event.mode == "negated" else field_of(component, event.act)
    return _link(scene, (word.start, word.end), field)


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
