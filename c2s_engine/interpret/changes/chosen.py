"""Who of several of one type is meant: by role, by a word of his name, by order."""

import re
from collections.abc import Callable, Sequence

from c2s_engine.interpret import language
from c2s_engine.structure.components import Component
from c2s_engine.structure.specs import ObjectSpec

ORDINALS = {"first": 0, "1st": 0, "second": 1, "2nd": 1, "third": 2, "3rd": 2, "fourth": 3, "last": -1, "final": -1}
ROLES: dict[str, Callable[[ObjectSpec], bool]] = {
    "lead": lambda s: s.placement.position == "ahead",
    "oncoming": lambda s: s.placement.position in ("oncoming_lane", "opposite_approach"),
    "following": lambda s: s.placement.position == "behind" or "follow" in {p.action for p in s.phases},
    "parked": lambda s: s.placement.position == "parked",
    "stationary": lambda s: s.speed == 0 or {p.action for p in s.phases} == {"stationary"},
    "crossing": lambda s: s.placement.position in ("crossing_left", "crossing_right"),
}
"""Who has the role that a noun is told with."""
NOUN_PHRASE = re.compile(r"(?:(?<=\bthe )|(?<=\bthat )|(?<=\bthis ))(?:[\w-]+ ){0,3}$|(?:[\w-]+ ){0,2}$")
"""What stands before a noun and belongs to it."""
PLAIN = frozenset(("the", "a", "an", "of", "car", "vehicle", "pedestrian", "other", *ORDINALS))
"""Words that tell nobody from others of his type."""
ARTICLES = frozenset(("the", "a", "an", "another", "this", "that"))


def chosen(before: str, noun: str, roles: Sequence[str], found: list[Component], text: str = "") -> Component | None:
    """The one of `found` whom a noun with what stands before it means; None where there are not so many. `text`: the
    one that S was read from."""
    found = in_role(roles, found)
    words = re.findall(r"[\w-]+", NOUN_PHRASE.search(before)[0])  # type: ignore[index]
    if len(found) > 1:
        found = _called(words, noun, found, text)
    for word in words:
        if word in ORDINALS:
            index = ORDINALS[word]
            return found[index] if -len(found) <= index < len(found) else None
    return found[0]


def in_role(roles: Sequence[str], found: list[Component]) -> list[Component]:
    """Those of `found` who have the roles that a noun is told with; all where none has them."""
    for role in roles:
        found = [c for c in found if role in ROLES and ROLES[role](_spec(c))] or found
    return found


def called(component: Component, text: str = "") -> set[str]:
    """The words by which the text and the program call somebody, with what stands before the noun there."""
    links = [link for link in component.links if link.kind == "text"]
    before = [NOUN_PHRASE.search(text[: li.span[0]].lower()) for li in links if li.span and li.field == "type"]
    told = [*(link.label for link in links), *(match[0] for match in before if match)]
    words = re.findall(r"[a-z0-9]+", " ".join([_spec(component).name.replace("_", " "), *told]).lower())
    return set(words) - ARTICLES


def matching_modifiers(before: str, found: list[Component], text: str) -> list[Component]:
    """Those of several whom what stands before a noun tells from the others, by the text that S was read from; all of
    them where it says nothing, none where it is of nobody."""
    words = set(re.findall(r"[\w-]+", NOUN_PHRASE.search(before)[0])) - {*PLAIN, *ARTICLES, *ROLES}  # type: ignore[index]
    return [c for c in found if words & called(c, text)] if words else found


def _called(words: list[str], noun: str, found: list[Component], text: str) -> list[Component]:
    """Those whom the noun and the words before it fit best: "the red car", "the taxi", "the lady" of a woman."""
    said = {*noun.split(), *words} - PLAIN
    alike = {w for group in language.table("people")["nouns"].values() if said & set(group) for w in group}
    fits = [len(called(c, text) & (said | alike)) for c in found]
    return [c for c, fit in zip(found, fits, strict=True) if fit == max(fits)]


def _spec(component: Component) -> ObjectSpec:
    assert isinstance(component.spec, ObjectSpec)
    return component.spec
