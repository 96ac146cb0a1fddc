"""Ego's reaction: what it does when others force it to, laid around what it does of its own accord."""

import math
import re
from typing import NamedTuple

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.answers import about, waits_for
from c2s_engine.write.typed.braking import DRY, HARD, SOFT, around, brakes, force, stops
from c2s_engine.write.typed.collisions import stops_before
from c2s_engine.write.typed.course import WHERE_IT_IS, Actor
from c2s_engine.write.typed.evasion import grip
from c2s_engine.write.typed.stations import first_in_line
from c2s_engine.write.typed.tables import APPROACH_ANGLE, AT_REST, MOVES_OFF_ROAD, is_static, is_vehicle
from c2s_engine.write.typed.threats import (
    ASIDE,
    every,
    hits_ego,
    in_sight,
    is_hit,
    is_stopped,
    once_seen,
    room_left,
    threatening,
)
from c2s_engine.write.typed.threats import on_foot as threats_on_foot

CAREFUL = 1.5
"""m/s2 that it takes by then, where ego has just set out from where it stopped."""
FULL = {"wet": 7.0, "rain": 7.0, "heavy_rain": 6.0, "snow": 4.0}
"""m/s2 of an emergency braking, by the weather; else `DRY`."""
HOLDS = {"bicycle": 5.0, "truck": 7.0, "bus": 7.0}
"""m/s2 at most, by what ego is: a rider goes over the bars beyond."""
LAST_MOMENT = 0.7
"""The share of an emergency braking that it takes when that begins."""
LAST = 6.0
"""m/s2 that it takes by then, where S says of no such reaction."""
STILL = 3
"""m/s at which ego still is when it reaches whom it brakes for too late."""
FOR_LEADS = 3.0
"""m/s2 that it takes by then, where ego gives way or follows."""
PAST = 8.0
"""The same, where it swerves past them first."""
OVER, OVER_BRAKING = 5.0, 8.0
"""The same, where it leaves its lane for them; and where it brakes besides."""


class Effort(NamedTuple):
    """How ego brakes: from what need of it on (m/s2), with how much at least, with how much in an emergency (0: it is
    none), and whether it comes to a stand."""

    limit: float
    least: float
    full: float
    stands: bool


def reaction(actor: Actor, statements: list[str]) -> list[str]:
    """Ego's way with its reaction laid around it; with any, it runs into nobody whom S does not say it hits."""
    spec = actor.spec
    assert isinstance(spec, EgoSpec)
    answer = {"yield": _giving_way, "follow": _following, "brake": _braking}.get(spec.reaction)
    found = answer(actor, spec, statements) if answer else statements
    follows = spec.reaction == "follow" and spec.react_to is None  # as it drives
    reacts = spec.reaction != "none" and not follows
    if reacts and found is statements:
        return _guarded(actor, statements)
    named = spec.react_to is not None and spec.react_to in actor.structure
    return _guarded(actor, found, True) if reacts and named and "try:" in found else found


def _guarded(actor: Actor, statements: list[str], reacts: bool = False) -> list[str]:
    """Ego's way with braking at the last moment for whom it neither hits nor gets past; of one that `reacts` as it is,
    for the others."""
    spec, s = actor.spec, actor.structure
    assert isinstance(spec, EgoSpec)
    gone_round = {about(p) or spec.react_to for p in spec.phases if p.action in (*ASIDE, "overtake", "oncoming")}
    apart = {*gone_round, *([spec.react_to] if spec.reaction == "follow" else [])}
    apart |= {p.target for p in spec.phases if p.clearance is not None and p.trigger is None}  # with room of its own
    apart |= _given_way_to(s)
    cids = [c for c in threatening(s) if c not in apart and not is_hit(spec, c) and not _stays_behind(s, c)]
    heeded = {name for line in statements if line.startswith("interrupt") for name in re.findall(r"\w+", line)}
    strikers = _strikers(s, cids)
    seen = once_seen(s, [c for c in cids if c not in strikers and scope.reference(s, c).split("[")[0] not in heeded])
    if reacts:
        return [*statements, *around([], seen, LAST, brakes(seen, HARD))[1:]]
    return around(statements, seen, LAST, brakes(seen, HARD)) if seen else statements


def _giving_way(actor: Actor, spec: EgoSpec, statements: list[str]) -> list[str]:
    """Ego's way with braking for whom it let pass: they may then be ahead."""
    s, hit = actor.structure, _hit(spec)
    passed = {p.action for p in spec.phases} & {*ASIDE, "overtake", "oncoming"}
    overtaken = {p.target for p in spec.phases if p.action == "overtake"}
    cids = [c for c in threatening(s) if c not in hit]
    cids = [c for c in cids if not (passed and (_stands(s, c) or c in overtaken))]
    if waits_for(spec, spec.react_to or ""):  # it stops short of their ways itself
        cids = [c for c in cids if _comes_by(actor, c) not in {*APPROACH_ANGLE} - {"circulating"}]
    seen = once_seen(s, cids)
    return around(statements, seen, FOR_LEADS, brakes(seen)) if cids else statements


def _following(actor: Actor, spec: EgoSpec, statements: list[str]) -> list[str]:
    """Ego's way with braking for whom it follows, where it does anything but that."""
    leads = [c for c in threatening(actor.structure) if c == spec.react_to and _position(actor.structure, c) == "ahead"]
    if not leads or {p.action for p in spec.phases} <= {"follow", "keep_lane", "overtake", "collide"}:
        return statements
    seen = once_seen(actor.structure, leads)
    return around(statements, seen, FOR_LEADS, brakes(seen))


def _braking(actor: Actor, spec: EgoSpec, statements: list[str]) -> list[str]:
    """Ego's way with braking for whom its own phases do not answer."""
    s, hit, round_it = actor.structure, _hit(spec), _gone_round(actor.structure, spec)
    said = {p.target for p in spec.phases if p.action == "brake" and p.rate is not None and p.trigger is None}
    cids = [c for c in threatening(s) if c not in (*round_it, *said)]  # ego brakes for these as hard as S says
    if not cids or spec.react_to in {c for c in round_it if _stands(s, c)}:
        return statements
    strikers = [] if hit else _strikers(s, cids)
    if hit or strikers and (spec.react_to in strikers or len(strikers) == len(cids)):  # it brakes, but too late
        return _too_late(actor, statements, cids, hit, spec.hard)
    cids = [c for c in cids if c not in strikers and not _stays_behind(s, c)]
    if not cids:
        return statements
    threats = once_seen(s, [spec.react_to] if spec.react_to and spec.react_to in s else cids)
    forced = {p.action for p in spec.phases if p.trigger is None}
    if "swerve" in forced:
        return around(statements, threats, PAST, brakes(threats, HARD))
    if "lane_change" in forced:  # where it brakes first it goes on with that on its way over
        limit = OVER_BRAKING if any(p.action == "brake" for p in spec.phases) else OVER
        return around(statements, threats, limit, brakes(threats, HARD, release=2))
    effort, walkers = _effort(s, spec, cids), [c for c in threats_on_foot(s) if spec.react_to in (None, c)]
    if walkers:
        return _for_walkers(actor, spec, statements, cids, walkers, effort)
    return _for_drivers(actor, statements, cids, threats, effort)


def _effort(structure: Structure, spec: EgoSpec, cids: list[str]) -> Effort:
    """How ego brakes for them."""
    limit, least = (3.5, HARD) if spec.hard else (2.5, SOFT)
    stops_first = any(p.action == "stop" and p.trigger is None for p in spec.phases)
    if stops_first and any(_position(structure, c) in APPROACH_ANGLE for c in cids):
        limit = CAREFUL
    stands = is_stopped(spec) or _ends_standing(structure)
    full = min(grip(structure, FULL, DRY), HOLDS.get(spec.type, DRY)) if spec.hard and not stands else 0
    stated = [middle(p.rate) for p in spec.phases if p.action in ("brake", "stop") and p.rate is not None]
    full = min(stated[0] if full and stated else full, _hardest(structure))
    return Effort(round(LAST_MOMENT * full, 1) if full else limit, least, full, stands)


def _for_drivers(
    actor: Actor, statements: list[str], cids: list[str], threats: list[str], effort: Effort
) -> list[str]:
    """Ego's way with braking for those who drive, or lie in it."""
    limit, least, full, stands = effort
    braking = stops(threats, full) if full else brakes(threats, least, stands=limit if stands else 0)
    ring = [c for c in cids if _position(actor.structure, c) == "circulating"]
    if ring and not full:  # it goes in behind them
        need = force(threats)
        room = (f"gap(self, {every(actor.structure, c)}) > self.speed" for c in ring)
        over = " and ".join([f"{need} <= 0", *room])
        braking = f"do Stop(line, rate=lambda: max({scope.number(least)}, min(9, 1.1 * {need}))) until {over}"
    return [*around(statements, threats, limit, braking), *_goes_on_behind(actor, cids)]


def _for_walkers(
    actor: Actor, spec: EgoSpec, statements: list[str], cids: list[str], walkers: list[str], effort: Effort
) -> list[str]:
    """Ego's way with a stop for those on foot, and braking for the others, unless it reacts to one alone."""
    s, (limit, least, _, stands) = actor.structure, effort
    others = [] if spec.react_to else once_seen(s, [c for c in cids if c not in walkers])
    braking = brakes(others, least, stands=limit if stands else 0) if others else ""
    stops_for = {p.target for p in spec.phases if p.action == "stop"}
    before_them = _ends_standing(s) or stands and not stops_for.isdisjoint({None, *walkers})
    return [*around(statements, others, limit, braking), *_stop_for(actor, walkers, spec.hard, before_them)]


def _hit(spec: EgoSpec) -> set[str | None]:
    """Whom ego hits."""
    return {p.target for p in spec.phases if p.action == "collide"}


def _gone_round(structure: Structure, spec: EgoSpec) -> set[str | None]:
    """Past whom ego drives, or to whom it keeps room of its own."""
    overtaken = {p.target for p in spec.phases if p.action == "overtake" and not _slows(structure, p.target)}
    with_room = {p.target for p in spec.phases if p.clearance is not None}
    return overtaken | with_room | _given_way_to(structure)


def _given_way_to(structure: Structure) -> set[str]:
    """Those who come towards ego, where it breaks an overtaking off: that is how it answers them."""
    broken_off = any(p.action == "overtake" and p.abandoned for p in getattr(structure.ego.spec, "phases", ()))
    return {c.id for c in structure.objects if broken_off and _position(structure, c.id) == "oncoming_lane"}


def _goes_on_behind(actor: Actor, cids: list[str]) -> list[str]:
    """How ego that just drives goes on that has braked for a slower one, which just drives too: behind it."""
    found = [(c, actor.structure[c].spec) for c in cids]
    if len(found) != 1 or any(p.action != "keep_lane" for p in actor.spec.phases) or actor.plan.junction:
        return []
    cid, o = found[0]
    drives = isinstance(o, ObjectSpec) and is_vehicle(o.type) and not is_static(o)
    if not drives or o.placement.position != "ahead" or o.placement.facing == "against":  # type: ignore[union-attr]
        return []
    if any(p.action != "keep_lane" for p in o.phases):  # type: ignore[union-attr]
        return []
    one = scope.reference(actor.structure, cid)
    return [f"    do Drive(line, lambda: following_speed(self, {one}, {actor.speed}))"]


def _hardest(structure: Structure) -> float:
    """m/s2 with which T lets ego brake at most."""
    limits = getattr(structure.restrictions.spec, "limits", ())
    told = [li.maximum for li in limits if li.kind == "deceleration" and li.subject == "ego" and li.maximum]
    return min(told, default=math.inf)


def _comes_by(actor: Actor, cid: str) -> str:
    """The position of an object, or of the first in the queue that it is in."""
    return _position(actor.structure, first_in_line(actor.structure, cid, actor.plan))


def _position(structure: Structure, cid: str) -> str:
    """Where an object starts; "": it is not there."""
    spec = structure[cid].spec if cid in structure else None
    return spec.placement.position if isinstance(spec, ObjectSpec) else ""


def _stays_behind(structure: Structure, cid: str) -> bool:
    """Whether an object is behind ego and does nothing that brings it past."""
    spec = structure[cid].spec
    behind = isinstance(spec, ObjectSpec) and (spec.placement.position, spec.placement.of) == ("behind", "ego")
    return behind and {p.action for p in spec.phases} <= {"follow", "keep_lane", "brake", "stop"}  # type: ignore


def _ends_standing(structure: Structure) -> bool:
    """Whether the run ends as ego stands, or one behind it is to stop for it."""
    ends = getattr(structure.restrictions.spec, "terminate_when", ())
    behind = (c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec) and _stays_behind(structure, c.id))
    stops = any(p.action == "stop" and p.target in (None, "ego") for spec in behind for p in spec.phases)
    return stops or any(c.kind == "stopped" and c.subject == "ego" for c in ends)


def _slows(structure: Structure, cid: str | None) -> bool:
    """Whether an object slows down of its own accord."""
    spec = structure[cid].spec if cid and cid in structure else None
    return isinstance(spec, ObjectSpec) and bool({"brake", "stop"} & {p.action for p in spec.phases})


def _stands(structure: Structure, cid: str | None) -> bool:
    """Whether an object never moves."""
    spec = structure[cid].spec if cid and cid in structure else None
    return isinstance(spec, ObjectSpec) and is_static(spec)


def _too_late(actor: Actor, statements: list[str], cids: list[str], hit: set[str | None], hard: bool) -> list[str]:
    """Ego's way with braking that does not keep it from whom it hits, or who hits it."""
    s, rate, spec = actor.structure, scope.number(late_rate(hard)), actor.spec
    strikers = _strikers(s, cids)
    met = [c for c in cids if c in hit or None in hit or c in strikers]
    answered = {c for p in spec.phases if p.action == "brake" for c in (p.target, p.trigger and p.trigger.of)}
    others = [c for c in cids if c not in met and c not in answered]  # for these it brakes of its own accord
    things = [scope.reference(s, c) for c in sorted(map(str, hit)) if c in s and _beside(s, c) and _stands(s, c)]
    far = "".join(f"not near(self, {one}) and " for one in things)
    near, seen = "".join(f" or near(self, {one})" for one in things), once_seen(s, others)
    brakes = f"do Stop(line, rate={rate}) until {force(seen)} <= 0{near}" if seen else ""
    lines = around(statements, seen, 6, brakes, when=far)
    pairs = zip(spec.phases, spec.phases[1:], strict=False)
    own = [(p, then.target) for p, then in pairs if (p.action, then.action) == ("brake", "collide")
           and p.target in (None, then.target)]  # fmt: skip
    stood = {c for c in met if stops_before(s[c].spec)}  # type: ignore[arg-type]
    braked = {c for p, c in own if p.speed or p.rate is None and (c not in stood or _crosses(s, str(c)))}
    slowed = {p.target for p in spec.phases if p.action == "collide" and p.speed is not None}
    by_way = {c for c in met if c in braked or c in slowed and _crosses(s, c)}  # its way says how it brakes
    by_way |= {p.target for p in spec.phases if p.action in AT_REST and p.target is not None}
    movers = [c for c in met if c not in by_way and not (_beside(s, c) and _stands(s, c))]
    for c in movers:
        one = scope.reference(s, c)
        need = f"braking_needed(self, {one})"
        when, until, aside = f"{need} > 6", f"{need} <= 0", f", offset={WHERE_IT_IS}"
        if _crosses(s, c):
            when, aside = f"in_way(line, {one}, seconds=FORESEEN)", ""
            until = f"not {when}"
        lines += [f"interrupt when {when}:", f"    do Drive(line, {STILL}, rate={rate}{aside}) until {until}"]
    return lines if others or movers else statements


def late_rate(hard: bool) -> float:
    """m/s2 at which ego brakes too late."""
    return 5.5 if hard else 2.5


def _crosses(structure: Structure, cid: str) -> bool:
    """Whether an object comes into ego's way from the side: from another road, or from beside its own."""
    spec = structure[cid].spec
    return isinstance(spec, ObjectSpec) and spec.placement.position in {*MOVES_OFF_ROAD, *APPROACH_ANGLE}


def _strikers(structure: Structure, cids: list[str]) -> list[str]:
    """Who of them runs into ego."""
    specs = [(c, structure[c].spec) for c in cids]
    return [c for c, s in specs if isinstance(s, ObjectSpec) and hits_ego(s)]


def _beside(structure: Structure, cid: str) -> bool:
    """Whether an object is off the road."""
    spec = structure[cid].spec
    return isinstance(spec, ObjectSpec) and spec.placement.position in MOVES_OFF_ROAD


def _stop_for(actor: Actor, on_foot: list[str], hard: bool, stands: bool) -> list[str]:
    """The interruption of ego's way by a stop for those on foot: it goes on when they have gone by, and has first come
    to a stand where it `stands`."""
    s = actor.structure
    limit, rate = (5.0, min(7.0, HOLDS.get(actor.spec.type, 7.0))) if hard else (3.0, 3.5)
    they = ", ".join(every(s, c) for c in on_foot)
    more = (f", rate={scope.number(rate)}" if hard else "") + (", stands=True" if stands else "")
    room = _room(actor, on_foot)
    more += f", room={scope.number(room)}" if room is not None else ""
    return [
        f"interrupt when {force([in_sight(s, c) for c in on_foot])} > {scope.number(limit)}:  # m/s2",
        f"    do YieldTo(line, [{they}], {actor.speed}{more})",
    ]


def _room(actor: Actor, on_foot: list[str]) -> float | None:
    """The m that S leaves to those on foot as ego stands, or at the nearest; None: it says nothing."""
    rooms = [room for cid in on_foot if (room := room_left(actor.structure, cid)) is not None]
    return min(rooms, default=None)


