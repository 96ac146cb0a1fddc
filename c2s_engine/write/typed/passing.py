"""Overtaking in closed form: by which side, how much slower one is who is overtaken, how far apart the two start."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import component_of
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.lanes import lane_is_cleared, lane_offset
from c2s_engine.write.typed.tables import LANE_WIDTH, LENGTH, WIDTH, is_static, is_vehicle
from c2s_engine.write.typed.usual import UNDISTURBED, speed_of

FOLLOWS = 5.5
"""s for which one plainly follows another before it pulls out."""
SLOW = 0.6
"""The speed of one that is overtaken, as a share of who overtakes it, where nothing says how fast it is."""
FASTER = {"bicycle": 3.0, "motorcycle": 4.0}
"""m/s by which one overtakes at least, by who is overtaken; else `MUCH`."""
MUCH = 5.0
ASIDE = 2.2
"""s in which one gets out of its lane, or back into it."""
OVER = 1.8
"""s until one that comes back is over the line."""
ROOM = 8.0
"""m that are left to the other when one is out."""
AHEAD = 10.0
"""m, bumper to bumper, before the other from which one comes back."""
BREAKS_OFF = 5.0
"""m/s2 at which one slows down that breaks off."""
BESIDE = 1.5
"""m between one on two wheels and who passes it in their own lane or over its left line."""
GAINS = 3.0
"""m/s2 at which one speeds up to overtake."""
CALMLY, SLACK, STANDSTILL = 2.5, 3.75, 4.0
"""m/s2, m/s (its braking over its time gap) and m by which one comes up to another that it then follows, as
`following_speed` of the driving library has it."""
CAUGHT_UP = 2.0
"""m/s by which one is still faster when it follows."""
NARROW = {"bicycle", "motorcycle"}
CALM = {"keep_lane", "move_along", "follow", "go_straight"}


@dataclass(frozen=True)
class Overtaking:
    """Who (`E` or an object's id) overtakes whom: from which speed at which, past which speed (m/s), over how much (m)
    of the other and itself, from when on (s)."""

    who: str
    whom: str
    phase: Phase
    start: float
    speed: float
    other: float
    bodies: float
    begins: float
    one_lane: bool = True
    follows: bool = False

    @property
    def closing(self) -> float:
        return max(self.speed - self.other, 1.0)

    @property
    def pull_out(self) -> float:
        """The gap (m) at which one pulls out so as to be out of the lane with some room."""
        return pull_out(self.closing, self.phase.abandoned)

    @property
    def gap(self) -> float:
        """The gap (m) at the start from which it is the one at which one pulls out when it `begins`; the one from which
        who follows first slows down for that."""
        if self.follows and self.start > self.other + CAUGHT_UP:
            return ((self.start + SLACK) ** 2 - SLACK**2 - self.other**2) / (2 * CALMLY) + STANDSTILL
        return max(self.pull_out + (self.start - self.other) * self.begins, self.pull_out)

    @property
    def ahead(self) -> float:
        """m before the other from which it comes back."""
        return comes_back(self.phase, self.closing)

    @property
    def abreast(self) -> float:
        """When (s) the two are side by side."""
        return self._gained(self.pull_out + self.bodies / 2)

    @property
    def back(self) -> float:
        """When (s) it is in its lane again."""
        if self.phase.abandoned:
            return self.begins + ASIDE + ROOM / self.closing + ASIDE
        return self._gained(self.pull_out + self.bodies + self.ahead) + ASIDE

    def travelled(self, time: float) -> float:
        """How far (m) it has driven by then, after it pulled out."""
        up = max(self.speed - self.start, 0.0)
        return self.start * min(time, self.begins) + self.speed * max(time - self.begins, 0.0) - up**2 / (2 * GAINS)

    def _gained(self, metres: float) -> float:
        lost = max(self.speed - self.start, 0.0) ** 2 / (2 * GAINS)
        return self.begins + (metres + lost) / self.closing


def caught_up(speed: float, other: float) -> float:
    """When (s) one that comes up to another, from where it begins to slow down for that, plainly follows it."""
    closing = speed - other
    if closing <= CAUGHT_UP:
        return 0.0
    return (closing - CAUGHT_UP + (other + SLACK) * math.log(closing / CAUGHT_UP)) / CALMLY


def pull_out(closing: float, abandoned: bool = False) -> float:
    """The gap (m) at which one pulls out who comes nearer at so many m/s: sooner where it is to stay behind."""
    return ROOM + ASIDE * closing + (to_slow(closing) if abandoned else 0.0)


def to_slow(closing: float) -> float:
    """The gap (m) at which one that is out breaks off so as to stay behind."""
    return closing**2 / (2 * BREAKS_OFF) + 2.0


def comes_back(phase: Phase, closing: float) -> float:
    """How far (m) before the other one begins to come back: so that it is the stated gap as it comes over the line."""
    if phase.gap is None:
        return AHEAD
    return max(middle(phase.gap) - closing * OVER, -0.3 * closing)


def faster(whom: ObjectSpec | EgoSpec | None) -> float:
    """By how much (m/s) one is faster at least who overtakes somebody."""
    return FASTER.get(whom.type, MUCH) if whom is not None else MUCH


def sideways(whom: ObjectSpec | EgoSpec | None) -> float:
    """How far (m) to the side one passes whom it does not change lanes for."""
    if whom is None or whom.type not in NARROW:
        return LANE_WIDTH
    return round((WIDTH["car"] + WIDTH[whom.type]) / 2 + BESIDE - 0.2, 1)


def overtakings(structure: Structure, place: PlaceSpec) -> Iterator[Overtaking]:
    """Who overtakes whom in one direction, first of all that it does, both driving and each told how fast."""
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    for component in (structure.ego, *structure.objects):
        spec = component.spec
        assert isinstance(spec, EgoSpec | ObjectSpec)
        at = next((i for i, p in enumerate(spec.phases) if p.action == "overtake"), None)
        if at is None or not is_vehicle(spec.type) or any(p.action not in CALM or p.trigger for p in spec.phases[:at]):
            continue
        phase = spec.phases[at]
        whom = phase.target or ("ego" if component.id != "E" else next(iter(objects), "ego"))
        other = structure.ego.spec if whom == "ego" else objects.get(whom)
        if whom == component.id or not isinstance(other, EgoSpec | ObjectSpec) or not is_vehicle(other.type):
            continue
        if isinstance(other, ObjectSpec) and (is_static(other) or lane_is_cleared(phase, other)):
            continue
        rows = _row(component.id, objects), _row(whom, objects)
        if rows[0] != rows[1] and not all(isinstance(row, int) for row in rows):
            continue
        if phase.abandoned and any(p.trigger for p in spec.phases[at + 1 : at + 2]):  # that says when
            phase = phase.model_copy(update={"abandoned": False})
        follows = any(p.action == "follow" for p in spec.phases[max(at - 1, 0) : at])
        start, slow = middle(speed_of(spec, place)), _slow(other, objects, place)
        begins = max(FOLLOWS, caught_up(start, slow)) if follows else UNDISTURBED
        if phase.trigger is not None and phase.trigger.kind == "time" and phase.trigger.value is not None:
            begins = middle(phase.trigger.value)
        speed = middle(phase.speed) if phase.speed is not None else max(start, slow + faster(other))
        bodies = LENGTH[spec.type] + LENGTH[other.type]
        yield Overtaking(component.id, whom, phase, start, speed, slow, bodies, begins, rows[0] == rows[1], follows)


def _slow(spec: EgoSpec | ObjectSpec, objects: dict[str, ObjectSpec], place: PlaceSpec) -> float:
    """The speed (m/s) of one that is overtaken: where nothing says it, at most that of whom it follows."""
    own, first = middle(speed_of(spec, place)), next(iter(spec.phases), None)
    if first is None or first.action != "follow" or first.trigger or spec.speed is not None or first.speed is not None:
        return own
    followed = objects.get(first.target or "")
    return own if followed is None else min(own, middle(speed_of(followed, place)))


def passing(structure: Structure, place: PlaceSpec) -> Structure:
    """S with the side of each overtaking in ego's lane, without the change of lane by which it comes back anyhow, and
    with what it leaves open of the two's speeds and of the gap between them."""
    structure = _phases(structure, place)
    for one in overtakings(structure, place):
        structure = _slower(structure, place, one)
    for one in overtakings(structure, place):
        structure = _apart(structure, one) if one.one_lane else structure
    return structure


def _slower(structure: Structure, place: PlaceSpec, one: Overtaking) -> Structure:
    """Who is overtaken is clearly slower: it where its speed is open, else who overtakes it is faster."""
    slow, fast = structure[one.whom if one.whom != "ego" else "E"], structure[one.who]
    least = faster(slow.spec)  # type: ignore[arg-type]
    first = next(iter(getattr(fast.spec, "phases", ())), None)
    follows = first is not None and first.action == "follow" and (first.target or "ego") == one.whom
    if follows and getattr(fast.spec, "speed", None) is None and not _states_speed(fast.spec):
        return structure.with_spec(one.who, speed=one.other)  # it is faster from when it pulls out
    if one.phase.speed is None and one.start - one.other >= least:
        return structure
    if getattr(slow.spec, "speed", None) is None and one.whom != "ego" and not _states_speed(slow.spec):
        start = one.start
        own = structure.ego.spec
        oncoming = _row(one.who, _objects(structure)) == "oncoming_lane"
        if oncoming and getattr(fast.spec, "speed", None) is None:  # as fast as one drives there
            start = max(start, middle(speed_of(own, place)))  # type: ignore[arg-type]
            structure = structure.with_spec(one.who, speed=round(start, 1))
        return structure.with_spec(one.whom, speed=round(min(SLOW * start, one.other), 1))
    if getattr(fast.spec, "speed", None) is None and not _states_speed(fast.spec):
        return structure.with_spec(one.who, speed=round(one.other + least, 1))
    return structure


def _states_speed(spec: object) -> bool:
    """Whether its first phase says how fast it drives."""
    phases: tuple[Phase, ...] = getattr(spec, "phases", ())
    return bool(phases) and phases[0].action in CALM and phases[0].speed is not None


def _apart(structure: Structure, one: Overtaking) -> Structure:
    """The gap between the two, where it is open: one drives at its speed for a while, and then pulls out."""
    gap = round(one.gap, 1)
    for cid, of, position in ((one.whom, one.who, "ahead"), (one.who, one.whom, "behind")):
        spec = structure[cid].spec if cid not in ("ego", "E") else None
        if not isinstance(spec, ObjectSpec):
            continue
        at = spec.placement
        near = {"ahead": "ahead", "behind": "behind"}.get(at.along or at.position)
        named = at.of if at.of != "ego" else "E"
        if near == position and named == component_of(of) and at.gap is None:
            return structure.with_spec(cid, placement=at.model_copy(update={"gap": gap}))
    return structure


def _objects(structure: Structure) -> dict[str, ObjectSpec]:
    return {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}


def _row(cid: str, objects: dict[str, ObjectSpec]) -> int | str | None:
    """The lane in which one starts: how many to the left of ego's, or the position that names it."""
    if cid in ("ego", "E"):
        return 0
    if cid not in objects:
        return None
    lane, spec = lane_offset(cid, objects), objects[cid]
    while lane is None and spec.placement.position in ("ahead", "behind") and spec.placement.of in objects:
        spec = objects[spec.placement.of]
    return lane if lane is not None else spec.placement.position


def _phases(structure: Structure, place: PlaceSpec) -> Structure:
    objects = _objects(structure)
    for component in (structure.ego, *structure.objects):
        spec = component.spec
        if not isinstance(spec, EgoSpec | ObjectSpec) or all(p.action != "overtake" for p in spec.phases):
            continue
        own = lane_offset(component.id, objects) if component.id in objects else 0
        phases: list[Phase] = []
        for i, phase in enumerate(spec.phases):
            then = spec.phases[i + 1] if i + 1 < len(spec.phases) else None
            moving = then is not None and then.target in objects and not is_static(objects[then.target])
            if then is not None and moving and own == _lane_of(then.target, objects) and _pulls_out(phase, then):
                continue
            if phase.action == "overtake" and own == 0 == _lane_of(phase.target, objects):
                whom = structure.ego.spec if phase.target in (None, "ego") else objects.get(phase.target)
                phases.append(phase if lane_is_cleared(phase, whom) else _sided(phase, place))  # type: ignore[arg-type]
            elif not (phases and own == _lane_of(phases[-1].target, objects) and _comes_back(phases[-1], phase)):
                phases.append(phase)
        if tuple(phases) != spec.phases:
            structure = structure.with_spec(component.id, phases=tuple(phases))
    return structure


def _lane_of(cid: str | None, objects: dict[str, ObjectSpec]) -> int | None:
    """How many lanes to the left of ego's one starts who is overtaken."""
    return lane_offset(cid, objects) if cid in objects else 0


def _sided(phase: Phase, place: PlaceSpec) -> Phase:
    """An overtaking on the right where ego's lane is the leftmost of several."""
    by_oncoming = place.lanes is None and place.oncoming is True
    if phase.side is not None or place.ego_lane != "leftmost" or place.lanes == 1 or by_oncoming:
        return phase
    return phase.model_copy(update={"side": "right"})


def _pulls_out(phase: Phase, then: Phase) -> bool:
    """Whether a change of lane is no more than the beginning of the overtaking after it."""
    sided = (phase.side or "left") == (then.side or "left")
    return then.action == "overtake" and phase.action == "lane_change" and not (phase.trigger or then.trigger) and sided


def _comes_back(before: Phase, phase: Phase) -> bool:
    """Whether a phase is no more than the end of the overtaking before it."""
    if before.action != "overtake" or phase.action != "lane_change" or phase.trigger is not None:
        return False
    return (phase.side or "left") == ("left" if before.side == "right" else "right")
