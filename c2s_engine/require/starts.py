"""Each object starts where S says: in which lane, on which side, how far, facing where, seen or hidden."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import Evidence
from c2s_engine.require.results import between, decided, scored, span, unknown, words
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.vocabulary import FOUR_WHEELED, SIDED

LANES = {
    "ahead": ("same",), "behind": ("same",), "left_lane": ("left",), "right_lane": ("right",),
    "oncoming_lane": ("oncoming",), "crossing_left": ("crossing",), "crossing_right": ("crossing",),
    "opposite_approach": ("oncoming",), "roadside": ("roadside", "sidewalk"), "sidewalk": ("sidewalk", "roadside"),
    "parked": ("roadside", "sidewalk"),
}  # fmt: skip
"""The lane relations that show a position (any of them); others are judged by where they lie."""
LENGTHWISE = {"ahead": "ahead", "behind": "behind", "oncoming_lane": "ahead", "opposite_approach": "ahead",
              "circulating": "ahead", "roadside": "ahead", "sidewalk": "ahead", "parked": "ahead",
              "partly_in_lane": "ahead", "intersection_exit": "ahead"}  # fmt: skip
SIDEWAYS = {"left_lane": "left", "right_lane": "right", "crossing_left": "left", "crossing_right": "right"}
LANE = 3.5
"""m, of most maps' lanes: so far to the side one is beyond the next lane."""
RIDERS = ("bicycle", "motorcycle")
"""Who is beside another in its lane or at its edge, too."""
NEXT_LANES = ("left_lane", "right_lane")
APPROACHES = ("opposite_approach", "crossing_left", "crossing_right", "circulating", "oncoming_lane")
OFF_LANES = ("roadside", "sidewalk", "parked")
ACROSS = 0.7
"""The sine of the angle to ego's way from which one looks across it."""


def required(scene: Scene) -> Iterator[Requirement]:
    for actor, spec in scene.objects.items():
        if scene.says(actor, "placement"):
            for rule in _RULES:
                yield from rule(scene, actor, spec)


def _over_lanes(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place = spec.placement
    if place.lanes_over > 1 and place.position in SIDEWAYS:
        sign = 1 if place.position == "left_lane" else -1
        text = f"{scene.named(actor)} starts {place.lanes_over} lanes to the {SIDEWAYS[place.position]} of " \
            f"{scene.named(place.of)}."  # fmt: skip
        yield scene.make("start", "lanes_over", actor, "placement.lanes_over", text, other=place.of,
                         over=sign * place.lanes_over)  # fmt: skip


def _in_lane(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place, lanes = spec.placement, _lanes(scene, spec)
    beyond = place.lateral is not None and low(place.lateral) > LANE or place.lanes_over > 1  # not the next lane
    beside = place.position in ("beside", *NEXT_LANES) and place.of == EGO
    if lanes and not beyond and not (beside and scene.place.kind == "on_ramp"):  # by the ramp, not yet next to it
        where = place.position.replace("_", " ")
        text = f"{scene.named(actor)} starts, relative to {scene.named(place.of)}: {where}."
        yield scene.make("start", "start_lane", actor, "placement.position", text, other=place.of, lanes=lanes,
                         where=where)  # fmt: skip


def _lanes(scene: Scene, spec: ObjectSpec) -> tuple[str, ...]:
    """The lane relations that show where somebody is; none: it is judged by where it lies."""
    place = spec.placement
    if _at_door(scene, spec):
        return ()
    if place.position == "beside":
        next_to = (place.side,) if place.side else ("adjacent",)
        return (*next_to, "same", "roadside", "sidewalk") if spec.type in RIDERS else next_to
    lanes = LANES.get(place.position, ())
    at_ring = scene.place.kind == "roundabout" and "crossing" in lanes
    return ("crossing", "oncoming") if at_ring else lanes  # arms meet at any angle


def _lengthwise(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place = spec.placement
    along: str | None = place.along
    if along is None and place.hidden_by is None:  # else where it is not seen
        along = "abreast" if place.position == "beside" else LENGTHWISE.get(place.position)
    if along and not (along == "ahead" and place.gap is not None and low(place.gap) <= 0):
        text = f"{scene.named(actor)} starts, relative to {scene.named(place.of)}: {along}."
        yield scene.make("start", "start_along", actor, "placement.along", text, other=place.of, along=str(along))


def _to_side(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place = spec.placement
    side = SIDEWAYS.get(place.position) or (place.side if place.position in SIDED else None)
    if side and (place.position != "beside" or spec.type in RIDERS):
        seen_from = EGO if place.position in OFF_LANES else place.of  # the side of the road, whoever stands there
        yield scene.make("start", "start_side", actor, "placement.side", f"{scene.named(actor)} starts to the {side} "
                         f"of {scene.named(seen_from)}.", other=seen_from, side=str(side))  # fmt: skip


def _beside_or_partly(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place, name = spec.placement, scene.named(actor)
    if place.position in OFF_LANES and not _at_door(scene, spec):
        yield scene.make("start", "off_lanes", actor, "placement.off_lanes", f"{name} starts off the driving lanes.",
                         other=place.of)  # fmt: skip
    if place.position == "partly_in_lane":
        text = f"{name} stands partly in the lane of {scene.named(place.of)}."
        yield scene.make("start", "partly_in", actor, "placement.partly", text, other=place.of)


def _apart(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place, name, of = spec.placement, scene.named(actor), scene.named(spec.placement.of)
    if place.gap is not None and scene.stated(actor, "placement.gap") and place.position not in SIDEWAYS:
        least, most = low(place.gap), high(place.gap)
        far = f"{least:g} m" if least == most else f"{least:g} to {most:g} m"
        yield scene.make("start", "start_gap", actor, "placement.gap", f"{name} starts {far} from {of}.",
                         other=place.of, least=least, most=most)  # fmt: skip
    if place.lateral is not None and scene.stated(actor, "placement.lateral"):
        least, most = low(place.lateral), high(place.lateral)
        text = f"{name} starts with {least:g} m between it and {of} across the road."
        yield scene.make("start", "lateral", actor, "placement.lateral", text, other=place.of, least=least, most=most)


def _out_of_sight(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place = spec.placement
    if place.hidden_by is None:
        return
    hider, by_road = scene.objects.get(place.hidden_by), place.position in APPROACHES
    passes = place.position in OFF_LANES and hider is not None and hider.placement.position in NEXT_LANES
    comes = by_road or passes
    text = f"{scene.named(actor)} is hidden from ego by {scene.named(place.hidden_by)} " \
        f"{'as it comes' if comes else 'at first'}."  # fmt: skip
    kind, check = ("place", "comes_hidden") if comes else ("start", "hidden")
    yield scene.make(kind, check, actor, "placement.hidden_by", text, other=place.hidden_by,  # type: ignore[arg-type]
                     at_first=by_road)  # fmt: skip


def _facing(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    way = spec.placement.facing
    if way in ("along", "against") and spec.type not in ("pedestrian", "child", "animal"):
        yield scene.make("start", "facing", actor, "placement.facing", f"{scene.named(actor)} faces {way} the road.",
                         against=way == "against")  # fmt: skip


_RULES = (_over_lanes, _in_lane, _lengthwise, _to_side, _beside_or_partly, _apart, _out_of_sight, _facing)
"""What of a placement is required, each where S says it."""


def _at_door(scene: Scene, spec: ObjectSpec) -> bool:
    """Whether somebody on foot steps out of a vehicle that stands beside the road, onto the side of the traffic."""
    place, other = spec.placement, scene.objects.get(spec.placement.of)
    steps_out = place.along == "abreast" and any(p.action == "enter_road" for p in spec.phases)
    vehicle = other is not None and other.type in FOUR_WHEELED and other.placement.position in OFF_LANES
    return vehicle and spec.type in ("pedestrian", "child") and (place.position == "beside" or steps_out)


def _fact(requirement: Requirement, evidence: Evidence):  # type: ignore[no-untyped-def]
    """How the first member stands to the other at the start; None where one of the two is not there."""
    members, others = evidence.members(requirement.actor), evidence.members(requirement.other or EGO)
    return members[0].starts.get(others[0].name) if members and others else None


def start_lane(requirement: Requirement, evidence: Evidence) -> Result:
    fact = _fact(requirement, evidence)
    said = str(requirement.values["where"])
    lanes = requirement.values["lanes"]
    assert isinstance(lanes, tuple)
    if fact is None:
        return unknown(requirement, said, "one of the two is not there")
    return decided(requirement, bool(set(lanes) & set(fact.lanes)), said, ", ".join(fact.lanes) or "in no lane", 0.0)


def start_along(requirement: Requirement, evidence: Evidence) -> Result:
    fact, said = _fact(requirement, evidence), str(requirement.values["along"])
    if fact is None:
        return unknown(requirement, said, "one of the two is not there")
    seen = "ahead" if _ahead(requirement, evidence, "ahead" in fact.relations) else "behind"
    if said == "abreast":
        limit = bounds()["start"]["abreast"]["value"]
        one, late = evidence.motion(requirement.actor), max(0.0, fact.gap - 0.8 * limit)
        due = late / max(float(one.speed[0]), 1.0) * (-1.0 if seen == "behind" else 1.0) if one and late else None
        return scored(requirement, (limit - fact.gap) / limit, f"abreast (within {limit:g} m)",
                      f"{fact.gap:.1f} m {seen}", 0.0, due=due)  # fmt: skip
    return decided(requirement, seen == said, said, f"{fact.gap:.1f} m {seen}", 0.0)


def _ahead(requirement: Requirement, evidence: Evidence, otherwise: bool) -> bool:
    """Whether one starts ahead of another: of one who looks across the road, along ego's way."""
    one, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    ego = evidence.motion(EGO)
    if one is None or other is None or ego is None or not one.course.ego_along or not other.course.ego_along:
        return otherwise
    across = abs(np.sin(other.heading[0] - ego.heading[0])) > ACROSS and other.course.stays[0].kind != "lane"
    return bool(one.course.ego_along[0] > other.course.ego_along[0]) if across else otherwise


def start_side(requirement: Requirement, evidence: Evidence) -> Result:
    """Of who comes to ego's junction from another arm, on which side that joins: it may bend."""
    fact, said = _fact(requirement, evidence), str(requirement.values["side"])
    if fact is None:
        return unknown(requirement, said, "one of the two is not there")
    sides = [lane.rpartition("_")[2] for lane in fact.lanes if lane.startswith("crossing_")] or \
        [r.rpartition("_")[2] for r in fact.relations if "_" in r] or \
        [r for r in fact.relations if r in ("left", "right")]  # fmt: skip
    return decided(requirement, said in sides, said, ", ".join(sides), 0.0)


def start_gap(requirement: Requirement, evidence: Evidence) -> Result:
    """Of a row from the nearest of its members."""
    members, others = evidence.members(requirement.actor), evidence.members(requirement.other or EGO)
    gaps = [fact.gap for m in members[:1] for o in others if (fact := m.starts.get(o.name)) is not None]
    most, said = span(requirement)[1], words(requirement, "m")
    if not gaps:
        return unknown(requirement, said, "one of the two is not there")
    room = max(bounds()["start"]["gap"]["value"], bounds()["start"]["gap_share"]["value"] * most)
    return between(requirement, min(gaps), room, said, f"{min(gaps):.1f} m", 0.0)


def off_lanes(requirement: Requirement, evidence: Evidence) -> Result:
    stays = [m.stay(0.0) for m in evidence.motions(requirement.actor)]
    if not stays or None in stays:
        return unknown(requirement, "off the lanes", "its lane was not recorded")
    inside = [s.kind for s in stays if s and s.kind in ("lane", "junction")]
    return decided(requirement, not inside, "off the driving lanes", "in a driving lane" if inside else "off them", 0.0)


def partly_in(requirement: Requirement, evidence: Evidence) -> Result:
    motion = evidence.motion(requirement.actor)
    if motion is None or not motion.course.ego_aside:
        return unknown(requirement, "partly in the lane", "its place was not recorded")
    aside, half = abs(motion.course.ego_aside[0]), motion.size[1] / 2
    lane = bounds()["start"]["half_lane"]["value"]
    inside = min(lane - (aside - half), 2 * half)
    seen = f"{inside:.1f} m of its {2 * half:.1f} m in the lane"
    return scored(requirement, min(inside, aside + half - lane) / 0.5, "partly in the lane", seen, 0.0)


def hidden(requirement: Requirement, evidence: Evidence) -> Result:
    members = evidence.members(requirement.actor)
    behind = {o.name for o in evidence.members(requirement.other or "")}
    hiding = [o for o in members if behind & set(o.hidden_behind)]
    seen = "hidden" if members and len(hiding) == len(members) else "in sight"
    return decided(requirement, seen == "hidden", "hidden at first", seen, 0.0)


def comes_hidden(requirement: Requirement, evidence: Evidence) -> Result:
    """Of who comes over the lane in which another stands, or by another road: not seen just before it is in ego's lane;
    by another road, or at first."""
    if requirement.values["at_first"] and hidden(requirement, evidence).holds:
        return hidden(requirement, evidence)
    motion, said = evidence.motion(requirement.actor), "hidden as it comes"
    half = bounds()["start"]["half_lane"]["value"]
    there = np.flatnonzero(np.abs(motion.of_course("ego_aside")) < half) if motion else np.zeros(0, int)
    if motion is None or not len(there):
        return unknown(requirement, said, "not judged: it never enters ego's lane")
    came = float(motion.time[there[0]])
    times = np.arange(max(0.0, came - bounds()["start"]["comes"]["value"]), came, motion.step)
    shown = [next((s for t, s in reversed(motion.course.sight) if t <= time), True) for time in times]
    return decided(requirement, not all(shown), said, "in sight" if all(shown) else said, came)


def lateral(requirement: Requirement, evidence: Evidence) -> Result:
    one, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    ego = evidence.motion(EGO)
    room, said = bounds()["start"]["lateral"]["value"], words(requirement, "m")
    if one is None or other is None or ego is None or not one.course.ego_aside:
        return unknown(requirement, said, "its place was not recorded")
    aside = [0.0 if m is ego else m.course.ego_aside[0] for m in (one, other)]
    turned = [m.heading[0] - ego.heading[0] for m in (one, other)]
    half = sum(abs(np.sin(t)) * m.size[0] + abs(np.cos(t)) * m.size[1]
               for t, m in zip(turned, (one, other), strict=True)) / 2  # fmt: skip
    seen = abs(aside[0] - aside[1]) - half
    return between(requirement, seen, room, said, f"{seen:.1f} m", 0.0)


def lanes_over(requirement: Requirement, evidence: Evidence) -> Result:
    one, other, over = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO), 0.0
    said = f"{requirement.values['over']:g} lanes to the left"
    if one is None or other is None or not one.course.ego_aside:
        return unknown(requirement, said, "its place was not recorded")
    over = (one.course.ego_aside[0] - (other.course.ego_aside[0] if other.course.ego_aside else 0.0)) / LANE
    off = abs(over - float(requirement.values["over"]))  # type: ignore[arg-type]
    return scored(requirement, 1.0 - off / 0.5, said, f"{over:.1f}", 0.0)


def facing(requirement: Requirement, evidence: Evidence) -> Result:
    motion = evidence.motion(requirement.actor)
    stay = motion.stay(0.0) if motion else None
    if stay is None or stay.lane < 0:
        return unknown(requirement, "along the road", "it starts off the lanes")
    words = {True: "against the road", False: "along the road"}
    said = bool(requirement.values["against"])
    seen = stay.against != (stay.to_ego == "oncoming")
    return decided(requirement, seen == said, words[said], words[seen], 0.0)


CHECKS = {"start_lane": start_lane, "start_along": start_along, "start_side": start_side, "start_gap": start_gap,
          "lateral": lateral, "lanes_over": lanes_over, "off_lanes": off_lanes, "partly_in": partly_in,
          "hidden": hidden, "comes_hidden": comes_hidden, "facing": facing}  # fmt: skip
