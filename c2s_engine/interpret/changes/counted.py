"""How many there are of those who are told of together: "five parked cars, not three", "one car less in the row"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure

MOST = 8


def numbered(sentence: str, structure: Structure) -> str:
    """A sentence that says how many there are of some who are there, as "make o1 5"; else the sentence itself."""
    groups = [c for c in structure.objects if spec_of(c).count > 1]
    if len(groups) == 1:
        sentence = re.sub(language.table("wordings")["counts"]["them"], "the xs", sentence)
    for component in groups:
        called = _called(sentence, component, structure, alone=len(groups) == 1)
        number = _number(called, spec_of(component).count) if called else None
        if number is not None:
            return f"make {component.id.lower()} {max(1, min(MOST, number))}"
    return sentence.replace("the xs", "they")


def _called(sentence: str, component: Component, structure: Structure, *, alone: bool) -> str | None:
    """The sentence in which they are called "xs"; None where it does not speak of them, or where they are elsewhere."""
    place = spec_of(component).placement
    if any(s != place.side and re.search(rf"\b{s}\b", sentence) for s in ("left", "right") if place.side):
        return None
    plain = sentence
    for span in reversed(scan.names(sentence)):
        if span.kind != "actor" or sentence[span.start : span.end] == "row":
            continue
        meant = refer(f"the {sentence[span.start : span.end]}", structure, alone=False)
        if meant is None or meant.id != component.id:
            return None
        plain = f"{plain[: span.start]}xs{plain[span.end :]}"
    plain = re.sub(rf"\b{component.id.lower()}\b", "xs", plain)
    plain = re.sub(language.table("wordings")["counts"]["placed"], " xs ", plain)
    plain = " ".join(plain.split())
    return plain if "xs" in plain else None


def _number(plain: str, now: int) -> int | None:
    """How many there are to be."""
    for pattern, sort in _patterns():
        if match := pattern.fullmatch(plain.strip(" .!?")):
            said = _value(match["n"])
            return {"set": said, "more": now + said, "less": now - said if said < now else None}[sort]
    return None


def _value(word: str) -> int:
    return int(word) if word.isdigit() else int(language.table("actors")["counts"].get(word, 1))


@cache
def _patterns() -> list[tuple[re.Pattern[str], str]]:
    table = language.table("wordings")["counts"]
    words = table["words"]
    return [(re.compile(language.filled(find, words)), sort) for find, sort in table["says"]]
