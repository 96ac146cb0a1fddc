"""Where entities are at the start: relations read from noun phrases and from clauses."""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.clauses import Clauses, Event
from c2s_engine.interpret.mentions import Cast, Entity

STATES = frozenset(("travel", "stationary", "approach", "keep_lane", "go_straight", "start", "move_along", "wait", "lead", "held_up"))
ORIGINS = re.compile(r"from |out of |off |behind|leave |(?:to|on) (?:the |its )?(?:left|right)$|in front|ahead|oncoming|opposite")


@dataclass
class Where:
    """What is said about an entity's place: the values found, each with the words that say so."""

    rel: str | None = None
    lane: str | None = None
    side: str | None = None
    of: Entity | None = None
    facing: str | None = None
    gap: tuple[float, float] | None = None
    gap_time: float | None = None
    weak: bool = False
    hidden_by: Entity | None = None
    phrases: list[tuple[str, str]] = field(default_factory=list)


@cache
def _patterns() -> list[tuple[dict[str, Any], re.Pattern[str], re.Pattern[str] | None, re.Pattern[str] | None]]:
    return [
        (p, re.compile(p["find"]), re.compile(p["not"]) if "not" in p else None, re.compile(p["if"]) if "if" in p else None)
        for p in language.table("relations")["patterns"]
    ]


def read(text: str, where: Where, entity: Entity, cast: Cast, source: str = "") -> None:
    """Add what the words say to what is known; what is known already stays."""
    by_key = {e.key: e for e in cast.entities} | {"ego": cast.ego}
    for fact, pattern, unless, only_if in _patterns():
        if unless is not None and unless.search(text) or only_if is not None and not only_if.search(text):
            continue
        for match in pattern.finditer(text):
            if fact.get("skip") or re.search(r"\b(no|not|without|never)( \w+)? $", text[max(0, match.start() - 14) : match.start()]):
                continue
            groups = match.groupdict()
            of_key = groups.get("of") or groups.get("of2")
            other = by_key.get(of_key[1:]) if of_key else None
            if other is entity:
                other = None
                if of_key and fact.get("rel"):
                    continue
            side = groups.get("side")
            if groups.get("mirror"):
                side = groups["mirror"]
            _take(fact, side, other, where, entity, text, source)


def _take(fact: dict[str, Any], side: str | None, other: Entity | None, where: Where, entity: Entity, text: str, source: str) -> None:
    lane = fact.get("lane")
    if fact.get("vehicle") and entity.person:
        lane = None
    if fact.get("from_side"):
        if where.lane in (None, "crossing", "same", "oncoming") and not entity.person and where.rel != "behind":
            where.lane = "crossing"
        where.side = where.side or side
        return
    if lane == "side":
        lane = side
    if lane == "side_or_road":
        lane = None
        if where.lane is None and not entity.person and not entity.type == "bicycle":
            lane = side if not re.search(r"approach|from|road|street|intersection", text) else None
    if lane == "kerb":
        lane = "sidewalk" if entity.person else "parked"
    if entity.person and lane == "parked":
        lane = "roadside"
    if lane and (where.lane is None or where.weak or (where.lane == "adjacent" and lane in ("left", "right"))):
        if not (lane == "same" and where.lane and not where.weak):
            where.lane, where.weak = lane, bool(fact.get("weak"))
            if lane in ("left", "right"):
                where.side = where.side or lane
            if other is not None and where.of is None and lane in ("left", "right", "same"):
                where.of = other
    if side is None and fact.get("side"):
        side = fact["side"]
    if side and lane not in ("left", "right") and where.side is None:
        where.side = side
    if fact.get("rel") and where.rel is None:
        where.rel = fact["rel"]
        if other is not None:
            where.of = where.of if where.of is not None and lane else other
    if fact.get("facing") and where.facing is None:
        where.facing = fact["facing"]
    where.phrases.append((source, text))


def side_of_text(text: str) -> str | None:
    """The side that a phrase about the roadside names: "at the right kerb", "on the left"."""
    match = re.search(r"\b(left|right)\b(?!-of| of way| angle| away| behind| in front| ahead| after| before| at)", text)
    return match[1] if match else None


class Places:
    """The start relation of every entity."""

    def __init__(self, cast: Cast, clauses: Clauses) -> None:
        self.cast, self.clauses, self.words = cast, clauses, clauses.words
        self.of: dict[Entity, Where] = {}
        self.ego_lane: str | None = None
        for entity in cast.entities:
            self.of[entity] = self._where(entity)
        for where in self.of.values():
            text = " ; ".join(t for _, t in where.phrases)
            match = re.search(r"(?:directly|immediately|just|right) (?:in front of|ahead of|behind) (?:the )?@ego in the (left|right)", text)
            if match and where.rel in ("ahead", "behind"):
                where.lane, where.side = "same", None
                self.ego_lane = "leftmost" if match[1] == "left" else "rightmost"
        self._referred()
        self._shared()
        self._numbered()
        self._overtaken()
        self._mutual()
        self._hidden()
        self._revealed()

    def _where(self, entity: Entity) -> Where:
        where = Where()
        for mention in entity.mentions:
            self._from_phrase(mention.word, where, entity)
        events = [e for e in self.clauses.events if e.agent is entity or entity in e.also]
        for event in sorted(events, key=lambda e: e.word):
            if event.mode in ("hypothetical", "negated") and event.act not in ("stationary", "travel"):
                continue
            if event.act in STATES or event.act == "follow" and event.patient is None:
                read(event.whole, where, entity, self.cast, event.act)
                self._gap(event.words, where)
            elif event.act not in ("collide",):
                parts = [m[0] for m in re.finditer(r"(?:from|out of|off|leave|in|on|along|ahead of|behind) (?!to)[^,.;]*", event.whole) if re.match(r"from|out of|off|leave", m[0]) or event.act in ("brake", "stop", "brake_stop", "accelerate", "run_red", "turn", "keep_lane", "lose_control", "cross_path", "overtake")]
                for part in parts:
                    part = re.sub(r"\b(into|onto|to|towards) (the |its )?(@\w+ ''?s )?[\w -]*?(lane|road|street|path|way)\b", "", part)
                    if not (event.act == "overtake" and re.match(r"in|on|ahead", part)):
                        read(part, where, entity, self.cast, event.act)
                if event.act in ("cut_in", "brake", "follow", "run_red", "turn"):
                    self._gap(event.words, where, only_ahead=event.act == "cut_in")
        for event in self.clauses.events:  # "the ego comes upon a van standing in its lane"; "ego has a van in front of it"
            if event.patient is entity and event.agent.ego and event.act in ("approach", "travel", "follow", "held_up", "overtake") and event.mode != "hypothetical":
                self._gap(event.words, where, only_ahead=event.act != "follow")
        return where

    def _from_phrase(self, i: int, where: Where, entity: Entity) -> None:
        word = self.words[i]
        indices: list[int] = []
        for child in word.children:
            other = self.words[child]
            if other.dep in ("prep", "advmod", "appos", "npadvmod", "amod", "dep", "nmod", "acl") and child != i:
                if other.dep == "amod" and child < i:
                    continue
                if other.dep == "acl" and child in self.clauses.by_word:
                    continue
                if other.dep == "appos" and child in self.cast.of and self.cast.of[child] is not entity:
                    continue
                indices += self.clauses._below(child)
        apposed = [c for c in word.children if self.words[c].dep == "appos" and (c in self.cast.of and self.cast.of[c] is entity)]
        for child in apposed:
            self._from_phrase(child, where, entity)
        lead = word.span.data.get("words", []) if word.span is not None and word.span.kind == "actor" else []
        text = " ".join(lead) + " "
        known = set(self.cast.of) | set()
        indices = sorted(set(indices))
        text += self.clauses.render(indices)
        if known and text.strip():
            read(text, where, entity, self.cast, "noun")
            self._gap(indices, where)
        if i + 1 < len(self.words) and self.words[i + 1].norm == ":" and self.words[i + 1].sentence == word.sentence and word.span is not None:
            rest = []
            for other in self.words[i + 2 :]:
                if other.sentence != word.sentence or other.norm == ";":
                    break
                rest.append(other.i)
            for clause in re.split(r" , ", self.clauses.render(rest)):
                if not re.search(r"\b(turn|cut|change|merge|move|swerve|overtake)\w*\b", clause):
                    read(clause, where, entity, self.cast, "noun")
            self._gap(rest, where)
        counted = i + 1 < len(self.words) and self.words[i + 1].tag == "CD" and self.words[i + 1].sentence == word.sentence
        if word.span is not None and (not indices and word.dep in ("pobj", "conj", "dobj", "attr", "ROOT", "dep", "appos", "nsubj") or counted) or word.norm == "another":
            after: list[int] = []
            for other in self.words[i + 1 : i + 14]:
                if other.sentence != word.sentence or other.norm in (",", ".", ";", "and", "(", ":", "-", "but", "while", "when") or (other.verb and other.tag != "VBN") or other.norm in ("that", "which", "who"):
                    break
                after.append(other.i)
            if after and word.dep == "dobj" and re.match(r"(in|on) the (rear|side|back|front|left|right)", self.clauses.render(after)):
                after = []
            if after and self.words[after[0]].tag in ("IN", "RB", "VBN", "CD", "JJ", "TO"):
                read(self.clauses.render(after), where, entity, self.cast, "noun")
                self._gap(after, where)
        # copula without a verb of its own: "V2 in front, 20 m" and following adverbs in headless sentences
        if word.dep in ("ROOT",) and not word.verb:
            rest = self.clauses.own(word)
            read(self.clauses.render([r for r in rest if r > i]), where, entity, self.cast, "noun")
            self._gap(rest, where)

    def _gap(self, indices: list[int], where: Where, only_ahead: bool = False) -> None:
        if where.gap is not None:
            return
        text = self.clauses.render(indices)
        for quantity in self.clauses._quantities(indices):
            before = " ".join(w.norm for w in self.words[max(0, quantity["word"] - 5) : quantity["word"]])
            after = " ".join(w.norm for w in self.words[quantity["word"] + 1 : quantity["word"] + 8])
            if quantity["dimension"] == "distance":
                if re.search(r"^(high|tall|wide|long|deep|thick)", after) or re.search(r"visib|wide|radius|sideways|lateral|by (more|less)|long|off the|width|height|past the (intersection|junction)|within (a|an)?", before + " " + after) and not re.search(r"ahead|in front|behind|back|away", after):
                    continue
                if re.search(r"ahead|in front|behind|away|back|distance|apart|gap|from|at|further|beyond|short|before|#dist (to|of)|least|along|on\b|down", before + " " + after + " " + text) and not (only_ahead and re.search(r"(drive|travel)s? (for )?#dist", text)):
                    if re.search(r"(after|for|every) (about |around )?$", before + " ") or re.search(r"(turn|when|once|until)\b", before):
                        continue
                    low, high = quantity["low"], quantity["high"]
                    if re.search(r"(at least|more than|no less than|over|minimum|not less than)\s*$", before):
                        high = max(high, low * 1.3)
                    elif re.search(r"(less than|under|at most|within|no more than|not more than|up to|below)\s*$", before):
                        low = high * 0.6
                        high = high * 0.95
                    where.gap = (low, high)
                    return
            elif quantity["dimension"] == "time" and re.search(r"(time[- ]?)?(gap|headway|ttc|collision|apart|interval|distance)", before + " " + after + text) and where.gap_time is None:
                where.gap_time = quantity["low"]

    def _mutual(self) -> None:
        """What is said of ego (or of another) towards an entity says where that entity is, too."""
        turned = {"ahead": "behind", "behind": "ahead", "beside": "beside"}
        for event in self.clauses.events:
            if event.agent.ego and event.mode == "fact" and re.search(r"#dist (behind|back)(?! (the |a )?@)", event.whole) and event.act in STATES:
                ahead = [e for e in self.cast.entities if self.of[e].rel in (None, "ahead") and self.of[e].lane in (None, "same") and e.mover]
                if ahead and self.of[ahead[0]].gap is None:
                    self._gap(event.words, self.of[ahead[0]])
            if not event.agent.ego or event.mode == "hypothetical" or event.act not in STATES | {"keep_lane", "follow"}:
                continue
            for match in re.finditer(r"(?P<rel>behind|ahead of|in front of|alongside|beside|next to|to the rear of) (the |an? |another )?(\w+ )?@(?P<who>a\d+)", event.whole):
                other = next((e for e in self.cast.entities if e.key == match["who"]), None)
                if other is None:
                    continue
                where = self.of[other]
                rel = {"behind": "behind", "to the rear of": "behind"}.get(match["rel"], "beside" if match["rel"] in ("alongside", "beside", "next to") else "ahead")
                if where.rel is None:
                    where.rel = turned[rel]
                    if where.lane is None and rel != "beside" and not other.person:
                        where.lane = "same"
                if where.gap is None:
                    self._gap(event.words, where)

    def _shared(self) -> None:
        """ "Two cars and a truck standing across the lane": what is said of the last holds for those before it."""
        for entity in self.cast.entities:
            where = self.of[entity]
            if where.rel or where.lane or any(e.agent is entity or entity in e.also for e in self.clauses.events):
                continue
            for mention in entity.mentions:
                for child in self.words[mention.word].children:
                    other = self.cast.of.get(child)
                    if self.words[child].dep == "conj" and other is not None and other is not entity and not other.ego:
                        where.rel, where.lane, where.side = self.of[other].rel, self.of[other].lane, self.of[other].side
                        if any(e.agent is other and e.act == "stationary" for e in self.clauses.events) or "stationary" in other.roles:
                            entity.roles.add("stationary")

    def _numbered(self) -> None:
        """Lanes by number, counted from the left: "the number two lane", "lane 3"."""
        numbers: dict[Entity, int] = {}
        words = {"one": 1, "two": 2, "three": 3, "four": 4, "1": 1, "2": 2, "3": 3, "4": 4, "first": 1, "second": 2, "third": 3}
        pattern = re.compile(r"(?:number|lane number|lane|no\.?|#) (one|two|three|four|[1-4])(?: lane)?\b")
        for entity in (self.cast.ego, *self.cast.entities):
            texts = [e.whole for e in self.clauses.events if e.agent is entity and e.act in STATES | {"lane_change", "keep_lane"}]
            texts += [t for _, t in self.of[entity].phrases] if entity in self.of else []
            for mention in entity.mentions:
                texts.append(" ".join(w.norm for w in self.words[mention.word + 1 : mention.word + 11] if w.sentence == self.words[mention.word].sentence))
            for text in texts:
                match = pattern.search(text)
                if match and "lane" in match[0] and entity not in numbers:
                    numbers[entity] = words[match[1]]
        own = numbers.get(self.cast.ego)
        if own is None:
            return
        for entity, number in numbers.items():
            if not entity.ego and abs(number - own) <= 1:
                self.of[entity].lane = "same" if number == own else "right" if number > own else "left"
                self.of[entity].rel = self.of[entity].rel or ("ahead" if number == own else "beside")
        if self.ego_lane is None:
            self.ego_lane = "leftmost" if own == 1 else "middle" if own == 2 else "rightmost"

    def _overtaken(self) -> None:
        """One whom another (not ego) overtakes drives ahead of that other."""
        for event in self.clauses.events:
            other = event.patient
            if event.act != "overtake" or other is None or other.ego or event.agent.ego or other not in self.of or event.agent not in self.of:
                continue
            where, whose = self.of[other], self.of[event.agent]
            if where.rel is None and where.lane is None:
                where.lane, where.rel, where.side = whose.lane, "ahead", whose.side
                if whose.lane in (None, "same", "left", "right"):
                    where.of, where.lane = event.agent, "same"

    def _referred(self) -> None:
        """ "In that lane", "there", "where", "the same queue": the lane that was spoken of last."""
        for entity in self.cast.entities:
            where = self.of[entity]
            if where.lane not in (None, "same", "adjacent") or not entity.mover:
                continue
            for event in self.clauses.events:
                if event.agent is not entity or event.mode == "hypothetical":
                    continue
                text = event.whole
                if re.search(r"\b(same|that) (queue|line|row|column|jam)\b", text):
                    earlier = [e for e in self.cast.entities if e is not entity and e.count > 1 and self.of[e].lane]
                    if earlier:
                        where.lane, where.rel = self.of[earlier[-1]].lane, self.of[earlier[-1]].rel or "ahead"
                        break
                if re.search(r"in (that|this|there|it)( very)? lane|\b(in )?there\b|in that lane|stand in (it|@)", text) or event.adverbial == "where" or re.match(r"where", text):
                    side = self._last_lane(self.words[event.word].start)
                    if side and not re.search(r"(right|left)(-hand)? lane", text):
                        where.lane = side
                        if where.rel == "behind" and where.of is None or "behind" in text or "rear" in text:
                            where.rel = "behind"
                        break

    def _last_lane(self, before: int) -> str | None:
        plain = " ".join(w.norm for w in self.words if w.start < before)
        found = None
        for match in re.finditer(r"(?:mov\w+|merg\w+|chang\w+|shift\w*|steer\w*|pull\w*)(?: over| out)?(?: to the| to)? (left|right)\b|\b(left|right)(?:-hand|most)?(?: hand)? lane|lane (?:immediately |directly )?(?:to|on) (?:the|its|their) (left|right)|lane on the (left|right)|second lane[^.;]*(left|right)", plain):
            found = next(g for g in match.groups() if g)
        return found

    def _hidden(self) -> None:
        for entity in self.cast.entities:
            where = self.of[entity]
            for mention in entity.mentions:
                sentence = [w.i for w in self.words if w.sentence == self.words[mention.word].sentence]
                text = self.clauses.render(sentence)
                match = re.search(rf"(?:hidden|hide|concealed|conceal|obscured|obscure|occluded|occlude|masked|mask|blocked) by (the |a |an )?(\w+ )?@(?P<by>a\d+)[^.;]{{0,40}}, (the |a |an )?(\w+ )?@{entity.key}\b", text) or re.search(rf"(?:not|unable to|n't|cannot|hardly) (?:\w+ )?(?:see|notice|spot|detect)[^.;]*@{entity.key}\b[^.;]*(?:because of|due to|behind|as|for) (the |a |an )?(\w+ )?@(?P<by>a\d+)", text) or re.search(rf"@(?P<by>a\d+) (conceal|hide|obscure|block|mask)\w* be (the |a |an )?@{entity.key}\b", text) or re.search(rf"@{entity.key}\b.*?(from behind|from between|out from behind|(?:hidden|hide|concealed|conceal|obscured|obscure|occluded|occlude|masked|mask|screened|screen|blocked|block) (by|behind)|behind|in front of|between) (the |a |an |two |some |row of |line of )*(\w+ ){{0,2}}@(?P<by>a\d+)", text)
                if match is None:
                    match = re.search(rf"@(?P<by>a\d+)[^.;]*?(hide|hides|hid|conceal\w*|obscure\w*|block\w*|occlude\w*|mask\w*|obstruct\w*|screen\w*|shield\w*)( the view (of|to|on))?( @ego ''?s)?( view (of|to))? (the |a |an |any )?(\w+ )?@{entity.key}\b", text)
                    if match is None:
                        continue
                elif match.re.groups > 2 and (match[1] or "") in ("behind", "in front of", "between"):
                    if not entity.person or match[1] == "behind" and not re.search(r"parked|stand|stop|stationary|emerge|step|appear|run|dart", text) or match[1] == "in front of" and not re.search(r"(parked|stopped|stationary)", text):
                        continue
                blocker = next((e for e in self.cast.entities if e.key == match["by"]), None)
                if blocker is not None and blocker is not entity and not (blocker.person):
                    where.hidden_by = blocker
                    if where.of is blocker and where.rel == "behind":
                        where.rel, where.of = None, None

    def _revealed(self) -> None:
        """What stands ahead of one who leaves the lane in front of ego is hidden by it until then."""
        leavers = [e.agent for e in self.clauses.events if e.done and e.act in ("cut_out", "lane_change", "swerve") and not e.agent.ego and self.of[e.agent].lane in (None, "same") and self.of[e.agent].rel in (None, "ahead") and e.agent.mover] if self.clauses.events else []
        plain = " ".join(w.norm for w in self.words)
        if not leavers or not re.search(r"only (then|now)|come into view|comes into view|into (its |@?\w+ 's )?view|becomes? visible|reveal|expos|suddenly confronted|cannot see|can not see|hidden|conceal|uncover|appears? (in front|ahead)|see past|unseen|until then|behind it|reveals", plain):
            return
        for entity in self.cast.entities:
            where = self.of[entity]
            stands = any(e.agent is entity and e.act == "stationary" for e in self.clauses.events) or "stationary" in entity.roles or not entity.mover
            if stands and where.hidden_by is None and entity is not leavers[0] and where.lane in (None, "same") and entity.type not in ("construction_zone", "lane_closure"):
                where.hidden_by = leavers[0]
                if where.of is None or where.of.ego:
                    where.of, where.rel = leavers[0], "ahead"

    def of_event(self, event: Event) -> Where:
        """The relation that one clause alone states."""
        where = Where()
        read(event.whole, where, event.agent, self.cast)
        return where
