"""Where entities are at the start: relations read from noun phrases and from clauses."""

import itertools
import re

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.surroundings.whereabouts import (
    STATES,
    Where,
    read,
    side_of_text,
)
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.where.accompanied import WITH_ANOTHER, accompanied, within
from c2s_engine.interpret.where.both_in import both_in_lane
from c2s_engine.interpret.where.closures import in_closed_lanes
from c2s_engine.interpret.where.ego_in_line import ego_in_line
from c2s_engine.interpret.where.entity_phrases import DIRECTED, PLACING, EntityPhrases
from c2s_engine.interpret.where.groups import abreast, split_groups
from c2s_engine.interpret.where.implied import implied_places
from c2s_engine.interpret.where.implied_lanes import followed_lane
from c2s_engine.interpret.where.inferred import Inferred
from c2s_engine.interpret.where.lane_numbers import number_lanes
from c2s_engine.interpret.where.places_in import WHY, places_in
from c2s_engine.interpret.where.ranked import ranked
from c2s_engine.interpret.where.revealed import reveal
from c2s_engine.interpret.where.struck import struck_places
from c2s_engine.interpret.who.mentions import Cast, Entity

__all__ = ["STATES", "Places", "Where", "read", "side_of_text"]


AGAINST = re.compile(r"wrong[- ](way|direction)|(against|contrary to) (the )?(traffic|direction|flow|stream|current)")

FILLED = re.compile(
    r"((?:oncoming|opposite|opposing|left|right|adjacent|neighbou?ring|other|next)(?:-hand)? lane"
    r"|lane (?:to|on) (?:the|its|@ego 's) (?:left|right)|other (?:two|three|lanes|two lanes)) "
    r"(?:(?:be|is|was|are|were) )?(?:\w+ )?(?:full of|fill(?:ed)? with"
    r"|occup(?:y|ied) by|pack(?:ed)? with|block(?:ed)? (?:by|with)|taken? by)"
    r"(?: the| an?)?(?: (?:convoy|row|line|column|queue|string|platoon) of)?(?: \w+)?$"
)


WITHIN = re.compile(
    r"(?:be|come|get|draw) (?:\w+ )?(?:closer|nearer|less|within|away|below|under)\b.*#dist"
    r"|(?:be|come|get) (?:only |just |about |less than )*#dist (?:away|from|off|distant)\b"
)
HEADING = DIRECTED | {"to", "across", "over"}
AND_ANOTHER = re.compile(r"(?:,? and (?:the |an? |another |one |two |some |three )?(?:\w+ )?| , )@(?!ego).*$")
"""Who else is there ("there is a van ahead and a cyclist in the right lane"), with a place of its own."""


class Places(EntityPhrases, Inferred):
    """The start relation of every entity."""

    def __init__(self, cast: Cast, clauses: Clauses) -> None:
        self.cast, self.clauses, self.words = cast, clauses, clauses.words
        self.of: dict[Entity, Where] = {}
        self.ego_lane: str | None = None
        for entity in cast.entities:
            self.of[entity] = self._where(entity)
        accompanied(cast, clauses, self.of)
        self.ego_lane = self.ego_lane or None
        in_line = ego_in_line(cast, clauses, self.of)
        self.ego_lane = in_line or self.ego_lane
        in_closed_lanes(cast, clauses, self.of)
        split_groups(cast, clauses, self.of)
        self.row, lane = ranked(cast, clauses, self.of) if in_line is None else (None, None)
        self.ego_lane = self.ego_lane or lane
        abreast(clauses, self.of)
        implied_places(cast, clauses, self.of)
        struck_places(cast, clauses, self.of)
        self.ego_lane = self.ego_lane or followed_lane(clauses, self.of)
        within(cast, clauses, self.of)
        self.ego_lane = both_in_lane(cast, self.of) or self.ego_lane
        self._referred()
        self._between()
        self._joined()
        self._shared()
        if self.row is None:
            self.ego_lane = self.ego_lane or number_lanes(cast, clauses, self.of)
        self._overtaken()
        self._in_the_way()
        self._mutual()
        self._hidden()
        reveal(cast, clauses, self.of)

    def _before(self, word: Word) -> list[str]:
        """The words of a sentence before one of it."""
        return [w.norm for w in self.words[: word.i] if w.sentence == word.sentence]

    def _where(self, entity: Entity) -> Where:
        where = Where()
        for mention in entity.mentions:
            self._from_phrase(mention.word, where, entity)
        events = [e for e in self.clauses.events if e.agent is entity or entity in e.also]
        for event in sorted(events, key=lambda e: e.word):
            if event.mode in ("hypothetical", "negated") and event.act not in ("stationary", "travel"):
                continue
            if event.adverbial in ("when", "if", "once", "as", "until") and WITHIN.match(event.text):
                continue  # "brakes when a cyclist is closer than 15 m": how near it comes, not where it starts
            against = event.act == "oncoming" and AGAINST.search(event.whole)
            if event.act in STATES or against or event.act == "follow" and event.patient is None:
                text = WITH_ANOTHER.sub("", event.whole)
                if any(self.words[c].dep == "expl" for c in self.words[event.word].children):
                    text = AND_ANOTHER.sub("", text) if entity is event.agent or not where.phrases else ""
                read(text, where, entity, self.cast, event.act)
                self._gap(event.words, where, entity=entity)
            elif event.act not in ("collide",):
                for part in places_in(event):
                    read(part, where, entity, self.cast, event.act)
                comes_past = event.act == "cut_in" and any(e.act == "overtake" and e.done for e in events)
                if event.act in ("cut_in", "brake", "follow", "stop", "run_red", "turn") and not comes_past:
                    self._gap(event.words, where)
            if self.words[event.word].dep == "relcl" and event.adverbial == "where":
                head = self.words[event.word].head
                if head not in self.cast.of and self.words[head].norm in (
                    "lane",
                    "approach",
                    "arm",
                    "street",
                    "side",
                    "shoulder",
                ):
                    read(
                        "in " + self.clauses.render([i for i in self.clauses._below(head) if i <= head]),
                        where,
                        entity,
                        self.cast,
                        event.act,
                    )
        for (
            event
        ) in self.clauses.events:  # "the ego comes upon a van standing in its lane"; "ego has a van in front of it"
            if (
                event.patient is entity
                and event.agent.ego
                and event.act in ("approach", "travel", "follow", "held_up", "overtake", "keep_away")
                and event.mode != "hypothetical"
            ):
                self._gap(event.words, where)
        return where

    def _from_phrase(self, i: int, where: Where, entity: Entity) -> None:
        word = self.words[i]
        indices: list[int] = []
        for child in word.children:
            other = self.words[child]
            if other.dep in ("prep", "advmod", "appos", "npadvmod", "amod", "dep", "nmod", "acl") and child != i:
                if other.dep == "amod" and child < i:
                    continue
                if other.dep == "acl" and (child in self.clauses.by_word):
                    continue
                if i in self.clauses.deeds and other.norm in HEADING:
                    continue  # "a lane change by the truck to the left"
                named = self.cast.of.get(child)
                if other.dep in ("appos", "dep", "nmod") and named is not None and named is not entity:
                    continue
                indices += self.clauses._below(child)
        apposed = [
            c
            for c in word.children
            if self.words[c].dep == "appos" and (c in self.cast.of and self.cast.of[c] is entity)
        ]
        for child in apposed:
            self._from_phrase(child, where, entity)
        before = [w for w in self.words[max(0, i - 9) : i] if w.sentence == word.sentence]
        front = self.clauses.render([w.i for w in before])
        fronted = re.search(
            (
                r"(?:^|, |\band |: )((?:from|to|on|at|in) (?:the |its |@\w+ 's )+(?:left|right)(?:-?hand|most)?"
                r"(?: side| lane| pavement| sidewalk| footpath| verge| shoulder| kerb| curb| edge)?"
                r"(?: of the (?:road|street|carriageway))?)"
                r"(?:(?<=lane) ,)?(?: (?!(?:and|but)\b)\w+){0,3}$"
            ),
            front,
        )
        if fronted and word.span is not None:
            read(fronted[1] + (" park" if self._parks(entity) else ""), where, entity, self.cast, "noun")
        self.clauses.render([w.i for w in self.words[max(0, i - 14) : i] if w.sentence == word.sentence])
        filled = FILLED.search(front)
        if filled and word.span is not None:
            lane = re.sub(r"other (two|three|lanes|two lanes)$", "adjacent lane", filled[1])
            read(f"in the {lane}", where, entity, self.cast, "noun")
            stands = "block" in filled[0] or entity.roles & {"stationary", "parked"} or where.lane == "oncoming"
            where.rel = where.rel or (None if stands else "beside")
        lead = word.span.data.get("words", []) if word.span is not None and word.span.kind == "actor" else []
        lead = [*lead, entity.noun] if re.match(r"wrong|ghost", entity.noun) else lead
        text = " ".join(lead) + " "
        indices = sorted(set(indices))
        text += self.clauses.render(indices)
        if word.span is not None and (
            self.words[word.head].norm in ("with", "is", "are")
            or i + 1 < len(self.words)
            and self.words[i + 1].norm in PLACING
        ):
            following = self._following(i)
            read(" ".join([*lead, self.clauses.render(following)]), where, entity, self.cast, "noun")
        text = self._unhit(text, entity)
        if self.cast.of and text.strip():
            read(text, where, entity, self.cast, "noun")
            self._gap(indices, where)
        if (
            i + 1 < len(self.words)
            and self.words[i + 1].norm in (":", "-")
            and self.words[i + 1].sentence == word.sentence
            and word.span is not None
        ):
            rest = []
            for other in self.words[i + 2 :]:
                if other.sentence != word.sentence or other.norm == ";":
                    break
                rest.append(other.i)
            for clause in re.split(r" , ", WHY.sub("", self.clauses.render(rest))):
                if not re.search(r"\b(turn|cut|change|merge|move|swerve|overtake)\w*\b", clause):
                    read(clause, where, entity, self.cast, "noun")
            self._gap(rest, where)
        counted = (
            i + 1 < len(self.words) and self.words[i + 1].tag == "CD" and self.words[i + 1].sentence == word.sentence
        )
        if (
            word.span is not None
            and (
                (not indices or self.words[word.head].norm == "with")
                and word.dep in ("pobj", "conj", "dobj", "attr", "ROOT", "dep", "appos", "nsubj")
                or counted
            )
            or word.norm == "another"
        ):
            after = list(itertools.takewhile(lambda at: self.words[at].dep != "mark", self._following(i)))
            if i in self.clauses.deeds:
                after = list(itertools.takewhile(lambda at: self.words[at].norm not in HEADING, after))
            if (
                after
                and word.dep == "dobj"
                and re.match(
                    r"(in|on) the (rear|side(?! of the (?:road|street))|back|front|left|right)"
                    r"(?!(-hand|most)? (lane|pavement|sidewalk|footpath|kerb|curb|verge|shoulder))",
                    self.clauses.render(after),
                )
            ):
                after = []
            if after and (
                self.words[after[0]].tag in ("IN", "RB", "VBN", "CD", "JJ", "TO")
                or self.words[after[0]].norm in PLACING
            ):
                read(
                    self._unhit(self.clauses.render(after), entity),
                    where,
                    entity,
                    self.cast,
                    "noun",
                )
                self._gap(after, where)
        if self.clauses.fragment(i) and i not in self.clauses.deeds:
            rest = self.clauses.about(i)
            text = re.sub(
                r"(?<!in )(?<!the )\b(left|right|same|own|ego|oncoming|opposite|adjacent|next)(-hand|most)? lane",
                r"in the \1 lane",
                self.clauses.render(rest),
            )
            read(text, where, entity, self.cast, "noun")
            self._gap(rest, where)
        # "V2 in front, 20 m" and following adverbs in headless sentences
        if word.dep in ("ROOT",) and not word.verb:
            rest = self.clauses.own(word)
            read(self.clauses.render([r for r in rest if r > i]), where, entity, self.cast, "noun")
            self._gap(rest, where, entity=entity)

    def _parks(self, entity: Entity) -> bool:
        """Whether it is told as parked."""
        stands = (e for e in self.clauses.events if e.agent is entity and e.act == "stationary")
        return "parked" in entity.roles or any(e.text.startswith("park") for e in stands)
