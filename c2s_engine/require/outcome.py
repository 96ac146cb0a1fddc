"""Who touches whom: exactly the pairs that S says, by the parts that it says or placements imply, and nobody else."""

from collections.abc import Iterator

from c2s_engine.require.due import Point, to_meet, to_touch
from c2s_engine.require.evidence import Evidence
from c2s_engine.require.geometry import box_distance, face
from c2s_engine.require.results import decided, scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.requirements import Requirement, Result

SIDEWARD = ("lane_change", "cut_in", "drift", "swerve", "lose_control", "overtake", "cut_out", "enter_road", "u_turn",
            "leave_road")  # fmt: skip
"""Who does one of these may touch with any part."""


TOGETHER = 0.8
"""s within which of one another two come to where their ways meet who may touch there."""
CORNER = 0.3
"""m from an end or a side within which it is touched, too."""


def struck(scene: Scene) -> list[tuple[str, str]]:
    """(who strikes, whom) as S says, in its order."""
    found = []
    for actor, _, phase in scene.phases():
        if phase.action == "collide":
            target = phase.target or (EGO if actor != EGO else next(iter(scene.objects), None))
            if target is not None:
                found.append((actor, target))
    return found


def required(scene: Scene) -> Iterator[Requirement]:
    pairs = struck(scene)
    for actor, target in pairs:
        name, other = scene.named(actor), scene.named(target)
        index, phase = next((i, p) for a, i, p in scene.phases() if a == actor and p.action == "collide")
        yield scene.make("outcome", "contact", actor, f"phases.{index}.contact", f"{name} and {other} collide.",
                         other=target)  # fmt: skip
        if _brakes_for(scene, actor, target):
            striker = actor if actor != EGO else target
            yield scene.make("outcome", "brakes_before", EGO, f"reaction.{striker}.before", f"Ego brakes for "
                             f"{scene.named(striker)} before they collide.", other=striker)  # fmt: skip
        if part := phase.part or _part(scene, actor):
            yield scene.make("outcome", "part", actor, f"phases.{index}.part", f"{name} hits {other} with its "
                             f"{_words(part)}.", other=target, part=part, mine=True)  # fmt: skip
        if hit := phase.target_part or ("rear" if _in_line(scene, actor, target) else None):
            yield scene.make("outcome", "part", actor, f"phases.{index}.struck_part",
                             f"{other} is struck at its {_words(hit)}.", other=target, part=hit,
                             mine=False)  # fmt: skip
    if all(scene.of_text(a) for a in scene.actors):
        timed = [a for a, o in scene.objects.items() if o.placement.arrives is not None]
        meet = [(a, EGO) for a in timed if scene.stated(a, "placement.arrives") and _together(scene, a)]
        said = tuple(f"{a} {b}" for a, b in (*pairs, *(meet if scene.ego.reaction == "none" else ())))
        text = "There is no other collision." if said else "There is no collision."
        yield scene.make("outcome", "no_other_contact", EGO, "no_other_contact", text, component="T", pairs=said)


def _brakes_for(scene: Scene, actor: str, target: str) -> bool:
    """Whether ego brakes, in vain, for whom it hits or who hits it: not for one that comes from behind."""
    named = scene.ego.react_to
    if scene.ego.reaction != "brake" or named not in (actor, target) or EGO not in (actor, target):
        return False
    spec = scene.objects.get(named)
    return spec is not None and "behind" not in (spec.placement.position, spec.placement.along)


def _together(scene: Scene, actor: str) -> bool:
    """Whether one is where its way meets ego's about when ego is."""
    arrives = scene.objects[actor].placement.arrives
    return arrives is not None and low(arrives) < TOGETHER and high(arrives) > -TOGETHER


def _part(scene: Scene, actor: str) -> str | None:
    """What it strikes with: its front, its rear where it reverses, anything where it moves sideways."""
    spec = scene.actors[actor]
    actions = {p.action for p in spec.phases}
    if spec.type in ("pedestrian", "child", "animal") or actions & {*SIDEWARD, "oncoming", "cross_road"}:
        return None
    return "rear" if "reverse" in actions else "front"


def _in_line(scene: Scene, actor: str, target: str) -> bool:
    """Whether S places the one straight behind the other, on one lane, and neither leaves it."""
    if {p.action for a in (actor, target) for p in scene.actors[a].phases} & {
        *SIDEWARD, "reverse", "oncoming", "turn_left", "turn_right", "cross_road"
    } or scene.actors[target].type in ("pedestrian", "child", "animal"):  # fmt: skip
        return False
    one, other = scene.objects.get(actor), scene.objects.get(target)
    behind = one is not None and one.placement.position == "behind" and one.placement.of == target
    ahead = other is not None and other.placement.position == "ahead" and other.placement.of == actor
    return behind or (ahead and other is not None and other.placement.facing in (None, "along"))


def contact(requirement: Requirement, evidence: Evidence) -> Result:
    found = evidence.contacts(requirement.actor, requirement.other or EGO)
    if found:
        evidence.times[requirement.id] = found[0].time
        return scored(requirement, 1.0, "contact", f"contact at {found[0].time:.1f} s", found[0].time,
                      measured=(0.0, 0.0, 0.0))  # fmt: skip
    one, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    if one is None or other is None:
        return unknown(requirement, "contact", "not judged: one of the two is missing from the run")
    n = min(len(one.x), len(other.x))
    gap = float(box_distance(one.poses[:n], other.poses[:n], one.size, other.size).min())
    return scored(requirement, min(-0.05, -gap / 5), "contact", f"no nearer than {gap:.1f} m", due=to_meet(one, other),
                  measured=(gap, 0.0, 0.0))  # fmt: skip


def part(requirement: Requirement, evidence: Evidence) -> Result:
    found = evidence.contacts(requirement.actor, requirement.other or EGO)
    said = str(requirement.values["part"])
    if not found:
        return unknown(requirement, _words(said), "not judged: the two did not collide")
    first = found[0]
    mine = (evidence.components[first.one] == requirement.actor) == bool(requirement.values["mine"])
    seen, at = (first.part_one, first.at_one) if mine else (first.part_other, first.at_other)
    motion = evidence.motion(requirement.actor if requirement.values["mine"] else requirement.other or EGO)
    holds = _matches(said, at, motion.size) if at and motion else seen in said.split("_")
    due = None if holds else _due(requirement, evidence, said)
    where = f"{seen}, {abs(at[0]):.1f} m {'ahead of' if at[0] > 0 else 'behind'} its middle" if at else seen
    return decided(requirement, holds, _words(said), where, first.time, due=due)


def _words(part: str) -> str:
    """A part as sentences call it."""
    return f"{part.replace('_', ' ')} corner" if "_" in part else part


def _matches(said: str, at: Point, size: Point) -> bool:
    """Whether a contact so far ahead of and to the left of a body.s middle (m) is at the said part: a corner is the
    quarter of the body, by whichever of its two sides; at a corner both sides touch."""
    length, width = size
    seen = {face(at, size)}
    seen |= {"front" if at[0] > 0 else "rear"} if length / 2 - abs(at[0]) < CORNER else set()
    seen |= {"left" if at[1] > 0 else "right"} if width / 2 - abs(at[1]) < CORNER else set()
    if "_" not in said:
        return said in seen
    end, side = said.split("_")
    return bool(seen & {end, side}) and (at[0] > 0) == (end == "front") and (at[1] > 0) == (side == "left")


def _due(requirement: Requirement, evidence: Evidence, said: str) -> float | None:
    """s by which the actor should come later for that part to touch."""
    one, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    if one is None or other is None:
        return None
    if requirement.values["mine"]:
        return to_touch(one, other, lambda own, _: _matches(said, own, one.size))
    return to_touch(one, other, lambda _, its: _matches(said, its, other.size))


def brakes_before(requirement: Requirement, evidence: Evidence) -> Result:
    limits, said = bounds()["reaction"]["braked"]["value"], "slower before they touch"
    ego = evidence.motion(EGO)
    if ego is None or not evidence.contacts(EGO, requirement.other or ""):
        return unknown(requirement, said, "not judged: the two did not collide")
    before = ego.speed[ego.at(ego.time[-1] - bounds()["aiming"]["before"]["value"]) :]
    slower = float(before.max() - before[-1])
    return scored(requirement, (slower - limits) / limits, said, f"by {slower:.1f} m/s", float(ego.time[-1]))


def no_other_contact(requirement: Requirement, evidence: Evidence) -> Result:
    pairs = requirement.values["pairs"]
    assert isinstance(pairs, tuple)
    said = {frozenset(str(p).split()) for p in pairs}
    for c in evidence.facts.contacts:
        who = [evidence.components.get(name) or name for name in (c.one, c.other)]
        pushed = who[0] == who[1] and any(who[0] in pair for pair in said)  # one of a row into the next
        if frozenset(who) not in said and not pushed:
            return scored(requirement, -1.0, "no other contact", f"{c.one} and {c.other} collide", c.time)
    return scored(requirement, 1.0, "no other contact", "none")


CHECKS = {"contact": contact, "brakes_before": brakes_before, "part": part, "no_other_contact": no_other_contact}
