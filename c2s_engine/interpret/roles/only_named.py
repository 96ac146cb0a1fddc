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
    return any(h.lemma in WISHED or h.norm == "with" and scene.where(entity).side is not None for h in heads)


def mentioned_alone(scene: Scene, entity: Entity) -> bool:
    """A thing that is only named ("debris on the road") is there all the same; a vehicle in passing is not."""
    return (
        entity.type in ZONES
        or any(scene.clauses.fragment(m.word) for m in entity.mentions)
        and (scene.where(entity).rel is not None or scene.where(entity).lane is not None or entity in scene.speeds)
        or (not entity.mover and entity.type not in ("obstacle",))
        or any(
            scene.words[m.word].dep in ("ROOT", "attr", "conj", "nsubj", "dep") and scene.words[m.word].span is not None
            for m in entity.mentions
        )
        and (entity.person or entity.type in ("bicycle", "motorcycle"))
        or any(scene.words[m.word].dep == "attr" and scene.words[m.word].span is not None for m in entity.mentions)
        and entity.type in VEHICLES
        or any(_joined_to_ego(scene, m.word) or _joined_to_led(scene, m.word) for m in entity.mentions)
        and entity.type in VEHICLES
    )


def _joined_to_led(scene: Scene, i: int) -> bool:
    """Whether it is named with another behind whom ego drives: "ego is driving behind a bus and a taxi"."""
    word = scene.words[i]
    first = scene.cast.of.get(word.head)
    led = (e for e in scene.events(scene.cast.ego) if e.patient is first and e.act in ("follow", "travel", "approach"))
    return word.dep == "conj" and word.span is not None and first is not None and not first.ego and any(led)


def _joined_to_ego(scene: Scene, i: int) -> bool:
    """Whether it is named with ego where no verb follows: "ego and a van on a motorway, both at 110 km/h"."""
    word = scene.words[i]
    first = scene.words[word.head]
    alone = first.dep in ("ROOT", "dep", "npadvmod") or scene.clauses.fragment(first.i)
    return word.dep == "conj" and word.span is not None and scene.cast.of.get(first.i) is scene.cast.ego and alone


def imagined(scene: Scene, entity: Entity) -> bool:
    """Whether one is only told of as what would have been: "a cyclist would not have known"."""
    if scene.events(entity) or not entity.mentions:
        return False
    verbs = [scene.words[scene.words[m.word].head] for m in entity.mentions]
    aux = [{scene.words[c].norm for c in v.children if c < v.i} for v in verbs]
    nouns = [scene.words[m.word].dep in ("nsubj", "nsubjpass") for m in entity.mentions]
    struck = any(v.lemma in HITS for v in verbs)
    return all(nouns) and not struck and all(a & {"would", "could", "might"} and "have" in a for a in aux)
