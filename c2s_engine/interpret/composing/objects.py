"""O1..N: each actor's type, start, speed and phases."""

from dataclasses import dataclass, field

from c2s_engine.interpret import language
from c2s_engine.interpret.composing.changed_speeds import changed
from c2s_engine.interpret.composing.pace import pace_of
from c2s_engine.interpret.composing.phases import phases_of
from c2s_engine.interpret.placing.spacing import without_spacing
from c2s_engine.interpret.placing.start import place_object
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.components import Assumption, Unmet
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec


@dataclass
class Draft:
    """An object on its way to S."""

    entity: Entity | None
    spec: ObjectSpec
    assumed: list[Assumption] = field(default_factory=list)
    unmet: list[Unmet] = field(default_factory=list)


def compose_object(scene: Scene, entity: Entity, ids: dict[Entity, str], place: PlaceSpec, ego: EgoSpec) -> Draft:
    """The object of an entity."""
    assumed: list[Assumption] = []
    kind = "car" if entity.type in ("vehicle",) else "bicycle" if entity.type == "rider" else entity.type
    if entity.type == "vehicle":
        assumed.append(Assumption(field="type", value="car", reason="the text says only that it is a vehicle"))
    placement = place_object(scene, entity, ids, place, ego, assumed)
    placement = without_spacing(placement, None)
    phases = phases_of(scene, entity, ids, placement, place)
    speed = pace_of(scene, entity, kind, phases, ego, placement, assumed, ids[entity])
    phases = changed(scene.events(entity), phases, speed)
    spec = ObjectSpec(
        name=_name(entity),
        type=kind,
        count=min(8, entity.count),
        spacing=None,
        placement=placement,
        speed=speed,
        phases=tuple(phases),  # type: ignore[arg-type]
    )
    return Draft(entity, spec, assumed)


def _name(entity: Entity) -> str:
    if entity.label and entity.label.isdigit():
        return f"v{entity.label}"
    for role in ("lead", "oncoming"):
        if role in entity.roles:
            return role
    noun = entity.noun or entity.type
    known = language.actor_nouns().get(noun)
    if entity.count == 1 and entity.mover and known is not None and known[1]:  # one of several
        noun = noun[:-1] if noun.endswith("s") and noun[:-1] in language.actor_nouns() else entity.type
    return noun.replace("-", " ")
