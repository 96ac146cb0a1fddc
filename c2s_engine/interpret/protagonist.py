"""Who is ego where nobody is called so."""

import re

from c2s_engine.interpret.askers import bystanding
from c2s_engine.interpret.clauses import Clauses
from c2s_engine.interpret.entities import URGENT
from c2s_engine.interpret.event import Event
from c2s_engine.interpret.mentions import MOTOR, VEHICLES, Cast, Entity

ROLE_WORDS = frozenset(("lead", "oncoming", "parked", "stationary", "crossing", "adjacent", "cut_in", "slow"))


EGO_LIKE = frozenset(
    (
        "travel",
        "turn",
        "go_straight",
        "lane_change",
        "lose_control",
        "leave_road",
        "run_red",
        "run_stop",
        "reverse",
        "follow",
        "overtake",
        "drift",
        "approach",
        "collide",
        "keep_lane",
        "brake",
        "yield",
        "oncoming",
        "u_turn",
        "brake_stop",
        "stop",
        "swerve",
        "enter_road",
        "start",
        "accelerate",
        "cut_out",
        "overtake",
        "evade",
    )
)


FROM_ASIDE = re.compile(
    r"^(?!.*\b(?:turn|chang|merg|mov|swerv|veer)\w*\b.* from ).*\bfrom (?:the |its )?"
    r"(?:left|right|rear|behind|front|opposite (?:side|direction|carriageway|lane))\b"
    r"(?! (?:\w+ )?(?:lane|side|turn|shoulder|kerb|curb))"
)
"""A way by which one comes towards somebody who is not named: that is ego."""


TOWARDS = frozenset(("collide", "overtake", "follow", "yield", "cut_in", "evade"))
"""What ego does to another: who is meant by "the driver" is not the other."""


def _after(i: int, cast: Cast) -> str:
    """A word with what follows it in its sentence."""
    return " ".join(w.norm for w in cast.words[i : i + 10] if w.sentence == cast.words[i].sentence)


def _demanded(entity: Entity, cast: Cast) -> bool:
    """Whether a rule asks something of it: "the vehicle shall clear the lane"."""
    return any(
        cast.words[c].norm in ("shall", "must") and cast.words[m.word].dep == "nsubj"
        for m in entity.mentions
        for c in cast.words[cast.words[m.word].head].children
    )


def _past_nobody(event: Event) -> bool:
    """Whether one goes past somebody who is not named: that may be ego."""
    return event.patient is None or event.patient.mover and event.patient.type not in VEHICLES


def _by_whom(cast: Cast, entity: Entity) -> bool:
    """Whether it is first named as who did something to another ("was hit by a left-turning truck")."""
    at = entity.mentions[0].word
    head = cast.words[cast.words[at].head]
    return cast.words[at - 1 if at else 0].norm == "by" or head.dep == "agent" and cast.words[at].dep == "pobj"


def _runs_down(entity: Entity, clauses: Clauses) -> bool:
    """Whether it hits somebody without a motor ("a cyclist was knocked down by a van"): then it is whom it is about."""
    hits = [v.patient for v in clauses.events if v.act in ("collide", "approach") and v.agent is entity and v.done]
    return any(p is not None and p.mover and p.type not in MOTOR for p in hits)


def _anchors(entity: Entity, clauses: Clauses) -> bool:
    """Whether others are placed by it ("ahead of the coach", "behind the coach"): it is who the text is about."""
    text = clauses.render(list(range(len(clauses.words))))
    placed = set(
        re.findall(rf"\b(ahead of|behind|in front of|alongside|beside|next to) (?:the )?@{entity.key}\b", text)
    )
    return len(placed) > 1


def choose_ego(cast: Cast, clauses: Clauses) -> None:
    """Where nobody is called ego: the vehicle that the text is about, if there is one besides the others."""
    if cast.ego.mentions:
        return
    vehicles = [e for e in cast.entities if e.type in MOTOR and e.count == 1 and e.group is None]
    told_by = bystanding(" ".join(w.norm for w in cast.words))
    acting = {e: [v for v in clauses.events if v.agent is e and v.done] for e in vehicles}
    candidates = []
    for entity in vehicles:
        at = entity.mentions[0].word
        the = at < 3 or cast.words[at - 1].norm == "the"
        first = " ".join(w.norm for w in cast.words[entity.mentions[0].word : entity.mentions[0].word + 7])
        if (
            entity.roles & ROLE_WORDS
            or not told_by
            and any(v.act == "overtake" and _past_nobody(v) for v in acting[entity])
            or "following" not in entity.roles
            and not told_by
            and not (the and re.match(r"\S+ (is|was|were) ", first))
            and re.search(
                (
                    r"^\S+( \S+)? (ahead|in front|in the (left|right|adjacent|next|oncoming)|coming"
                    r"|approaching|oncoming|from (the|its|behind))"
                ),
                first,
            )
        ):
            continue
        head = cast.words[entity.mentions[0].word]
        if not told_by and len(vehicles) == 1 and any(FROM_ASIDE.search(_after(m.word, cast)) for m in entity.mentions):
            continue
        before = cast.words[head.i - 1].norm if head.i else ""
        if before in ("another", "other") or any(cast.words[c].norm in ("another", "other") for c in head.children):
            continue
        acts = [v.act for v in acting[entity]]
        if any(v.act in TOWARDS and v.agent is cast.ego and v.patient is entity for v in clauses.events):
            continue
        if not acts and not any(v.patient is entity for v in clauses.events):
            continue
        if acts and not EGO_LIKE & set(acts):
            continue
        if (
            {"cut_in", "enter_road"} & set(acts)
            or (acts and all(a == "stationary" for a in acts))
            or any(v.act == "reverse" and re.search(r"driveway|parking|garage", v.whole) for v in acting[entity])
        ):
            continue
        if (
            any(
                v.passive and v.patient is not None
                for v in clauses.events
                if v.agent is entity and v.act == "stationary"
            )
            or _by_whom(cast, entity)
        ) and not _runs_down(entity, clauses):
            continue
        if (
            cast.words[entity.mentions[0].word].dep == "pobj"
            and cast.words[cast.words[entity.mentions[0].word].head].dep == "agent"
            and not acts
        ):
            continue
        candidates.append(entity)
    if not candidates:
        struck = {v.patient for v in clauses.events if v.act == "collide" and v.done and not v.agent.ego}
        candidates = [e for e in vehicles if e in struck and not e.roles & ROLE_WORDS][:1]
    if not candidates:
        return
    demanded = [e for e in candidates if _demanded(e, cast)]
    ordinary = [e for e in candidates if e.type not in URGENT]
    candidates = demanded or (candidates if told_by else ordinary) or candidates
    generic = [e for e in candidates if e.noun == "vehicle"]
    if generic and "the" in [
        w.norm for w in cast.words[max(0, generic[0].mentions[0].word - 2) : generic[0].mentions[0].word]
    ]:
        candidates = generic
    others = [e for e in cast.entities if e not in candidates]
    best = next((e for e in candidates if "following" in e.roles), candidates[0])
    hit = {v.patient for v in clauses.events if v.act in ("collide", "overtake", "follow", "yield") and v.agent is best}
    if (
        len(candidates) == 1
        and not others
        and any(v.act in ("brake", "cut_in", "enter_road") for v in acting[best])
        and not hit
    ) and re.search(r"\b(in front|ahead)\b", " ".join(w.norm for w in cast.words)):
        return
    plain = " ".join(w.norm for w in cast.words)
    implied = re.search(
        r"\b(coming|comes) (the other way|towards)|(?<!\bno )\boncoming\b|opposite (direction|lane)|other direction",
        plain,
    )
    first = bool(cast.asking) and best.mentions[0].word == min(m.word for e in cast.entities for m in e.mentions)
    if (
        implied
        and not first
        and not _anchors(best, clauses)
        and best.mentions[0].word > 6
        and best is not (generic[0] if generic else None)
    ):
        return
    cast.entities.remove(best)
    if best.type != "vehicle":
        cast.ego.type, cast.ego.typed = best.type, True
    cast.ego.mentions = best.mentions
    for i, entity in list(cast.of.items()):
        if entity is best:
            cast.of[i] = cast.ego
    for event in clauses.events:
        event.text = re.sub(rf"@{best.key}\b", "@ego", event.text)
        event.whole = re.sub(rf"@{best.key}\b", "@ego", event.whole)
        event.agent = cast.ego if event.agent is best else event.agent
        event.patient = cast.ego if event.patient is best else event.patient
        event.also = [cast.ego if a is best else a for a in event.also]
