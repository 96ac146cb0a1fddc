"""Words for a share of those who were told of, without their noun: "the first two turn off, the rest go on"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import past_forms, third_persons, verb_lemmas
from c2s_engine.interpret.spans import Span

NUMBER = r"(?P<n>two|three|four|five|six|couple|few|[2-6])"
THEM = r"(?P<of> of (?:them|these|those|the (?:two|three|four|five|six|pair|group|lot|[2-6])))"
SHARES = (
    ("first", rf"the (?:first|front|leading|foremost) {NUMBER}{THEM}?"),
    ("last", rf"the (?:last|rear|rearmost|final|trailing) {NUMBER}{THEM}?"),
    ("rest", rf"the (?:other|remaining|following|next) {NUMBER}{THEM}?"),
    ("rest", rf"the (?:rest|remainder){THEM}?"),
    ("all", rf"(?:each|every one|all|any)(?: one)?{THEM}"),
    ("all", rf"all {NUMBER}(?! of the )"),
    ("first", rf"the (?:nearest|closest|foremost|nearer|closer)(?: one)?{THEM}?"),
    ("last", rf"the (?:furthest|farthest|rearmost|hindmost|backmost|tail-?end)(?: one)?{THEM}?"),
    ("first", rf"the former{THEM}"),
    ("one", rf"(?<!the )(?<!each )(?<!every )(?<!any )(?<!last )one{THEM}"),
    ("last", rf"the latter{THEM}"),
    ("second", rf"the second(?: one)?{THEM}"),
    ("third", rf"the third(?: one)?{THEM}"),
)
AUXILIARIES = (
    r"is|are|was|were|has|have|had|does|do|did|will|would|must|shall|should|can|could|may|then|both|all|also|who"
)


@cache
def _patterns() -> list[tuple[str, re.Pattern[str]]]:
    return [(share, re.compile(rf"(?<![\w-]){words}(?![\w-])")) for share, words in SHARES]


def shares(text: str, taken: list[Span]) -> list[Span]:
    """The words that mean a share, where no noun follows and somebody is told to do something."""
    found: list[Span] = []
    for share, pattern in _patterns():
        for match in pattern.finditer(text):
            told = match.groupdict()
            plural = share == "all" and not match[0].startswith(("each", "every", "any")) or share == "rest"
            plural = plural or bool(told.get("n"))
            inside = any(s.start < match.end() and match.start() < s.end for s in (*taken, *found))
            if not inside and _acts(text, match.end(), bool(told.get("of")), plural=plural):
                data = {"share": share, "n": _number(told.get("n")), "plural": plural}
                found.append(Span("share", match.start(), match.end(), data))
    return found


def _number(word: str | None) -> int:
    counts = language.table("actors")["counts"]
    return 0 if word is None else int(word) if word.isdigit() else int(counts[word])


def _acts(text: str, end: int, of: bool, *, plural: bool) -> bool:
    """Whether a verb follows, so that no noun is left out ("the first two lanes"); "of them" ends the phrase."""
    after = re.match(r"(?: (?:then|suddenly|just|simply|also|both|\w+ly))* ([a-z']+)", text[end:])
    if after is None:
        return of and re.match(r"\s*(?:[.,;:)]|$)", text[end:]) is not None
    word = after[1]
    if re.fullmatch(AUXILIARIES, word) or word in past_forms():
        return True
    return word in verb_lemmas() if plural else word in third_persons()
