"""What single clauses cannot tell: denied stops before signs, waiting for another."""

import re

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.avoiding import abandoned, by_means
from c2s_engine.interpret.what.backstory import was_over
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.halfway import go_after, set_out
from c2s_engine.interpret.what.heeded import merged_back, unheeded
from c2s_engine.interpret.what.looking_back import looking_back, tried_to_avoid
from c2s_engine.interpret.what.making_room import makes_room
from c2s_engine.interpret.what.overtakings import PART, overtakings
from c2s_engine.interpret.what.passing import by_the_other_lane, headings
from c2s_engine.interpret.what.resumed import waited_turns
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.what.waiting import waited_for
from c2s_engine.interpret.who.mentions import Cast

LEAVES = re.compile(
    r"\b(?:down|onto|up|into|for|to take) (?:the|its|his|her|an?) (?:\w+ )?(?:off-?ramp|exit|slip road)\b"
)


FROM_MINOR = re.compile(r"(?:pull|come|edge|nose|creep|inch|roll|shoot) (?:straight |right |slowly )?out\b(?! of)")
JERKS = ("swerve", "veer", "jink")
AHEAD_OF_EGO = re.compile(r"\b(?:ahead|in front) of (?:the )?@ego\b")


def _at_a_light(told: str) -> bool:
    return bool(re.search(r"\bred\b|traffic (light|signal)|\b(at|for) (the|a|its) (light|signal)", told))


def resolve_across_clauses(cast: Cast, clauses: Clauses, road: Road) -> None:
    """What single clauses cannot tell: a stop that is denied before a stop sign, a pass that is waited for."""
    by_means(cast, clauses)
    unheeded(clauses)
    merged_back(clauses)
    looking_back(cast, clauses)
    tried_to_avoid(cast, clauses)
    set_out(clauses)
    go_after(clauses)
    makes_room(cast, clauses, road)
    for event in list(clauses.events):
        if event.act == "collide" and event.patient is not None and event.patient.type == "slippery_patch":
            event.act, event.patient = "travel", None  # over it
        if event.act in ("stop", "brake_stop") and event.mode == "fact" and was_over(cast, event, clauses):
            event.act = "stationary"
        apart = event.patient is None or AHEAD_OF_EGO.search(event.text) is not None and event.patient.ego
        if event.act == "collide" and apart and event.agent.count > 1 and not event.agent.ego:
            event.act, event.patient = "stop", None  # with each other
        if event.act == "stop" and event.mode == "negated":
            sentence = " ".join(w.norm for w in cast.words if abs(w.sentence - cast.words[event.word].sentence) <= 1)
            if re.search(r"stop sign", sentence) and road.stop_sign:
                event.act, event.mode = "run_stop", "fact"
            elif _at_a_light(event.whole + " " + sentence) and re.search(
                r"(fail|not|never|without|instead of).{0,30}stop.{0,30}(red|light|signal)", sentence
            ):
                event.act, event.mode = "run_red", "fact"
        late = event.act in ("stop", "brake", "brake_stop") and event.mode == "negated"
        if late and re.search(
            r"in time|soon enough|fast enough|early enough|before (hit|the (car|vehicle))", event.whole
        ):
            event.act, event.mode, event.patient = "collide", "fact", event.patient
        if (
            event.mode == "negated"
            and cast.words[event.word].norm in ("move", "moving")
            and event.act in ("travel", "start", "move_along")
        ):
            had = any(cast.words[c].norm == "had" for c in cast.words[event.word].children)
            moved = any(e.agent is event.agent and e.act in ("reverse", "start") and e.done for e in clauses.events)
            event.act, event.mode = "stationary", "hypothetical" if moved and had else "fact"
        if event.act == "yield" and event.mode == "negated" and not event.agent.ego:
            event.act, event.mode = "cross_path", "fact"
        if event.act == "turn_or_change":
            verb = clauses._lemma(cast.words[event.word])
            turns = road.kind in ("intersection", "roundabout") and (verb not in JERKS)
            event.act = "turn" if turns else "swerve" if verb in JERKS else "lane_change"
        steers = event.act == "turn" and clauses._lemma(cast.words[event.word]) == "steer"
        braked = any(
            e.agent is event.agent and e.act == "brake" and 0 < event.word - e.word < 6 for e in clauses.events
        )
        if steers and (braked or road.kind not in ("intersection", "roundabout")):
            event.act = "swerve"
        if event.act == "pass_by":
            junction = road.kind == "intersection" and not re.search(r"lane|left|right|behind", event.whole)
            event.act = (
                "travel"
                if junction or event.agent.ego and event.patient is None and event.adverbial in ("as", "when", "while")
                else "overtake"
            )
        minor = event.act == "cut_in" or event.act == "lane_change" and not event.agent.ego
        overtakes = re.search(r"\b(?:overtak|pass)\w*|behind|kerb|curb|park", event.whole)
        if (
            minor
            and (event.act == "cut_in" or not overtakes)
            and road.kind == "intersection"
            and FROM_MINOR.match(event.text)
        ):
            out = "go_straight" if event.agent.ego else "cross_path"
            event.act = out if "lane" not in event.whole and (not event.agent.ego or road.stop_sign) else event.act
        passes = event.act in ("overtake", "travel", "go_straight", "cross_path", "move_along", "cross_road")
        if passes and not event.agent.ego and event.agent.mover and event.mode == "fact":
            word = cast.words[event.word]
            before = " ".join(
                w.norm for w in cast.words[max(0, event.word - 9) : event.word] if w.sentence == word.sentence
            )
            waits = re.search(
                (
                    r"(only (after|once|when)|not (before|until|till)|wait(s|ing)? (for|until|till)|must wait"
                    r"|have to wait|has to wait)\b"
                ),
                before,
            )
            gone = re.search(
                r"pass|clear|gone|go(es)? (by|past)|cross|through",
                event.text + " " + word.norm + " " + " ".join(w.norm for w in cast.words[event.word : event.word + 4]),
            )
            if (waits and gone) and not any(e.act == "yield" and e.agent.ego for e in clauses.events):
                given_way = {"patient": event.agent, "order": event.order - 0.1, "words": [event.word]}
                clauses.events.append(Event.echo(event, act="yield", agent=cast.ego, **given_way))
    for event in clauses.events:
        if (
            event.mode in ("intended", "purpose")
            and not event.agent.ego
            and event.act in ("turn", "u_turn", "go_straight")
        ):
            about_to = clauses._lemma(cast.words[cast.words[event.word].head]) in (
                "wait",
                "signal",
                "prepare",
                "indicate",
                "try",
            )
            stands = [
                e for e in clauses.events if e.agent is event.agent and e.act in ("stationary", "stop") and e.done
            ]
            later = [e for e in clauses.events if e.agent is event.agent and e.act == event.act and e.word > event.word]
            if about_to and stands and not later:
                event.mode = "hypothetical"
    headings(cast, clauses)
    by_the_other_lane(clauses, road)
    abandoned(cast, clauses)
    waited_turns(clauses)
    waited_for(cast, clauses)
    _meant_and_done(clauses)
    overtakings(clauses)
    _nobody_follows_itself(cast, clauses)
    for event in clauses.events:
        if event.mode == "purpose" and event.act == "overtake":
            later = [e for e in clauses.events if e.order > event.order and e.mode == "fact"]
            own = {e.act for e in later if e.agent is event.agent or event.agent in e.also and e.act == "collide"}
            if "collide" in own or "follow" in own and "overtake" not in own:  # it came to nothing
                event.mode = "hypothetical"
    clauses.events.sort(key=lambda e: e.order)


def _nobody_follows_itself(cast: Cast, clauses: Clauses) -> None:
    """Who would follow itself is another, of the clause before: "the bus pulls off; ego brakes and follows the bus"."""
    for event in [e for e in clauses.events if e.act == "follow" and not e.adverbial]:
        word = cast.words[event.word]
        objects = [c for c in word.children if cast.words[c].dep == "dobj"]
        before = [e for e in clauses.events if e.order < event.order and e.agent is not event.agent
                  and cast.words[e.word].sentence == word.sentence]  # fmt: skip
        if before and any(cast.referent(c) is event.agent for c in objects):
            event.patient, event.agent = event.agent, max(before, key=lambda e: e.order).agent


def _meant_and_done(clauses: Clauses) -> None:
    """ "Meant to turn right. ... Then it turned right": what is told again when it is done happens only then."""
    for event in clauses.events:
        if event.mode != "intended" or event.act not in ("turn", "lane_change", "overtake"):
            continue
        later = [e for e in clauses.events if e.agent is event.agent and e.act == event.act and e.mode == "fact"]
        done = next((e for e in later if e.word > event.word), None)
        if done is not None and clauses.words[done.word].sentence - clauses.words[event.word].sentence > 3:
            continue
        if done is not None:
            event.mode, done.side = PART, done.side or side(event)
