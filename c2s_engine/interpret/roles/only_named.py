"""Road users of whom no act and no place is told: whether they are there all the same."""

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import VEHICLES, ZONES, Entity


def seen(scene: Scene, entity: Entity) -> bool:
    """Whether a person is the object of seeing ("did not see the child")."""
    return any(
        scene.words[scene.words[m.word].head].lemma
        in (
            "see",
            "notice",
            "detect",
            "spot",
            "observe",
            "recognize",
            "recognise",
            "overlook",
            "perceive",
            "identify",
            "find",
            "encounter",
            "meet",
            "pick",
            "reveal",
            "illuminate",
            "catch",
        )
        for m in entity.mentions
    )


def mentioned_alone(scene: Scene, entity: Entity) -> bool:
    """A thing that is only named ("debris on the road") is there all the same, but for what somebody has with him; a
    vehicle in passing is not."""
    return (
        entity.type in ZONES
        or (not entity.mover and entity.type not in ("obstacle",) and not _had(scene, entity))
        or any(
            scene.words[m.word].dep in ("ROOT", "attr", "conj", "nsubj", "dep") and scene.words[m.word].span is not None
            for m in entity.mentions
        )
        and (entity.person or entity.type in ("bicycle", "motorcycle"))
        or any(scene.words[m.word].dep == "attr" and scene.words[m.word].span is not None for m in entity.mentions)
        and entity.type in VEHICLES
    )


def _had(scene: Scene, entity: Entity) -> bool:
    """Whether a thing is only told of as what somebody has with him ("a man with a suitcase")."""
    words = scene.words
    heads = [words[m.word].head for m in entity.mentions if words[m.word].dep == "pobj"]
    owners = [scene.cast.of.get(words[h].head) for h in heads if words[h].norm == "with"]
    return len(owners) == len(entity.mentions) and all(o is not None and o.mover for o in owners)
