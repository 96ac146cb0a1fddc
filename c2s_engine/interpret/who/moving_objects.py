"""Objects that drive: "the object cuts in", as a tester calls another vehicle."""

from c2s_engine.interpret import language
from c2s_engine.interpret.who.mentions import Cast

DRIVEN = language.words("driven")
CALLED = frozenset(("object", "objects"))


def moving_objects(cast: Cast) -> None:
    """What is called an object and is said to drive is a vehicle."""
    for entity in cast.entities:
        if entity.type == "obstacle" and entity.noun in CALLED and "stationary" not in entity.roles:
            verbs = [cast.words[cast.words[m.word].head] for m in entity.mentions if cast.words[m.word].dep == "nsubj"]
            if any(verb.lemma in DRIVEN for verb in verbs):
                entity.type = "vehicle"
