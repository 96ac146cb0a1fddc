"""What hides whom: said of it, or following from who drives ahead."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.where.gaps import Gaps
from c2s_engine.interpret.who.mentions import Cast

HIDES = re.compile(
    r"hid|conceal|obscur|occlu|mask|block|screen|see|notic|spot|detect|behind|between|in front of|obstruct|shield|view"
    r"|sight|visible|shadow|blind|in cover|the lee"
)
FIXED = frozenset(language.table("actors")["fixed"])
"""Nouns of what stands beside the road for good."""
LONG = 2_000
"""Characters of a sentence beyond which nobody tells what hides whom."""


_A = r"(?:the |a |an )?(?:\w+ )?"
_HIDE = (
    r"(?:obstructed|obstruct|hidden|hide|concealed|conceal|obscured|obscure|occluded|occlude|masked|mask|screened"
    r"|screen|blocked|block|shielded|shield|veiled|camouflaged)"
)
_TAKES = r"(?:hide|obscure|block|mask|obstruct|restrict|limit|impair)\w*"
_SIDE = r"(?:the |its |@ego 's )?(?:road |street )?(?:to |on |from )?(?:the )?(?P<side>left|right)"
_VIEW = r"(?:view|sight|line of sight|vision|visibility|sightline)"
_AT_FIRST = (
    r"(?: (?:from (?:the )?@ego(?: 's (?:view|sight))?|from (?:view|sight)|(?:until|till) (?:\w+ ){1,3}?|at first"
    r"|initially|completely|partly|partially|fully|entirely|so far))*"
)
HIDDEN = (
    rf"{_HIDE}{_AT_FIRST} (?:by|behind) {_A}@(?P<by>a\d+)[^.;@]{{0,40}}, {_A}@KEY\b",
    rf"@KEY\b[^;]*?\bin (?:the )?(?:blind (?:area|zone)|(?:view |sight |radar )?shadow|cover|lee) of {_A}@(?P<by>a\d+)",
    rf"(?:because of|due to|owing to) {_A}@(?P<by>a\d+)[^.;@]* @ego [^.;@]*(?:not|unable to|n't|cannot|hardly)"
    rf" (?:\w+ )?(?:see|notice|spot|detect) {_A}@KEY\b",
    rf"@(?P<by>a\d+)\b[^.;@]*?\b(?:so|hence|therefore|thus|why)\b(?: that)? (?:the )?@ego [^.;@]*?"
    rf"(?:not|n't|cannot|hardly|unable to|never) (?:\w+ ){{0,2}}?(?:see|notice|spot|detect) {_A}@KEY\b",
    rf"@(?P<by>a\d+)\b[^.;@]*?\b(?:so|hence|therefore|thus|why)\b(?: that)? (?:the )?@ego (?:\w+ ){{0,2}}?"
    rf"(?:see|notice|spot|detect) {_A}@KEY (?:[\w']+ ){{0,4}}?(?:late|only|just)\b",
    rf"@KEY\b[^.;]*?(?:not|n't|cannot|hardly|never) (?:\w+ ){{0,2}}(?:see|visible|notice|spot|detect)\b[^.;@]*?"
    rf"(?:because of|due to|behind|owing to) {_A}@(?P<by>a\d+)",
    rf"@(?P<by>a\d+) (?:\w+ )?{_TAKES} (?:(?:the|its|our|@ego 's) )?"
    rf"{_VIEW}(?: ahead)? ?[,;]? {_A}@KEY\b",
    rf"@KEY\b[^.]*[,;] (?:and |but |while |as )?(?:the|its|@ego 's) {_VIEW} be (?:\w+ )?(?:{_HIDE}|impeded|impede) by"
    rf" {_A}@(?P<by>a\d+)",
    rf"@KEY\b[^;]*?\b{_HIDE}{_AT_FIRST} ?(?:by|behind) (?:the |a |an |row of |line of )*(?:\w+ ){{0,2}}@(?P<by>a\d+)",
    rf"@KEY\b[^;]*?\b(?:out of (?:the )?(?:sight|view)|invisible|unseen){_AT_FIRST} ?(?:by|behind) {_A}@(?P<by>a\d+)",
    r"@KEY\b[^;]*?\b(?:view|sight|visible|seen)\b[^.;]{0,30}\b(?:as|when|once|after) [^.;]{0,24}"
    rf"\b(?:pass|past|clear|leave|beyond|emerge) {_A}@(?P<by>a\d+)\b",
    rf"(?:not|unable to|n't|cannot|hardly) (?:\w+ )?(?:see|notice|spot|detect)[^.;]*@KEY\b[^.;]*"
    rf"(?:because of|due to|behind|as|for) {_A}@(?P<by>a\d+)",
    r"@(?P<by>a\d+) (?:conceal|hide|obscure|block|mask)\w* be (?:the |a |an )?@KEY\b",
    rf"\b(?:view|sight) (?:of|to|on) {_A}@KEY be (?:\w+ )?(?:{_HIDE}|obstructed|obstruct|impeded|impede) by {_A}"
    r"@(?P<by>a\d+)",
    rf"@KEY\b.*?(?P<how>(?<!hit )(?<!struck )from behind(?! by)|from between|out from behind|from in front of"
    rf"|{_HIDE} (?:by|behind)|behind|in front of|between) (?:the |a |an |two |some |row of |line of )*"
    r"(?:\w+ ){0,2}@(?P<by>a\d+)",
    r"(?:^|[.;,:] |\band |\bwhen |\bthere |@a\d+ )(?:suddenly |out )*from (?:behind|in front of|between) "
    rf"{_A}@(?P<by>a\d+) ,?(?:[^.;@]|@ego){{0,30}}? ?(?:the |a |an )(?:\w+ )?@KEY\b",
    rf"(?:^|[.;,:] |\band )(?P<fronted>behind|between) {_A}(?:two |some )?@(?P<by>a\d+) ,?[^.;@]{{0,30}}?"
    r" ?(?:the |a |an )(?:\w+ )?@KEY\b",
    r"@(?P<by>a\d+)[^.;]*?(?:hide|hides|hid|conceal\w*|obscure\w*|block\w*|occlude\w*|mask\w*|obstruct\w*|screen\w*"
    r"|shield\w*)(?: (?:the|its|his|her|our|@ego ''?s) (?:view|sight|line of sight)(?: (?:of|to|on))?)?(?: @ego ''?s)?"
    r"(?: view (?:of|to))? (?:the |a |an |any )?(?:\w+ )?@KEY\b",
)
"""How a sentence says that one (KEY) is hidden by another."""


STANDS_OR_COMES = re.compile(r"parked|stand|stop|stationary|emerge|step|appear|run|dart")


class Concealed(Gaps):
    """The part of Places that finds what blocks ego's view."""

    cast: Cast
    of: dict[Entity, Where]

    def _hidden(self) -> None:
        for entity in self.cast.entities:
            where = self.of[entity]
            for mention in entity.mentions:
                sentence = [w.i for w in self.words if w.sentence == self.words[mention.word].sentence]
                text = self.clauses.render(sentence)
                if len(text) > LONG or not HIDES.search(text):
                    continue
                key = self._blocker(entity, text)
                blocker = next((e for e in self.cast.entities if e.key == key), None)
                if blocker is not None and blocker is not entity and not (blocker.person):
                    where.hidden_by = blocker
                    if where.of is blocker and where.rel in ("behind", "ahead"):
                        where.rel, where.of = None, None
                    self._beyond(entity, blocker)


    def _beyond(self, entity: Entity, blocker: Entity) -> None:
        """A vehicle that one ahead hides, and of which nothing else is told, is ahead of that one."""
        where, theirs = self.of[entity], self.of[blocker]
        idle = all(e.act in ("travel", "collide") for e in self.clauses.events if e.agent is entity and e.done)
        if (
            idle
            and not entity.person
            and entity.type != "bicycle"
            and where.open
            and where.of is None
            and (theirs.rel == "ahead" and theirs.lane in (None, "same"))
        ):
            where.rel, where.of = "ahead", blocker

    def _blocker(self, entity: Entity, text: str) -> str | None:
        """Who hides one, by the words of a sentence."""
        for pattern in HIDDEN:
            match = re.search(pattern.replace("KEY", entity.key), text)
            if match is None:
                continue
            how, by = match.groupdict().get("how"), match["by"]
            if how is not None and self._comes_from_there(entity, how, by):
                continue
            if match.groupdict().get("fronted") and not entity.person:
                continue
            if how is None or not self._only_beside(entity, how, by, text):
                return by
        return None

    def _comes_from_there(self, entity: Entity, how: str, by: str) -> bool:
        """Whether it is another who comes from there ("brakes for a dog that shot out from behind a hedge")."""
        told = re.compile(rf"\b{how} (?:[\w-]+ ){{0,3}}@{by}\b")
        own = [e.agent for e in self.clauses.events if told.search(e.text)]
        return bool(own) and entity not in own

    def _only_beside(self, entity: Entity, words: str, by: str, text: str) -> bool:
        """Whether "behind", "between" or "in front of" says where one is, not that it is hidden."""
        blocker = next((e for e in self.cast.entities if e.key == by), None)
        if words not in ("behind", "in front of", "between") or blocker is None:
            return False
        if words == "behind" and blocker.noun in FIXED:
            return False  # "approaches behind a hedge"
        if words == "behind" and not (STANDS_OR_COMES.search(text)):
            return True
        stands = blocker.roles & {"parked", "stationary"} or re.search(r"(parked|stopped|stationary)", text)
        if words == "in front of" and not stands:
            return True
        return not entity.person
