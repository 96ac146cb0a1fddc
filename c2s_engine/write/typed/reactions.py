"""Reactions: what drivers do when others force them to, laid around what they do of their own accord."""

import math
import re

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.structure.triggers import gives_way_by
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.ahead import stands_before
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.collisions import stops_before
from c2s_engine.write.typed.course import WHERE_IT_IS, Actor
from c2s_engine.write.typed.evasion import grip
from c2s_engine.write.typed.lanes import leaves_behind, leaves_lane
from c2s_engine.write.typed.plan import Plan
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
    passed_over,
    room_left,
    threatening,
)
from c2s_engine.write.typed.threats import on_foot as threats_on_foot
from c2s_engine.write.typed.usual import crosses, rides_beside, turn_of

SOFT, HARD = 1.0, 4.5
"""m/s2 at least with which drivers brake for who forces them to; a little more than it takes."""
CAREFUL = 1.5
"""m/s2 that it takes by then, where ego has just set out from where it stopped."""
FULL = {"wet": 7.0, "rain": 7.0, "heavy_rain": 6.0, "snow": 4.0}
"""m/s2 of an emergency braking, by the weather; else `DRY`."""
DRY = 8.0
HOLDS = {"bicycle": 5.0, "truck": 7.0, "bus": 7.0}
"""m/s2 at most, by what ego is: a rider goes over the bars beyond."""
LAST_MOMENT = 0.7
"""The share of an emergency braking that it takes when that begins."""
LAST = 6.0
"""m/s2 that it takes by then, where S says of no such reaction."""
STILL = 3
"""m/s at which ego still is when it reaches whom it brakes for too late."""


def reaction(actor: Actor, statements: list[str]) -> list[str]:
    """Ego's way with its reaction laid around it; with any, it runs into nobody whom S does not say it hits."""
    found = _reaction(actor, statements)
    spec = actor.spec
    assert isinstance(spec, EgoSpec)
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
    gone_round = {_about(p) or spec.react_to for p in spec.phases if p.action in (*ASIDE, "overtake", "oncoming")}
    apart = {*gone_round, *([spec.react_to] if spec.reaction == "follow" else [])}
    apart |= {p.target for p in spec.phases if p.clearance is not None and p.trigger is None}  # with room of its own
    apart |= _given_way_to(s)
    cids = [c for c in threatening(s) if c not in apart and not is_hit(spec, c) and not _stays_behind(s, c)]
    heeded = {name for line in statements if line.startswith("interrupt") for name in re.findall(r"\w+", line)}
    strikers = _strikers(s, cids)
    seen = once_seen(s, [c for c in cids if c not in strikers and scope.reference(s, c).split("[")[0] not in heeded])
    if reacts:
        return [*statements, *_around([], seen, LAST, _brakes(seen, HARD))[1:]]
    return _around(statements, seen, LAST, _brakes(seen, HARD)) if seen else statements


def _given_way_to(structure: Structure) -> set[str]:
    """Those who come towards ego, where it breaks an overtaking off: that is how it answers them."""
    broken_off = any(p.action == "overtake" and p.abandoned for p in getattr(structure.ego.spec, "phases", ()))
    return {c.id for c in structure.objects if broken_off and _position(structure, c.id) == "oncoming_lane"}


def _reaction(actor: Actor, statements: list[str]) -> list[str]:
    """Ego's reaction laid around its own way: what it does when something forces it to."""
    spec = actor.spec
    assert isinstance(spec, EgoSpec)
    cids = threatening(actor.structure)
    hit = {p.target for p in spec.phases if p.action == "collide"}
    cids = [c for c in cids if spec.reaction != "yield" or c not in hit]
    if spec.reaction == "yield" and cids:  # whom it let pass may then be ahead
        passed = {p.action for p in spec.phases} & {*ASIDE, "overtake", "oncoming"}
        overtaken = {p.target for p in spec.phases if p.action == "overtake"}
        still = [c for c in cids if is_static(actor.structure[c].spec) or c in overtaken]  # type: ignore[arg-type]
        braked_for = [c for c in cids if c not in still or not passed]
        if _waits_for(spec, spec.react_to or ""):  # it stops short of their ways itself
            braked_for = [c for c in braked_for if _comes_by(actor, c) not in {*APPROACH_ANGLE} - {"circulating"}]
        seen = once_seen(actor.structure, braked_for)
        return _around(statements, seen, 3, _brakes(seen)) if braked_for else statements
    leads = [c for c in cids if c == spec.react_to and _position(actor.structure, c) == "ahead"]
    calm = {"follow", "keep_lane", "overtake", "collide"}
    if spec.reaction == "follow" and leads and not {p.action for p in spec.phases} <= calm:
        seen = once_seen(actor.structure, leads)
        return _around(statements, seen, 3, _brakes(seen))
    round_it = {p.target for p in spec.phases if p.action == "overtake" and not _slows(actor.structure, p.target)}
    round_it |= {p.target for p in spec.phases if p.clearance is not None}  # or keeps its own room to them
    round_it |= _given_way_to(actor.structure)
    said = {p.target for p in spec.phases if p.action == "brake" and p.rate is not None and p.trigger is None}
    cids = [c for c in cids if c not in (*round_it, *said)]  # ego drives past these, or brakes as hard as S says
    if spec.reaction != "brake" or not cids or spec.react_to in {c for c in round_it if _stands(actor.structure, c)}:
        return statements
    strikers = [] if hit else _strikers(actor.structure, cids)
    if hit or strikers and (spec.react_to in strikers or len(strikers) == len(cids)):  # it brakes, but too late
        return _too_late(actor, statements, cids, hit, spec.hard)
    cids = [c for c in cids if c not in strikers and not _stays_behind(actor.structure, c)]
    if not cids:
        return statements
    named = spec.react_to is not None and spec.react_to in actor.structure
    threats = once_seen(actor.structure, [spec.react_to] if spec.react_to and named else cids)
    forced = {p.action for p in spec.phases if p.trigger is None}
    limit, rate = (3.5, HARD) if spec.hard else (2.5, SOFT)
    if "stop" in forced and any(_position(actor.structure, c) in APPROACH_ANGLE for c in cids):
        limit = CAREFUL
    if "swerve" in forced:  # it gets past first
        return _around(statements, threats, 8, _brakes(threats, HARD))
    if "lane_change" in forced:  # where it brakes first it goes on with that on its way over
        limit = 8 if "brake" in {p.action for p in spec.phases} else 5
        return _around(statements, threats, limit, _brakes(threats, HARD, release=2))
    on_foot = [c for c in threats_on_foot(actor.structure) if spec.react_to in (None, c)]
    stands = is_stopped(spec) or _ends_standing(actor.structure)
    stops_for = {p.target for p in spec.phases if p.action == "stop"}
    full = min(grip(actor.structure, FULL, DRY), HOLDS.get(spec.type, DRY)) if spec.hard and not stands else 0
    stated = [middle(p.rate) for p in spec.phases if p.action in ("brake", "stop") and p.rate is not None]
    full = min(stated[0] if full and stated else full, _hardest(actor.structure))
    limit = round(LAST_MOMENT * full, 1) if full else limit
    if not on_foot:
        brakes = _stops(threats, full) if full else _brakes(threats, rate, stands=limit if stands else 0)
        ring = [c for c in cids if _position(actor.structure, c) == "circulating"]
        if ring and not full:  # it goes in behind them
            force = _force(threats)
            room = (f"gap(self, {every(actor.structure, c)}) > self.speed" for c in ring)
            over = " and ".join([f"{force} <= 0", *room])
            brakes = f"do Stop(line, rate=lambda: max({scope.number(rate)}, min(9, 1.1 * {force}))) until {over}"
        return [*_around(statements, threats, limit, brakes), *_goes_on_behind(actor, cids)]
    others = [] if spec.react_to else once_seen(actor.structure, [c for c in cids if c not in on_foot])
    before_them = _ends_standing(actor.structure) or stands and not stops_for.isdisjoint({None, *on_foot})
    return [
        *_around(statements, others, limit, _brakes(others, rate, stands=limit if stands else 0) if others else ""),
        *_stop_for(actor, on_foot, spec.hard, before_them),
    ]


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
    brakes = f"do Stop(line, rate={rate}) until {_force(seen)} <= 0{near}" if seen else ""
    lines = _around(statements, seen, 6, brakes, when=far)
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


def _force(threats: list[str]) -> str:
    """The need (m/s2) to brake for one or several."""
    alone = threats[0].removeprefix("*") if len(threats) == 1 else f"[{', '.join(threats)}]"
    return f"braking_needed(self, {alone})"


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
        f"interrupt when {_force([in_sight(s, c) for c in on_foot])} > {scope.number(limit)}:  # m/s2",
        f"    do YieldTo(line, [{they}], {actor.speed}{more})",
    ]


def _room(actor: Actor, on_foot: list[str]) -> float | None:
    """The m that S leaves to those on foot as ego stands, or at the nearest; None: it says nothing."""
    rooms = [room for cid in on_foot if (room := room_left(actor.structure, cid)) is not None]
    return min(rooms, default=None)


def heeding(actor: Actor, statements: list[str]) -> list[str]:
    """Another driver's way, braking for those ahead in its lane or its row, unless it is to hit somebody."""
    if joins_ego(actor):
        statements = _around(statements, ["ego"], 3, _brakes(["ego"]), when="self._lane is ego._lane and ")
        row = _row(actor)
        return _around(statements, row, 3, _brakes(row)) if row else statements
    ego = actor.structure.ego.spec
    hit = isinstance(ego, EgoSpec) and is_hit(ego, actor.cid)
    leads = [c for c in actor.plan.leads.get(actor.cid, ()) if not _gets_past(actor, c) and not (hit and c == "ego")]
    heeded = [*(every(actor.structure, cid) for cid in leads), *_row(actor)]
    beside = isinstance(ego, EgoSpec) and offset(actor.spec, ego, actor.plan.place)  # type: ignore[arg-type]
    if not heeded or beside or actor.value <= 0 or any(p.action == "collide" for p in actor.spec.phases):
        return statements
    return _around(statements, heeded, 3, _brakes(heeded))


def _row(actor: Actor) -> list[str]:
    """The row that a driver is in, if it is in one: each keeps clear of the one before it."""
    return [every(actor.structure, actor.cid)] if getattr(actor.spec, "count", 1) > 1 else []


_BEHIND = {  # where ways over a junction lead, seen from ego's approach
    "crossing_left": {"LEFT_TURN": "straight", "STRAIGHT": "right"},
    "crossing_right": {"STRAIGHT": "left", "RIGHT_TURN": "straight"},
    "opposite_approach": {"LEFT_TURN": "right", "RIGHT_TURN": "left"},
}


def joins_ego(actor: Actor) -> bool:
    """Whether a driver from another approach comes onto the road on which ego leaves the junction."""
    spec = actor.spec
    if not isinstance(spec, ObjectSpec) or actor.value <= 0 or any(p.action == "collide" for p in spec.phases):
        return False
    onto = _BEHIND.get(spec.placement.position, {}).get(turn_of(spec.phases))
    struck = any(p.action == "collide" for p in getattr(actor.structure.ego.spec, "phases", ()))
    return actor.plan.place.kind == "intersection" and onto == actor.plan.place.manoeuvre and not struck


def _gets_past(actor: Actor, cid: str) -> bool:
    """Whether it means to get past what stands ahead of it."""
    if leaves_behind(actor.spec) and actor.spec.placement.of == cid:  # type: ignore[union-attr]
        return True
    if cid != "ego" and passed_over(actor.structure, cid, actor.cid):
        return True
    if any(p.action in ("overtake", "swerve", "cut_in") and (p.target or "ego") == cid for p in actor.spec.phases):
        return True
    near = (p.trigger for p in actor.spec.phases if p.trigger and p.action in ("lane_change", "cut_in", "swerve"))
    if any(t.kind in ("distance", "ttc") and (t.of or "ego") == cid for t in near):
        return True
    if cid == "ego" or not {"cut_out", "lane_change", "swerve", "overtake"} & {p.action for p in actor.spec.phases}:
        return False
    return stands_before(actor.structure, actor.cid, cid)


def _around(statements: list[str], threats: list[str], limit: float, brakes: str, when: str = "") -> list[str]:
    """The statements, interrupted by `brakes` when the need (m/s2) for one of the threats is over `limit`; `when`: a
    condition of that, with its `and`."""
    head, rest = statements[:1], statements[1:]
    around = [*head, "try:", *(f"    {s}" for s in rest)]
    if not threats:
        return around
    return [*around, f"interrupt when {when}{_force(threats)} > {scope.number(limit)}:  # m/s2", f"    {brakes}"]


def _brakes(threats: list[str], least: float = SOFT, release: float = 0, stands: float = 0) -> str:
    """Braking with `least` m/s2 or more until the need of it is no more than `release`, or to a stand and until it is
    no more than `stands`."""
    more = f", least={scope.number(least)}" if least != SOFT else ""
    more += f", stands={scope.number(stands)}" if stands else f", release={scope.number(release)}" if release else ""
    return f"do BrakeFor(line, {_them(threats)}{more})"


def _stops(threats: list[str], rate: float) -> str:
    """To a stand with all that the road holds (m/s2), until the cause is gone."""
    return f"do EmergencyStop(line, {_them(threats)}{f', rate={scope.number(rate)}' if rate != DRY else ''})"


def _them(threats: list[str]) -> str:
    """One or several, as an argument: by a function where it changes who of them is to be seen."""
    if len(threats) == 1 and re.fullmatch(r"\w+", threats[0]):
        return threats[0]
    listed = f"[{', '.join(threats)}]"
    return listed if all(re.fullmatch(r"\*?[\w\[\]-]+", t) for t in threats) else f"lambda: {listed}"


def _stands_first(spec: EgoSpec) -> int:
    """How many of ego's phases, the first of them, are about standing before the junction."""
    moves = (i for i, p in enumerate(spec.phases) if p.action not in AT_REST or p.trigger is not None)
    return next(moves, 0)


def _cut_off(spec: EgoSpec, structure: Structure, plan: Plan) -> str | None:
    """The rider beside the road whose way ego would cut off by its turn to the right, and whom it lets pass first."""
    if not plan.junction or plan.place.manoeuvre != "right" or spec.reaction not in ("brake", "yield"):
        return None
    objects = [(c.id, c.spec) for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    riders = [(cid, o) for cid, o in objects if rides_beside(o) and not (hits_ego(o) or is_hit(spec, cid))]
    riders = [(cid, o) for cid, o in riders if not AT_REST & {p.action for p in o.phases}]
    coming = [cid for cid, o in riders if o.placement.along in ("behind", "abreast") and o.placement.of == "ego"]
    return next((cid for cid in coming if cid != spec.react_to or spec.reaction == "brake"), None)


def _waits_for(spec: EgoSpec, cid: str) -> bool:
    """Whether ego's phases say themselves that it stands for somebody, or until that one has gone by."""
    for i, p in enumerate(spec.phases):
        after = [q.trigger for q in spec.phases[i + 1 : i + 2]]
        ends = [t for t in (p.until, *after) if t is not None and t.kind in ("passed", "place")]
        if p.action in AT_REST and (p.target == cid or any(t.subject == cid for t in ends)):
            return True
    return False


def _about(phase: Phase) -> str | None:
    """Whom one answers in a phase: whom it names, or for what it waits to be done."""
    return phase.target or (phase.trigger.of if phase.trigger and phase.trigger.kind == "action" else None)


def _behind(structure: Structure, cid: str) -> bool:
    """Whether an object starts behind ego, or in the queue there."""
    spec = structure[cid].spec if cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.position != "behind":
        return False
    return spec.placement.of == "ego" or _behind(structure, spec.placement.of)


def reacting_phases(spec: EgoSpec, others: list[str], structure: Structure, plan: Plan) -> tuple[Phase, ...]:
    """Ego's phases with those that its place and its reaction add: merging, leaving, yielding, evading."""
    phases = spec.phases
    changes = {"lane_change", "cut_in", "overtake"} & {p.action for p in phases}
    if plan.place.kind == "on_ramp" and not changes:
        spec = spec.model_copy(update={"phases": (*phases, Phase(action="lane_change", side="left"))})
    if plan.place.kind == "off_ramp" and -1 in plan.offsets and not changes:
        spec = spec.model_copy(update={"phases": (*phases, Phase(action="lane_change", side="right"))})
    actions = {p.action for p in spec.phases}
    hit = {p.target for p in spec.phases if p.action == "collide"}
    if "yield" not in actions and (rider := _cut_off(spec, structure, plan)):
        spec = spec.model_copy(update={"phases": (Phase(action="yield", target=rider), *spec.phases)})
    whom, yields = spec.react_to or next(iter(others), ""), spec.reaction == "yield" and "yield" not in actions
    slows = ("brake", "stop", "wait")
    named = (whom,) if plan.junction else (whom, None)
    told = any(p.abandoned or p.action in slows and _about(p) in named for p in spec.phases)  # it says how
    yields = yields and not told
    if yields and _behind(structure, whom) and leaves_lane(spec):
        return spec.phases  # out of the way of who comes from behind: that lets it pass
    if yields and whom not in ("", *hit) and not gives_way_by(spec) and not _waits_for(spec, whom):
        yielding = Phase(action="yield", target=whom)
        if plan.junction and (stands := _stands_first(spec)):
            return (*spec.phases[:stands], yielding, *spec.phases[stands:])
        return (yielding, *spec.phases)
    if spec.reaction == "evade" and others and not actions & {*ASIDE, "overtake", "oncoming"}:
        return (*spec.phases, Phase(action="swerve", target=spec.react_to or threatening(structure)[0]))
    walks = [c for c in others if isinstance(o := structure[c].spec, ObjectSpec) and crosses(o)]
    if spec.reaction != "brake" or plan.junction or len(walks) != 1:
        return spec.phases
    bare = [p for p in spec.phases if p.action == "stop" and not (p.target or p.trigger or p.until or p.clearance)]
    return tuple(p.model_copy(update={"target": walks[0]}) if p in bare else p for p in spec.phases)  # for that one
