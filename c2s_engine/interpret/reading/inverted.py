"""Sentences with their subject behind the verb, put in plain order: "out of a driveway backs a car", "coming the other
way was a van"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import past_forms, third_person
from c2s_engine.interpret.reading.rewritten import Replacement

OTHERS = re.compile(
    r"\b(?:its?|their|them|his|him|her|i|we|he|she|they|you|that|which|who|when|while|and|where|because|if|as|after"
    r"|before)\b",
    re.IGNORECASE,
)
"""Words that tell that another subject or clause begins, or that would then mean another."""
GOVERNED = re.compile(
    r"\b(?:of|to|behind|beside|past|towards?|between|alongside|near) (?:the |an? |our |my )?(?:[\w-]+ )?$",
    re.IGNORECASE,
)
"""What stands before a road user that a preposition governs."""
BE = r"is|was|are|were|sits|sat|stands|stood"


@cache
def _inverted() -> re.Pattern[str]:
    words = language.table("rephrased")["inverted"]
    users = language.alternatives(list(language.actor_nouns()))
    who = rf"(?P<who>(?:an?|one|another|two|three|several|some) (?:[\w-]+ ){{0,3}}?(?:{users})\b)"
    goes_on = r"(?!,? (?:that|which|who|whose)\b)"
    place = rf"(?P<place>(?:{language.alternatives(words['places'])}) (?:[\w''’-]+ ){{0,8}}?)"
    deed = rf"(?P<deed>(?:{language.alternatives(words['participles'])}) (?:[\w''’-]+ ){{0,8}}?)(?P<be>{BE}) "
    opens = r"(?:(?<=^)|(?<=[.;:!?\n])|(?<=[.;:!?\n] )|(?<=, and )|(?<=\bthen )|(?<=\bwhile )|(?<=\bwhen ))"
    return re.compile(rf"{opens}(?:{place}(?P<verb>[a-z]+) |{deed}){who}{goes_on}", re.IGNORECASE)


@cache
def _users() -> re.Pattern[str]:
    names = language.table("ego")
    users = language.alternatives([*language.actor_nouns(), "driver", "vehicle", "traffic", "system"])
    labels = rf"(?:{'|'.join(names['labels']['words'])})[ -]?#?[1-9]"
    return re.compile(rf"\b(?:{'|'.join(names['strong'])}|{labels}|{users})\b", re.IGNORECASE)


@cache
def _finite(kind: str) -> frozenset[str]:
    """The finite forms of the verbs of a list: those that have no object, or those that have one."""
    verbs = language.table("rephrased")["inverted"][kind]
    return frozenset((*map(third_person, verbs), *(form for form, verb in past_forms().items() if verb in verbs)))


def inverted(text: str) -> list[Replacement]:
    """Each such beginning of a sentence in the order subject, verb, place."""
    found: list[Replacement] = []
    for match in _inverted().finditer(text):
        before = match["place"] or match["deed"]
        if OTHERS.search(before) or _another(before):
            continue
        if match["verb"] in _finite("verbs"):
            said = f"{match['who']} {match['verb']} {before.strip()}"
        else:
            continue
        found.append((match.start(), match.end(), said[:1].upper() + said[1:]))
    return found


def _another(before: str) -> bool:
    """Whether a road user is named before the verb that no preposition governs: the subject."""
    return any(not GOVERNED.search(before[: m.start()]) for m in _users().finditer(before))
