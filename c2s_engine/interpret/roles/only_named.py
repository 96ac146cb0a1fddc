"""Road users of whom no act and no place is told: whether they are there all the same."""

from c2s_engine.interpret import language
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import VEHICLES, ZONES, Entity

HITS = language.words("contact") | language.words("strikes")
WISHED = language.words("wished_there")


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


def put_there(scene: Scene, entity: Entity) -> bool:
    """Whether one is put into the scene, or told of beside ego's way: "place a car there", "with a dog on the left"."""
    heads = [scene.words[scene.words[m.word].head] for m in entity.mentions if scene.words[m.word].span is not None]
    return any(h.lemma in WISHED for h in heads)


def mentioned_alone(scene: Scene, entity: Entity) -> bool:
    """A thing that is only named ("debris on the road") is there all the same; a vehicle in passing is not."""
    return (
        entity.type in ZONES
        or (not entity.mover and entity.type not in ("obstacle",))
        or any(
            scene.words[m.word].dep in ("ROOT", "attr", "conj", "nsubj", "dep") and scene.words[m.word].span is not None
            for m in entity.mentions
        )
        and (entity.person or entity.type in ("bicycle", "motorcycle"))
        or any(scene.words[m.word].dep == "attr" and scene.words[m.word].span is not None for m in entity.mentions)
        and entity.type in VEHICLES
    )


def imagined(scene: Scene, entity: Entity) -> bool:
    """Whether one is only told of as what would have been: "a cyclist would not have known"."""
    if scene.events(entity) or not entity.mentions:
        return False
    verbs = [scene.words[scene.words[m.word].head] for m in entity.mentions]
    aux = [{scene.words[c].norm for c in v.children if c < v.i} for v in verbs]
    nouns = [scene.words[m.word].dep in ("nsubj", "nsubjpass") for m in entity.mentions]
    struck = any(v.lemma in HITS for v in verbs)
    return all(nouns) and not struck and all(a & {"would", "could", "might"} and "have" in a for a in aux)
