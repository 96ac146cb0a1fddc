"""Who is meant by "it" after a clause in which ego comes near: "a deer stands there. As ego gets close, it bolts"."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word

ANSWERS = language.words("answers_nearing")
MEASURED = r"(?:is|was|are|were|comes?|came|gets?|got)(?: \w+){0,3} #q"
NEARS = (
    rf"(?:{MEASURED}|(?:gets?|got|comes?|came|draws?|drew|moves?|moved|is|was)(?: very| too| really| quite)?"
    r" (?:close|closer|near|nearer|alongside|level|there)|nears?|neared|(?:is |was )?approach(?:es|ed|ing)?|arrives?"
    r"|arrived|catches up|caught up|(?:is |was )?clos(?:es|ed|ing) (?:in|up|the gap)|(?:comes|came|drives|drove) up"
    r"|reach(?:es|ed)|(?:is|was) (?:just )?about to (?:overtake|pass)|(?:starts|begins) to (?:overtake|pass))"
)
BEHIND = r"(?: (?:away|up|in|from|to|on|behind|of|with|before|further|back))*"
COMES_NEAR = re.compile(
    r"^(?:(?:just|only|but|then|and|exactly|\w+ly) )?(?:as|when|once|while|as soon as|by the time|the moment"
    rf"|the instant)(?: the)? @ego (?:has |have |had |then |now |finally )?(?P<nears>{NEARS}){BEHIND}"
    r"(?:(?: (?!@)\S+){0,3} @(?:x|it))? ?,(?: \w+)?$"
)


def comes_near(words: list[Word], of: dict[int, Entity], word: Word) -> Entity | None:
    """Whom "it" means after a clause in which ego comes near: who is near, or ego where it answers to that."""
    before = [w for w in words[: word.i] if w.sentence == word.sentence]
    begins = next((w.i for w in reversed(before) if w.norm in (";", ":")), -1)
    before = [w for w in before if w.i > begins]
    found = COMES_NEAR.match(" ".join(_spelled(w, of) for w in before if not _goes_on(words, w)))
    if found is None:
        return None
    near = next((of[w.i] for w in reversed(before) if w.i in of and not of[w.i].ego), None)
    near = near or _told_last(words, of, word)
    if near is None or near.person and near.type != "animal":
        return None
    return near


def _goes_on(words: list[Word], word: Word) -> bool:
    """Whether a word goes on with the quantity that the one before begins."""
    return word.i > 0 and word.span is not None and words[word.i - 1].span is word.span


def _spelled(word: Word, of: dict[int, Entity]) -> str:
    """A word for the pattern: who is meant, a quantity, or the word itself."""
    if word.i in of:
        return "@ego" if of[word.i].ego else "@x"
    if word.norm in ("it", "them"):
        return "@it"
    return "#q" if word.span is not None and word.span.kind == "quantity" else word.norm


def _told_last(words: list[Word], of: dict[int, Entity], word: Word) -> Entity | None:
    """The last of whom the sentence before tells, ego apart."""
    told = [i for i in sorted(of) if words[i].sentence == word.sentence - 1 and not of[i].ego and of[i].mover]
    subjects = [i for i in told if words[i].dep in ("nsubj", "nsubjpass", "attr")]
    return of[(subjects or told)[-1]] if told else None
