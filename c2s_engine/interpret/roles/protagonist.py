"""Who is ego where nobody is called so."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import URGENT
from c2s_engine.interpret.roles.among_others import active_counterpart, trailing_vehicle
from c2s_engine.interpret.roles.aside import beside_nobody, from_aside
from c2s_engine.interpret.roles.bare import ROLE_WORDS, bare_first
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import MOTOR, VEHICLES, Cast, Entity

NEVER_EGO = language.words("never_ego")


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


TOWARDS = frozenset(("collide", "overtake", "follow", "yield", "cut_in", "evade"))
"""What ego does to another: who is meant by "the driver" is not the other."""


def _passes_nobody(acts: list[Event]) -> bool:
    """Whether one goes past somebody who is never named: that may be ego."""
    passed = [v.patient for v in acts if v.act == "overtake"]
    return bool(passed) and all(p is None or p.mover and p.type not in VEHICLES for p in passed)


def _on_its_own(entity: Entity) -> bool:
    """Whether it is told of by itself, if only as one of several ("one of them")."""
    return entity.group is None or entity.group.type in MOTOR and not entity.group.roles & ROLE_WORDS


def choose_ego(cast: Cast, clauses: Clauses) -> None:
    """Where nobody is called ego: the vehicle that the text is about, if there is one besides the others."""
    if cast.ego.mentions:
        return
    vehicles = [e for e in cast.entities if e.type in MOTOR and e.count == 1 and _on_its_own(e)]
    told_by = cast.me is not cast.ego
    acting = {e: [v for v in clauses.events if v.agent is e and v.done] for e in vehicles}
    candidates = []
    for entity in vehicles:
        if (
            entity.roles & ROLE_WORDS
            or (entity.noun or entity.label) in NEVER_EGO
            or not told_by
            and (_passes_nobody(acting[entity]) or "following" not in entity.roles and beside_nobody(entity, cast))
        ):
            continue
        head = cast.words[entity.mentions[0].word]
        if not told_by and len(vehicles) == 1 and any(from_aside(m.word, cast) for m in entity.mentions):
            continue
        before = cast.words[head.i - 1].norm if head.i else ""
        told_apart = {before, *(cast.words[c].norm for c in head.children)} & {"another", "other"}
        if told_apart and vehicles.index(entity):
            continue
        if "other" in told_apart and len(vehicles) == 1 and not told_by:
            continue
        told = [v for v in acting[entity] if not v.whole.startswith("there be ")] or acting[entity]
        acts = [v.act for v in told]
        if any(v.act in TOWARDS and v.agent is cast.ego and v.patient is entity for v in clauses.events):
            continue
        if not acts and not any(v.patient is entity for v in clauses.events):
            continue
        if acts and not EGO_LIKE & set(acts):
            continue
        if {"cut_in", "enter_road"} & set(acts):
            continue
        if (
            cast.words[entity.mentions[0].word].dep == "pobj"
            and cast.words[cast.words[entity.mentions[0].word].head].dep == "agent"
            and not acts
        ):
            continue
        candidates.append(entity)
    candidates = bare_first(vehicles, cast) or candidates
    if not candidates:
        struck = {v.patient for v in clauses.events if v.act == "collide" and v.done and not v.agent.ego}
        candidates = [e for e in vehicles if e in struck and not e.roles & ROLE_WORDS][:1]
    if not candidates and len(vehicles) == 1 and not beside_nobody(vehicles[0], cast):
        passed = [v.patient for v in acting[vehicles[0]] if v.act in ("overtake", "cut_in")]
        candidates = (
            vehicles if passed and all(p is not None and p.type not in MOTOR and not p.ego for p in passed) else []
        )
    if not candidates:
        return
    ordinary = [e for e in candidates if e.type not in URGENT]
    candidates = (candidates if told_by else ordinary) or candidates
    generic = [e for e in candidates if e.noun == "vehicle"]
    if generic and "the" in [
        w.norm for w in cast.words[max(0, generic[0].mentions[0].word - 2) : generic[0].mentions[0].word]
    ]:
        candidates = generic
    best = next((e for e in candidates if "following" in e.roles), candidates[0])
    best = best if acting.get(best) else active_counterpart(best, candidates, clauses)
    best = trailing_vehicle(best, [e for e in vehicles if not e.roles & ROLE_WORDS], clauses)
    plain = " ".join(w.norm for w in cast.words)
    implied = re.search(
        r"\b(coming|comes) (the other way|towards)|(?<!\bno )\boncoming\b|opposite (direction|lane)|other direction",
        plain,
    )
    met = any("oncoming" in v.patient.roles for v in acting.get(best, []) if v.patient is not None)
    first = bool(cast.asking and best.mentions) and best.mentions[0].word == min(
        m.word for e in cast.entities for m in e.mentions
    )
    if (
        implied
        and not told_by
        and not first
        and not met
        and not any(v.act == "oncoming" for v in acting.get(best, []))
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
