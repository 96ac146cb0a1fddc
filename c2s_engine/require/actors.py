"""Every actor is there, as often and of the kind that S says, and nobody else is."""

from collections.abc import Iterator

from c2s_engine.require.evidence import Evidence
from c2s_engine.require.results import decided, scored
from c2s_engine.require.scene import Scene, vocabulary
from c2s_engine.structure.requirements import Requirement, Result

MADE_OF_PARTS = ("construction_zone", "lane_closure", "debris", "trash")
"""These are built of several props."""


def required(scene: Scene) -> Iterator[Requirement]:
    for actor, spec in scene.actors.items():
        count = getattr(spec, "count", 1)
        often = "once" if count == 1 else f"{count} times"
        types = tuple(vocabulary()["object_types"][str(spec.type)]["types"])
        yield scene.make("actors", "there", actor, "there", f"{scene.named(actor)} is there {often}.", count=count,
                         several=spec.type in MADE_OF_PARTS)  # fmt: skip
        if scene.says(actor, "type"):
            kind = str(spec.type).replace("_", " ")
            yield scene.make("actors", "is_kind", actor, "type", f"{scene.named(actor)} is a {kind}.", types=types,
                             called=kind)  # fmt: skip
    if all(scene.recognised(a) for a in scene.actors):
        text = "There are no road users other than those in S."
        yield scene.make("actors", "nobody_else", "ego", "nobody_else", text, component="R")


def there(requirement: Requirement, evidence: Evidence) -> Result:
    said = int(requirement.values["count"])  # type: ignore[arg-type]
    seen = len(evidence.members(requirement.actor))
    holds = seen >= 1 if requirement.values["several"] else seen == said
    return scored(requirement, 1.0 if holds else -1.0 * max(1, abs(seen - said)), f"{said}", f"{seen}", 0.0)


def is_kind(requirement: Requirement, evidence: Evidence) -> Result:
    types = requirement.values["types"]
    assert isinstance(types, tuple)
    seen = [o.types[0] for o in evidence.members(requirement.actor) if not set(o.types) & set(types)]
    return decided(requirement, not seen, str(requirement.values["called"]), ", ".join(seen) or "as said", 0.0)


def nobody_else(requirement: Requirement, evidence: Evidence) -> Result:
    extra = [o.name for o in evidence.facts.objects if not evidence.components[o.name] and "obstacle" not in o.types]
    return scored(requirement, -float(len(extra)) if extra else 1.0, "nobody else", ", ".join(extra) or "nobody else",
                  0.0)  # fmt: skip


CHECKS = {"there": there, "is_kind": is_kind, "nobody_else": nobody_else}
