"""How drivers other than ego keep clear of those ahead of them, unless they are to hit somebody."""

from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed.ahead import stands_before
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.braking import around, brakes
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.lanes import leaves_behind
from c2s_engine.write.typed.threats import every, is_hit, passed_over
from c2s_engine.write.typed.usual import turn_of


def heeding(actor: Actor, statements: list[str]) -> list[str]:
    """Another driver's way, braking for those ahead in its lane or its row, unless it is to hit somebody."""
    if joins_ego(actor):
        statements = around(statements, ["ego"], 3, brakes(["ego"]), when="self._lane is ego._lane and ")
        row = _row(actor)
        return around(statements, row, 3, brakes(row)) if row else statements
    ego = actor.structure.ego.spec
    hit = isinstance(ego, EgoSpec) and is_hit(ego, actor.cid)
    leads = [c for c in actor.plan.leads.get(actor.cid, ()) if not _gets_past(actor, c) and not (hit and c == "ego")]
    heeded = [*(every(actor.structure, cid) for cid in leads), *_row(actor)]
    beside = isinstance(ego, EgoSpec) and offset(actor.spec, ego, actor.plan.place)  # type: ignore[arg-type]
    if not heeded or beside or actor.value <= 0 or any(p.action == "collide" for p in actor.spec.phases):
        return statements
    return around(statements, heeded, 3, brakes(heeded))


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
