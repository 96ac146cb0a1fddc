"""Which unknowns may mend what was not seen, and in which direction: the table data/solve.yaml."""

from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.solve.reaching import further
from c2s_engine.solve.unknowns import Move, Setting, Unknown, find
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed.usual import crosses
from c2s_engine.write.typed.usual_values import Usual

AFTER = 3.0
"""s for which a run goes on after the last of what is said."""
SHORTEST = 4.0
"""s that a run takes at least."""
BY_ITS_ROAD = ("unseen", "own_side", "stands_for", "at_line", "steady")
"""Checks of what comes of a road that goes on differently than S needs: stops at later signs and the like."""
BEFORE = 0.5
"""s before such a thing at which a run ends."""
SHARES = (1.0, 0.5, 0.25)
"""Of what the run says one is too early or late."""
ROOM = 0.4
"""s by which the first event comes within its bounds."""
CLOSES = ("threatens", "reacts")
"""Checks of dangers, which closing in on one another makes."""
SLOWER = (0.85, 0.7)
"""Of the speed of the one ahead."""
ACTS = 4.0
"""s after which one acts, where the run does not tell."""
TIMES = ("first_event", "reacts")
"""Checks of moments that the whole scene's coming earlier or later mends."""


def moves(structure: Structure, failing: Sequence[tuple[Requirement, Result]], open_: Sequence[Unknown],
          usual: Usual) -> list[Move]:  # fmt: skip
    """What to try next, each once, the most promising first: the run's length, all exact corrections at once, then for
    each failing requirement its first idea, then the second ones."""
    exact = [list(_exact(structure, q, r, open_, usual)) for q, r in failing]
    tried = [list(_for(q, r, open_)) for q, r in failing]
    ideas = [[*e, *t] for e, t in zip(exact, tried, strict=True)]
    longest = max(map(len, ideas), default=0)
    singly = [row[k] for k in range(longest) for row in ideas if k < len(row)]
    unseen = any(map(_unseen, failing))  # it may be seen later on
    ending = list(_longer(open_, usual)) if unseen else list(ending_of(failing, open_))
    return list(dict.fromkeys([*ending, _together([e[0] for e in exact if e]), *singly]))


def _longer(open_: Sequence[Unknown], usual: Usual) -> Iterator[Move]:
    """The run as long as anybody would take it, where it was made shorter for what S said before."""
    length = find(open_, "T", "duration")
    if length is not None and length.value < usual.open_duration:
        yield length.set_to(usual.open_duration)


def _unseen(failed: tuple[Requirement, Result]) -> bool:
    """Whether something did not happen in the run."""
    requirement, result = failed
    return requirement.check == "shown" or result.robustness is None


def _together(corrections: Sequence[Move]) -> Move:
    """Several corrections at once; of two of one unknown, the first."""
    settings: dict[tuple[ComponentId, str], Setting] = {}
    for unknown, value in (setting for move in corrections for setting in move):
        settings.setdefault((unknown.component, unknown.path), (unknown, value))
    return tuple(settings.values())


def ending_of(failing: Sequence[tuple[Requirement, Result]], open_: Sequence[Unknown]) -> Iterator[Move]:
    """The run's length in closed form, where the run goes on too long after the last of what is said."""
    late = next((r for q, r in failing if q.check == "soon_over" and r.value is not None and r.time is not None), None)
    length = find(open_, "T", "duration")
    if late is not None and length is not None:
        assert late.time is not None and late.value is not None
        yield ((length, float(max(SHORTEST, round(late.time - late.value + AFTER)))),)
    first = min((r.time for q, r in failing if q.check in BY_ITS_ROAD and r.time is not None), default=0.0)
    shown = all(q.check in (*BY_ITS_ROAD, "soon_over") for q, _ in failing)  # all else, so that this may come after it
    if length is not None and shown and first - BEFORE >= SHORTEST:
        yield length.set_to(first - BEFORE)


def _exact(structure: Structure, requirement: Requirement, result: Result, open_: Sequence[Unknown],
           usual: Usual) -> Iterator[Move]:  # fmt: skip
    """Corrections by as much as the run says, and by less: one that sets out a step later may be far later."""
    if move := further(structure, requirement, result, open_):
        yield move
    if result.due is not None:
        whole, *parts = (list(_in_time(structure, requirement, share * result.due, open_, usual)) for share in SHARES)
        yield from (*whole[:1], *(part[0] for part in parts if part), *whole[1:2])
    if requirement.check in CLOSES:
        yield from _closing(structure, requirement, result, open_)
    if requirement.check in TIMES and result.value is not None and result.bounds is not None:
        below = result.value < result.bounds[0]
        due = result.bounds[0] + ROOM if below else result.bounds[1] - ROOM
        if below or requirement.check == "first_event":
            yield _later(structure, due - result.value, result.time or 0.0, open_, usual)


def _closing(structure: Structure, requirement: Requirement, result: Result,
             open_: Sequence[Unknown]) -> Iterator[Move]:  # fmt: skip
    """The one ahead slower, and so much further ahead that ego is as near to it as before when it acts."""
    who = component_of(next((w for w in (requirement.other, requirement.actor) if w not in (None, EGO)), EGO) or EGO)
    spec, speed, gap = structure[who].spec, find(open_, who, "speed"), find(open_, who, "placement.gap")
    if speed is None or gap is None or not isinstance(spec, ObjectSpec) or _back(spec) > 0:
        return
    seconds = result.time if result.time is not None else ACTS
    for share in SLOWER:
        slower = speed.within(share * speed.value)
        yield (*speed.set_to(slower), *gap.set_to(gap.value + (speed.value - slower) * seconds))


def _later(structure: Structure, seconds: float, begins: float, open_: Sequence[Unknown], usual: Usual) -> Move:
    """The whole scene `seconds` later (earlier below 0): everybody as far from where it happens as they drive in that
    time, and what began at `begins` of its own begins so much later."""
    own = usual.speeds.get("E", 0.0)
    found: list[Setting] = []
    for unknown in open_:
        spec, last = structure[unknown.component].spec, unknown.path.rsplit(".", 1)[-1]
        speed = usual.speeds.get(unknown.component, 0.0)
        if last == "distance" and own > 0:
            value = unknown.value + own * seconds
        elif last == "gap" and isinstance(spec, ObjectSpec) and (parting := _parting(spec, own, speed)):
            value = unknown.value + parting * seconds
        elif last == "trigger":
            value = begins + seconds if speed <= 0 else unknown.value + seconds
        elif last == "duration":
            value = unknown.value + (max(seconds, 0.0) if unknown.component == "T" else seconds)
        else:
            continue
        found += unknown.set_to(value)
    return tuple(found)


def _in_time(structure: Structure, requirement: Requirement, due: float, open_: Sequence[Unknown],
             usual: Usual) -> Iterator[Move]:  # fmt: skip
    """The requirement's actor `due` s later where it is to be (ego's counterpart so much earlier): by when it is where
    their ways meet, when it begins, or where it starts; else, where it cannot be earlier, ego so much later."""
    who = requirement.actor
    if who == EGO:
        who, due = requirement.other or EGO, -due
    spec = structure[who].spec if who != EGO else None
    ahead = component_of(spec.placement.of) if isinstance(spec, ObjectSpec) else ""
    hider = (spec.placement.hidden_by if isinstance(spec, ObjectSpec) else None) or ""
    away = usual.speeds.get("E", 0.0)
    for component, path, grows in (
        (who, "placement.later", 1.0),
        (who, "placement.gap", -_at_contact(structure, who, away) if _follows_another(spec)
         else _back(spec) * usual.speeds.get(who, 0.0)),
        (ahead, "placement.later", 1.0),  # of the queue that it is in
        (hider, "placement.gap", -away if any(p.trigger for p in getattr(spec, "phases", ())) else 0.0),
        (who, "phases.0.trigger", 1.0),
        (who, "placement.gap", -away if usual.speeds.get(who, 0.0) and who in usual.later else 0.0),
        ("E", "phases.0.trigger", 1.0 if who != EGO and usual.speeds.get(who, 0.0) else 0.0),
        ("R", "distance", -away),
        ("G", "light_changes.0.when.value", 0.0 if away else -1.0),  # ego, which waits for it
    ):
        unknown = find(open_, component, path)
        if unknown is not None and grows and (move := unknown.set_to(unknown.value + grows * due, 2)):
            yield move


def _follows_another(spec: object) -> bool:
    """Whether somebody crosses ego's way when another does something: only where it does is open."""
    return isinstance(spec, ObjectSpec) and crosses(spec) and any(p.trigger is not None for p in spec.phases[:1])


def _at_contact(structure: Structure, who: str, speed: float) -> float:
    """How fast (m/s) ego is as it hits somebody, where S says it; else `speed`."""
    hits = [p.speed for p in getattr(structure.ego.spec, "phases", ()) if p.action == "collide" and p.target == who]
    return middle(hits[0]) if hits and hits[0] is not None else speed


def _back(spec: object) -> float:
    """+1 where one that starts further from ego comes later to where they meet, -1 where it comes earlier."""
    if not isinstance(spec, ObjectSpec):
        return 0.0
    return 1.0 if spec.placement.position in ("behind", "oncoming_lane") or spec.placement.along == "behind" else -1.0


def _parting(spec: ObjectSpec, own: float, speed: float) -> float:
    """m by which the gap to ego grows in each second that the scene begins earlier."""
    if spec.placement.of != EGO:
        return 0.0
    if spec.placement.position == "oncoming_lane" or spec.placement.facing == "against":
        return own + speed
    behind = spec.placement.position == "behind" or spec.placement.along == "behind"
    return speed - own if behind else own - speed


def _for(requirement: Requirement, result: Result, open_: Sequence[Unknown]) -> Iterator[Move]:
    table = _table()
    measured = table["measured"] if result.value is not None and result.bounds is not None else ()
    for row in (*table.get(requirement.check, ()), *table["any"], *measured):
        if row.get("seen") and row["seen"] != _side(result):
            continue
        whose = _components_of_part(row["of"], requirement)
        fields = [u for u in open_ if u.component in whose and u.path.rsplit(".", 1)[-1] == row["field"]]
        yield from filter(None, (u.set_to(u.value * row.get("times", 1.0) + row.get("plus", 0.0)) for u in fields))


def _side(result: Result) -> str:
    """Whether what was measured is below or above what is required; '' where no number was measured."""
    if result.value is None or result.bounds is None:
        return ""
    return "below" if result.value < result.bounds[0] else "above"


def _components_of_part(of: str, requirement: Requirement) -> tuple[ComponentId, ...]:
    """Components of a part in a requirement: its actor, the other, ego, the place, the run, all objects."""
    if of == "objects":
        return tuple(f"O{k}" for k in range(1, 100))
    who = {"actor": requirement.actor, "other": requirement.other, "ego": EGO}.get(of, of)
    return (component_of(who),) if who else ()


@cache
def _table() -> dict[str, list[dict[str, Any]]]:
    return yaml.safe_load(paths.shipped("solve.yaml").read_text(encoding="utf-8"))
