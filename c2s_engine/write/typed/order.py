"""Who goes first where some stop at a junction: of all who stop there, as at a four-way stop, each waits for those
before it; ego, who stands there, also for those who come by without a stop."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.tables import APPROACH_ANGLE, AT_REST

PASSES = {"go_straight", "turn_left", "turn_right", "keep_lane", "move_along", "accelerate"}
"""What somebody does who comes by without a stop."""
GOES = {"start", "go_straight", "turn_left", "turn_right", "accelerate"}
"""What somebody does who sets out from where it stopped."""
OWN = {"yield", "collide", "run_stop", "run_red"}
"""What itself says when somebody drives into the junction."""


def goes_after(structure: Structure, cid: str) -> list[str]:
    """The ids of those who drive into the junction before `cid` ("E": ego), who stands there, and cross its way."""
    line = _line(structure)
    earlier = line[: line.index(cid)] if cid in line else []
    if cid == "E" and _stands(structure.ego.spec.phases):  # type: ignore[union-attr]
        earlier += [c.id for c in structure.objects if isinstance(c.spec, ObjectSpec) and _comes_by(c.spec)]
    return [other for other in earlier if _cross(structure, cid, other)]


def _stands(phases: tuple[Phase, ...]) -> bool:
    """Whether somebody stops or stands first, for as long as it takes, and then goes."""
    first = [p for p in phases[:2] if p.action in AT_REST]
    free = all(p.trigger is None and p.duration is None for p in phases)
    return bool(first) and first[0] is phases[0] and free and bool(GOES & {p.action for p in phases})


def _comes_by(spec: ObjectSpec) -> bool:
    """Whether one drives over the junction from another road and does nothing about anybody."""
    return spec.placement.position in APPROACH_ANGLE and {p.action for p in spec.phases} <= PASSES and spec.speed != 0


def _line(structure: Structure) -> list[str]:
    """All who stop there, as they go: ego first, or after those that it yields to; the others as S names them, those
    opposite each other one after the other."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    others = [c.id for c in structure.objects if isinstance(c.spec, ObjectSpec) and _sets_out(c.spec)]
    if not others or not _stops(ego.phases) and place.control != "stop":
        return _paired(structure, others)
    yielded = [p.target for p in ego.phases if p.action == "yield"]
    if ego.reaction != "yield" and not yielded:
        return _paired(structure, others if OWN & {p.action for p in ego.phases} else ["E", *others])
    others = _paired(structure, others)
    last = next((c for c in [*yielded, ego.react_to] if c), others[-1])
    at = others.index(last) + 1 if last in others else len(others)
    return [*others[:at], "E", *others[at:]]


def _paired(structure: Structure, cids: list[str]) -> list[str]:
    """The same, those first who come by the road of the first one."""
    return sorted(cids, key=lambda c: (_angle(structure, c) - _angle(structure, cids[0])) % 180)


def _sets_out(spec: ObjectSpec) -> bool:
    """Whether one that comes by another road stops at the junction and then drives on."""
    own = spec.count > 1 or OWN & {p.action for p in spec.phases}
    return spec.placement.position in APPROACH_ANGLE and not own and _stops(spec.phases)


def _stops(phases: tuple[Phase, ...]) -> bool:
    """Whether a stop comes first in what somebody does, and going on after that."""
    actions = [p.action for p in phases]
    return actions[:1] == ["stop"] and bool(GOES & set(actions[1:])) and not any(p.trigger for p in phases)


def _cross(structure: Structure, one: str, other: str) -> bool:
    """Whether two who stop there come by roads that cross, or opposite each other with a left turn of one."""
    apart = (_angle(structure, one) - _angle(structure, other)) % 360
    return apart in (90, 270) or apart == 180 and (turns_left(structure, one) or turns_left(structure, other))


def _angle(structure: Structure, cid: str) -> int:
    spec = structure.ego.spec if cid == "E" else structure[cid].spec
    return APPROACH_ANGLE.get(spec.placement.position, 0) if isinstance(spec, ObjectSpec) else 0


def turns_left(structure: Structure, cid: str) -> bool:
    spec = structure.ego.spec if cid == "E" else structure[cid].spec
    turns = any(p.action == "turn_left" for p in getattr(spec, "phases", ()))
    return turns or cid == "E" and getattr(structure.place.spec, "manoeuvre", None) == "left"
