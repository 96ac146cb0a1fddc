"""Answers to questions about the scene at hand: from S, and from what its last run showed."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from c2s_engine.session.decided import decided, hedged, shown_of
from c2s_engine.session.glossary import meaning
from c2s_engine.session.question import Question, read
from c2s_engine.session.why import explained
from c2s_engine.session.yes_no import yes_or_no
from c2s_engine.structure.account import STATUS_WORDS, Clause, account, requirements_met, unread_words
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.event_words import USUAL, ended, event_phrase
from c2s_engine.structure.facts import EGO, EventFact, ObjectFacts, RunFacts
from c2s_engine.structure.measures import ActorMeasures, Collision, Measures, PairMeasures, collisions
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.requirements import failures
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.structure.stems import stems

HELP = (
    "Describe a scene (“Ego drives at 50 km/h; a cyclist crosses from the right”), change it (“make the cyclist a "
    "child”, “20 m closer”), or ask about it (“was there a collision?”, “why does ego brake?”, “how close did they "
    "come?”). In the app F1 lists keys and commands, /gallery has examples, F6 shows the results of the run; on the "
    "command line `c2s --help` lists the commands."
)
_HELP = re.compile(
    r"(?:please |can you |i need )*(?:help|hello|hi|hey|good (?:morning|afternoon|evening)|thanks?(?: you)?|"
    r"what can (?:i|you|one) (?:do|say|type|ask)|how does this work|what is this|where do i (?:start|begin))"
    r"(?:[ ,!.?](?:there|me|please|here|now|all|everybody|c2s))*[ !.?]*",
    re.I,
)
_ELSEWHERE = re.compile(
    r"\b(?:regulations?|R1[0-9]{2}|UN|NCAP|clauses?|procedures?|snippets?|documentation|scenic|carla|define|definition|"
    r"example of|meaning of|show me)\b"
    r"|^what (?:is|are) (?:an?\b|the\b(?!(?: [\w'-]+){0,3}? (?:outcome|result|gap|distance|smallest|least|minimum|"
    r"largest|greatest|maximum|highest|lowest|speed|deceleration|braking|ttc|pet|time|weather|road|type|ego|O\d+)\b))",
    re.I,
)
_ASKS_MEANING = re.compile(r"what (?:is|are) (?!the\b)|what (?:do|does) .+ (?:mean|stand for)\b", re.I)
_OF_THE_SCENE = re.compile(
    r"(?:and |but |so )?(?:is|are|was|were|did|does|do|has|have|when|where|who|which|at what|at which|"
    r"how (?:far|fast|hard|long|many|much|near|close|often))\b|.*\b(?:here|this|run|scene|scenario)\b", re.I | re.S
)
UNANSWERED = (
    "I cannot answer that from the run or from S. `/search WORDS` in the app, or `c2s search`, looks in the documents."
)
_UNUSED = (
    r"\bunused\b|(?:\bnot|n['’]t|\bnever) (?:\w+ ){0,2}(?:used|taken up|needed)\b"
    r"|\b(?:without|no) (?:\w+ )?(?:effect|difference)\b"
)
_UNDERSTOOD = r"\b(?:underst(?:ood|and)|left out|lost from|dropped|ignored|account of)\b"
_NEAR = r"\b(?:close|closest|near|nearest|far|gap|distance|apart|ttc|time to collision|pet|encroachment)\b"
_STOPPED = r"\b(?:stop\w*|stand\w*|halt\w*)\b"
_FAST = r"\b(?:fast\w*|speed\w*|velocity|km/h|slow\w*)\b"
_QUESTION = r"(?:how|who|when|where|why|what|which|is|are|was|were|did|does|do|has|have)\b"
_NEXT = re.compile(rf"(?:\?\s*(?:and|or|but)?|,?\s+and)\s+(?={_QUESTION})", re.I)
"""Between two questions in one turn."""
_WHY = re.compile(r"^(?:and |but |so )?(?:why|what makes|what made)\b", re.I)
_NOT = re.compile(r"\b(?:not|never|fail\w*)\b|n['’]t\b", re.I)
_OF_EGO = re.compile(r"\b(?:I|me|my|we|us|our|you|your)\b", re.I)
BEGINS = ("brake", "brake_hard")
"""The events with which a stop begins."""
BRAKES = (*BEGINS, "stop")
SHORTLY = 2.0
"""s before somebody brakes in which what happens can be why."""
_FUNCTION = "why what makes made did does do is are was were has have had will would not never fail the an of for to it"


def wants_help(text: str) -> bool:
    """Whether a text only greets, or asks what can be done here."""
    return bool(_HELP.fullmatch(text.strip()))


def asks_for_account(text: str) -> bool:
    """Whether a text asks what of the description was understood, or lost."""
    return re.search(f"{_UNUSED}|{_UNDERSTOOD}", text, re.I) is not None and text.rstrip().endswith("?")


def answered(question: str, shown: Finished | None) -> str:
    """The answer to a question about this scene or its run, or that there is none; empty where it asks something
    else."""
    if shown is None or not shown.program.text or _ELSEWHERE.search(question):
        return ""
    if len(each := [q for q in _NEXT.split(question) if q and q.strip()]) > 1:
        answers = {q.strip(" ?"): answered(q, shown) for q in each}
        lines = [words or f"“{q}”: {UNANSWERED}" for q, words in answers.items()]
        return "\n".join(lines) if any(answers.values()) else ""
    about = _QuestionContext(question, shown)
    if _ASKS_MEANING.match(question.strip()) and (entry := meaning(question)):
        measured = _in_the_run(about) if shown.facts and re.search(_NEAR, question, re.I) else ""
        return f"{entry}\n{measured}".strip()
    if about.why_not and (said := _why_not(about)):
        return said
    if shown.facts and (said := decided(about.asks, about.facts)):
        return said
    for pattern, answer in TOPICS:
        if re.search(pattern, question, re.I) and not (answer == _requirements and about.asks.fact):
            if (answer in NEEDS_RUN or answer == _braked and not about.why) and not shown.facts:
                return "The program has not been run yet: F5 (or `c2s run`) runs it."
            if said := answer(about):
                return f"{hedged(about.asks) if answer in HEDGED else ''}{said}"
    if about.why_not and about.named:  # on what S rests is no answer to that
        return UNANSWERED
    of_the_scene = not about.why and (about.named or _OF_THE_SCENE.match(question.strip()))
    elsewhere = meaning(question) or explained(question, shown.structure)
    return UNANSWERED if of_the_scene and not elsewhere else ""


@dataclass(frozen=True)
class _QuestionContext:
    """A question, and the scene that it is about."""

    text: str
    shown: Finished

    @property
    def structure(self) -> Structure:
        return self.shown.structure

    @property
    def facts(self) -> RunFacts:
        return self.shown.facts[0]

    @property
    def measures(self) -> Measures:
        return next(iter(self.shown.measures), Measures())

    @cached_property
    def asks(self) -> Question:
        """What is asked, as far as its words tell."""
        return read(self.text, self.structure)

    @property
    def why(self) -> bool:
        return bool(_WHY.match(self.text))

    @property
    def why_not(self) -> bool:
        """Whether it asks why something is not so."""
        return self.why and _NOT.search(self.text) is not None

    def names(self, component: Component) -> bool:
        """Whether the question names a component: ego, O1, its name, its type."""
        words = {component.id} if component.id != "E" else {"ego"}
        if isinstance(component.spec, ObjectSpec):
            words |= {component.spec.name, component.spec.type.replace("_", " ")}
        return any(re.search(rf"\b{re.escape(w)}s?\b", self.text, re.I) for w in words)

    @property
    def named(self) -> bool:
        """Whether the question names ego or an object."""
        return any(self.names(c) for c in self.structure.components if c.kind in "EO")

    @property
    def two_others(self) -> bool:
        """Whether it is about others than ego, and about none but these: two or more are named, ego is not."""
        cids = {_cid(o) for o in self.meant}
        return len(cids) > 1 and "E" not in cids and not _OF_EGO.search(self.text)

    @property
    def actors(self) -> list[ObjectFacts]:
        """The objects of the run that are asked about; those that are named, else all that move."""
        return self.meant or [o for o in self.facts.objects if o.moves]

    @property
    def meant(self) -> list[ObjectFacts]:
        """The objects of the run that are named, every member of a row."""
        cids = {c.id for c in self.structure.components if c.kind in "EO" and self.names(c)}
        return [o for o in self.facts.objects if _cid(o) in cids]

    def motion(self, name: str) -> ActorMeasures | None:
        return next((a for a in self.measures.actors if a.name == name), None)


def _cid(thing: ObjectFacts) -> str | None:
    return "E" if thing.name == EGO else thing.component


def _collided(asked: _QuestionContext) -> str:
    found = collisions(asked.facts, asked.shown.requirements, bool(asked.structure.text))
    if asked.why and (said := _why_collided(asked, found)):
        return said
    named, several = {o.name for o in asked.meant}, len({_cid(o) for o in asked.meant}) > 1
    if named:
        found = tuple(c for c in found if ({c.one, c.other} <= named if several else named & {c.one, c.other}))
    if not found:
        nearest = " ".join(_pair(p) for p in _pairs(asked)[:1])
        whose = " of these two" if several else f" of {', '.join(sorted(named))}" if named else ""
        return f"No collision{whose} in the run of {asked.facts.duration:.1f} s. {nearest}".strip()
    return ". ".join(f"{str(c)[0].upper()}{str(c)[1:]}" for c in found) + "."


def _in_the_run(asked: _QuestionContext) -> str:
    """What the run showed of a measure whose meaning is asked for."""
    if not re.search(r"\bpet\b|\bencroachment\b", asked.text, re.I):
        return _near(asked)
    crossed = [p for p in _pairs(asked) if p.pet_s is not None]
    none = "There is none in the run: nobody leaves a place that another then comes to."
    return " ".join(map(_pair, crossed)) or none


def _why_collided(asked: _QuestionContext, found: Sequence[Collision]) -> str:
    """Of a collision of ego: what ego could see, and what the two did before, as the run has it."""
    named = {o.name for o in asked.meant} - {EGO}
    hit = next((c for c in found if EGO in (c.one, c.other) and (not named or named & {c.one, c.other})), None)
    if hit is None:
        return ""
    other = hit.other if hit.one == EGO else hit.one
    here, its = (next((o for o in asked.facts.objects if o.name == n), None) for n in (EGO, other))
    lines = [f"{str(hit)[0].upper()}{str(hit)[1:]}."]
    if its is not None and its.hidden_behind:
        lines.append(f"{other} is hidden from ego at the start, behind {', '.join(its.hidden_behind)}.")
    elif its is not None:
        lines.append(f"{other} is in ego's sight from the start.")
    before = [(e.time, o.name, e) for o in (here, its) if o is not None for e in o.events
              if e.event not in USUAL and 0 < e.time < hit.time]  # fmt: skip
    before.sort(key=lambda b: b[0])
    if before:
        lines.append(f"Before: {'; '.join(f'{name} {_event(e)}' for _, name, e in before[-8:])}.")
    if here is not None and not any(e.event in BRAKES and e.time < hit.time for e in here.events):
        spec = asked.structure.ego.spec
        why = ": S gives ego no reaction" if isinstance(spec, EgoSpec) and spec.reaction == "none" else ""
        lines.append(f"Ego does not brake before{why}.")
    return " ".join(lines)


def _near(asked: _QuestionContext) -> str:
    if re.search(r"\b(?:start|begin)\w*\b|\bat first\b", asked.text, re.I) and (said := _apart_at_start(asked)):
        return said
    if asked.two_others and not _pairs(asked):
        return "The gap between these two was not measured, only their gaps to ego."
    stops = _stopped(asked) if re.search(_STOPPED, asked.text, re.I) else ""
    return " ".join([*(_pair(p) for p in _pairs(asked)[:4]), *([stops] if stops else [])])


def _apart_at_start(asked: _QuestionContext) -> str:
    others = [o for o in (asked.meant or asked.facts.objects) if o.name != EGO and EGO in o.starts]
    return " ".join(f"{o.name} starts {o.starts[EGO].gap:.1f} m from ego, bumper to bumper." for o in others)


def _pairs(asked: _QuestionContext) -> list[PairMeasures]:
    """Ego with those that are asked about (else with all others, whether they move or not), the nearest first; of two
    others that are named with no word of ego, these two."""
    named = {o.name for o in asked.meant}
    if asked.two_others:
        cids = {o.name: _cid(o) for o in asked.meant}
        pairs = [p for p in asked.measures.others if {p.one, p.other} <= named and cids[p.one] != cids[p.other]]
        return sorted(pairs, key=lambda p: p.gap_m)
    pairs = [p for p in asked.measures.pairs if p.other in named] or list(asked.measures.pairs)
    return sorted(pairs, key=lambda p: p.gap_m)


def _pair(pair: PairMeasures) -> str:
    least = f"{pair.gap_m:.1f} m at {pair.gap_at_s:.1f} s" if pair.gap_m > 0 else f"0 m at {pair.gap_at_s:.1f} s"
    parts = [f"Smallest gap between {pair.one} and {pair.other}, bumper to bumper: {least}"]
    if pair.ttc_s is not None:
        parts.append(f"smallest time to collision {pair.ttc_s:.1f} s at {pair.ttc_at_s:.1f} s")
    if pair.pet_s is not None:
        parts.append(f"post-encroachment time {pair.pet_s:.1f} s")
    return "; ".join(parts) + "."


def _braked(asked: _QuestionContext) -> str:
    if asked.why:
        return _why_braked(asked)
    said = []
    for actor in asked.actors:
        events = [e for e in actor.events if e.event in BRAKES]
        motion = asked.motion(actor.name)
        if events and motion:
            seen = ", ".join(_event(e) for e in events)
            said.append(f"{actor.name} {seen}; {motion.braking:.1f} m/s2 at most, at {motion.braking_at_s:.1f} s.")
        elif motion:
            hardest = f": {motion.braking:.1f} m/s2 at most, at {motion.braking_at_s:.1f} s" if motion.braking else ""
            said.append(f"{actor.name} does not brake in the run{hardest}.")
    return " ".join(said)


def _why_braked(asked: _QuestionContext) -> str:
    ego, spec = asked.structure.ego, asked.structure.ego.spec
    if not asked.names(ego) or not isinstance(spec, EgoSpec):
        return ""
    said = []
    assumed = next((a.reason for a in ego.assumed if a.field == "reaction"), "")
    if spec.reaction:
        how = "does not react" if spec.reaction == "none" else f"reacts to others: {spec.reaction.replace('_', ' ')}"
        said.append(f"S says that ego {how}" + (f" (assumed: {assumed})" if assumed else ""))
    if any("brake" in p.action or p.action == "stop" for p in spec.phases):
        said.append("S gives ego a braking phase")
    here = next((o for o in asked.facts.objects if o.name == EGO), None) if asked.shown.facts else None
    first = next((e for e in here.events if e.event in BEGINS and e.time > 0), None) if here else None
    if here and first is None:
        said.append("in the run ego does not brake")
    elif first:
        before = [(e.time, o.name, e) for o in asked.facts.objects if o.name != EGO for e in o.events
                  if 0 <= first.time - e.time <= SHORTLY and e.event not in USUAL]  # fmt: skip
        cause = max(before, key=lambda b: b[0], default=None)
        after = f", after {cause[1]} {_event(cause[2])}" if cause else ""
        said.append(f"in the run ego begins to brake at {first.time:.1f} s{after}")
    text = "; ".join(said)
    return f"{text[0].upper()}{text[1:]}." if text else ""


def _why_not(asked: _QuestionContext) -> str:
    """What S requires of what the question names and the run did not show, with what came instead; empty where all that
    was shown, or is not required."""
    components = [c for c in asked.structure.components if c.kind in "EO"]
    named = {c.id for c in components if asked.names(c)}
    names = {w for c in components for w in stems(f"{c.id} {getattr(c.spec, 'name', 'ego')} ego")}
    wanted = stems(asked.text.replace("’", "'").replace("n't", " not")) - names - stems(_FUNCTION)
    required = {r.id: r for r in asked.shown.requirements}
    missed = [(len(wanted & stems(f"{r.text} {r.id.rsplit('.', 1)[-1]}")), r, result) for result in asked.shown.results
              if not result.holds and (r := required.get(result.requirement)) and (not named or r.component in named)]
    most = max((shared for shared, _, _ in missed), default=0)
    if not most:
        return ""
    best = [(r, result) for shared, r, result in missed if shared == most]
    lines = failures([r for r, _ in best], [result for _, result in best])[:4]
    for cid in dict.fromkeys(r.component for r, _ in best):
        if came := _in_its_place(asked, cid):
            lines.append(came)
    return "\n".join(lines)


def _in_its_place(asked: _QuestionContext, cid: str) -> str:
    """What somebody does in the run, first to last."""
    found = [(e.time, o.name, e) for o in asked.facts.objects if _cid(o) == cid for e in o.events
             if e.event not in USUAL and e.time > 0] if asked.shown.facts else []  # fmt: skip
    found.sort(key=lambda f: f[0])
    said = "; ".join(f"{name} {_event(e)}" for _, name, e in found[:8])
    return f"In the run {said}. {_lasted(asked)}" if said else ""


def _fast(asked: _QuestionContext) -> str:
    said = []
    for actor in asked.actors:
        if motion := asked.motion(actor.name):
            held = f"drives longest at {actor.held_speed * 3.6:.0f} km/h, " if actor.held_speed else ""
            said.append(f"{actor.name} {held}fastest {motion.fastest * 3.6:.0f} km/h, slowest "
                        f"{motion.slowest * 3.6:.0f} km/h at {motion.slowest_at_s:.1f} s.")  # fmt: skip
    return " ".join(said)


def _stopped(asked: _QuestionContext) -> str:
    said = []
    for actor in asked.actors:
        motion = asked.motion(actor.name)
        if motion is None:
            continue
        stands = motion.stands_at_s
        said.append(f"{actor.name} stands from {stands:.1f} s on." if stands is not None else
                    f"{actor.name} does not stop: its slowest is {motion.slowest * 3.6:.0f} km/h.")  # fmt: skip
    return " ".join(said)


def _when(asked: _QuestionContext) -> str:
    """When what the question names happened."""
    found = shown_of(asked.asks, asked.facts) if asked.asks.fact else []
    if not found:
        return ""
    said = "; ".join(f"{o.name} {_event(e)}" for o, e in found[:6]) + "."
    return f"{said} {_fast(asked)}".strip() if re.search(_FAST, asked.text, re.I) else said


def _lasted(asked: _QuestionContext) -> str:
    return f"The run ended after {asked.facts.duration:.1f} s: {ended(asked.facts)}."


def _hidden(asked: _QuestionContext) -> str:
    """Behind whom those who are asked about (else all others that move) are hidden from ego at the start."""
    others = [o for o in asked.actors if o.name != EGO]
    return " ".join(f"{o.name} is hidden from ego at the start, behind {', '.join(o.hidden_behind)}."
                    if o.hidden_behind else f"{o.name} is in ego's sight from the start." for o in others)  # fmt: skip


def _happened(asked: _QuestionContext) -> str:
    found = [(e.time, o.name, e) for o in asked.actors for e in o.events if e.event not in USUAL and e.time > 0]
    found.sort(key=lambda f: f[0])
    events = "; ".join(f"{time:.1f} s {name} {event_phrase(e)}" for time, name, e in found[:16])
    end = _lasted(asked)
    return f"{events}. {end}" if events else f"There were no events. {end}"


def _event(event: EventFact) -> str:
    return f"{event_phrase(event)} at {event.time:.1f} s"


def _requirements(asked: _QuestionContext) -> str:
    met = requirements_met(asked.structure, asked.shown.results, asked.shown.details.get("without_effect", ()))
    missed = failures(asked.shown.requirements, asked.shown.results) if met else ()
    return "\n".join([f"{met}.", *missed[:8]]) if met else ""


def _accounted(asked: _QuestionContext) -> str:
    """What became of the text, clause by clause, where that is not simply a part of S."""
    clauses = account(asked.structure, asked.shown.details.get("without_effect", ()))
    if not clauses:
        return "There is no text: S was made without one."
    whole = sum(1 for c in clauses if c.status == "understood")
    lines = [f"“{c.text}”: {STATUS_WORDS[c.status]}" + (f" ({_lost(c)})" if c.lost else "")
             for c in clauses if c.status != "understood"]  # fmt: skip
    lines += filter(None, [unread_words(word for c in clauses for word in c.unread)])
    return "\n".join([f"{whole} of {len(clauses)} clauses of the text are in S as understood.", *lines])


def _unused(asked: _QuestionContext) -> str:
    """The words, of the text and of changes, that made no difference, and those that are not in S, with the reasons."""
    from c2s_engine.session import no_effect  # not when a session is opened

    idle = asked.shown.details.get("without_effect", ())
    lost = [u for c in account(asked.structure) for u in c.lost]
    lines = [no_effect.phrases_sentence(idle)] if idle else []
    lines += [f"“{u.text}”: {u.reason}." for u in dict.fromkeys(lost)]
    lines += filter(None, [unread_words(word for c in account(asked.structure) for word in c.unread)])
    return "\n".join(lines) or "All words are used, as far as I can tell."


def _lost(clause: Clause) -> str:
    """What of a clause is lost, and why: what is lost as a whole is not named again."""
    reasons: dict[str, list[str]] = {}
    for unmet in clause.lost:
        names = reasons.setdefault(unmet.reason, [])
        if unmet.text.strip(" .,;:") not in ("", clause.text.strip(" .,;:")):
            names.append(f"“{unmet.text}”")
    return "; ".join(f"{', '.join(names)}: {why}" if names else why for why, names in reasons.items())


def _assumed(asked: _QuestionContext) -> str:
    """What the text left open, with what was chosen and why."""
    notes = [f"{c.id}: {a.called} {a.value} ({a.reason})" for c in asked.structure.components for a in c.assumed
             if c.kind not in "EO" or asked.names(c) or not asked.named]  # fmt: skip
    return "\n".join(notes) or "Nothing was assumed."


def _of_s(asked: _QuestionContext) -> str:
    of_the_run = asked.asks.fact or asked.asks.measure
    return "" if of_the_run else yes_or_no(asked.text, asked.structure)


def _where(asked: _QuestionContext) -> str:
    """The place, and where those that are named start."""
    named = " ".join(f"{c.id}: {c.description}" for c in asked.structure.objects if asked.names(c))
    on = asked.shown.details.get("map")
    return named or f"R: {asked.structure.place.description}" + (f" The map: {on}." if on else "")


def _lanes(asked: _QuestionContext) -> str:
    lanes = getattr(asked.structure.place.spec, "lanes", None)
    said = f"S says {lanes} in ego's direction" if lanes else "S leaves the number of lanes open"
    seen = f"; in the run: {asked.facts.road.lanes_same_direction}" if asked.shown.facts else ""
    return f"{said}{seen}."


def _there(asked: _QuestionContext) -> str:
    named = [c for c in asked.structure.components if c.kind in "EO" and asked.names(c)]
    chosen = named or [c for c in asked.structure.components if c.kind in "EO"]
    return " ".join(f"{c.id}: {c.description}" for c in chosen if c.description)


TOPICS: tuple[tuple[str, Callable[[_QuestionContext], str]], ...] = (
    (_UNUSED, _unused),
    (_UNDERSTOOD, _accounted),
    (r"\b(?:assum\w+|guess\w*|left open|defaults?)\b", _assumed),
    (r"^(?:and |but |so )?(?:when|at (?:what|which) (?:time|moment))\b", _when),
    (r"^how long\b.*\b(?:run|scenario|last|take)\w*\b|\bduration\b", _lasted),
    (r"\bhow many lanes\b", _lanes),
    (r"\b(?:colli\w+|crash\w*|hit|hits|touch\w*|contact|accident)\b", _collided),
    (r"\b(?:hidden|hid(?:e|es|ing)?|occlu\w+|visible|in sight|(?:could|did|does) (?:the )?ego see)\b", _hidden),
    (_NEAR, _near),
    (r"\b(?:brak\w+|decelerat\w+|slow(?:s|ed|ing)? down)\b", _braked),
    (_STOPPED, _stopped),
    (_FAST, _fast),
    (r"\b(?:requirements?|met|work\w*|pass(?:ed)?|fail\w*|as (?:said|described|intended)|successful)\b", _requirements),
    (r"^(?:and |but |so )?where\b", _where),
    (r"", _of_s),
    (r"^(?:when|what happen\w*|what (?:did|does|do)|what is going on|does|did|tell me what)\b", _happened),
    (r"^(?:who|what) (?:is|are)\b|\bhow many\b", _there),
)
"""What is asked about, by the words of the field; the first topic that has an answer counts."""
NEEDS_RUN = (_when, _lasted, _collided, _hidden, _near, _stopped, _fast, _happened)
HEDGED = (_collided, _near, _braked, _stopped, _fast, _happened)
"""What gives figures of the run, with no verdict on what was not read."""
