"""Which road user of the text each object of the learned reader's S is: the best assignment by type, deeds, speed and
order. An object that no mention of the text can be has none."""

import numpy as np
from scipy.optimize import linear_sum_assignment

from c2s_engine.interpret.accounting.links import STATES, field_of
from c2s_engine.interpret.entities import Entity, fits
from c2s_engine.interpret.llm.words import family
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import ends
from c2s_engine.structure.specs import ObjectSpec

NEVER = -100.0
"""The score of two that cannot be the same."""
SAME, FITS, KIN = 3.0, 2.0, 1.0
"""Scores of the same type, of a noun that can mean the type, of the same family of types."""
DEED, SPEED, KEPT, COUNT, ORDER = 0.5, 0.5, 0.4, 0.3, 0.4
"""What counts besides: a deed, a speed, that the interpreter keeps the road user, the number, the order in the text."""


def grounded(scene: Scene, structure: Structure) -> dict[Entity, str]:
    """The road users of a scene with the ids of the components of S that stand for them; ego is "ego"."""
    entities = [e for e in scene.cast.entities if e.mentions and not e.ego]
    entities.sort(key=lambda e: e.mentions[0].start)
    found = {scene.cast.ego: "ego"}
    if not entities or not structure.objects:
        return found
    scores = np.array([
        [_likeness(scene, e, o, abs(i / len(entities) - j / len(structure.objects))) for j, e in enumerate(entities)]
        for i, o in enumerate(structure.objects)
    ])  # fmt: skip
    rows, columns = linear_sum_assignment(scores, maximize=True)
    for i, j in zip(rows, columns, strict=True):
        if scores[i, j] > NEVER / 2:
            found[entities[j]] = structure.objects[i].id
    return found


def _likeness(scene: Scene, entity: Entity, component: Component, apart: float) -> float:
    """How like a road user is to an object; `apart`: how far from each other they come, as a share of all."""
    spec = component.spec
    assert isinstance(spec, ObjectSpec)
    if entity.type == spec.type:
        score = SAME
    elif fits(entity, spec.type):
        score = FITS
    elif family(entity.type) == family(spec.type):
        score = KIN
    else:
        return NEVER
    acts = {e.act for e in scene.events(entity)} - set(STATES)
    score += DEED * sum(1 for act in acts if field_of(component, act))
    told, held = scene.speeds.get(entity), ends(spec.speed)
    if told is not None and held is not None:
        score += SPEED * (held[0] <= told[1] + 0.1 and told[0] - 0.1 <= held[1])
    return score + KEPT * (entity in scene.actors) + COUNT * (entity.count == spec.count) - ORDER * apart
