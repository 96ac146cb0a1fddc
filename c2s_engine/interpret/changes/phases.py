"""What the phases of somebody become by a demand: joined to what he does already, and who waits for whom."""

import re
from collections.abc import Sequence
from typing import Any

from c2s_engine.interpret.changes.kept import WAYS, with_old
from c2s_engine.interpret.changes.refer import actions_named, doing, refer, spec_of
from c2s_engine.interpret.changes.scene_context import table
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger
from c2s_engine.structure.vocabulary import Action

AFTER = re.compile(
    r"\b(?:(?P<delay>\d[\d.]*) ?(?:s|secs?|seconds?) )?(?:only )?(?:after|as soon as|once|when"
    r"|from) (?P<what>[^,]+?)(?=$| (?:with|at|by|to) \d)"
)
OVER = frozenset(("cut_in", "lane_change", "drift"))
"""What it is called when somebody comes over the line of a lane."""
AFTER_AHEAD = re.compile(
    r"^(?:(?P<delay>\d[\d.]*) ?(?:s|secs?|seconds?) )?(?:only )?(?:after|from) (?P<what>(?:the|its|his|her) [\w -]+?)"
    r"(?:, | (?=(?:it|he|she|they|ego|o\d|the) ))"
)
PASSED = re.compile(r"\b(?:has|have|is|are|had) (?:passed|gone (?:past|by)|driven (?:past|by)|past|by)\b")
PASSING = frozenset(("run_red", "run_stop"))
"""What one does against its light or sign."""


def awaited(told: str, structure: Structure) -> Trigger | None:
    """ "As soon as the child starts to cross, the bus stops": what another does, for which it is waited."""
    if moment := re.match(table()["at_a_time"], told):
        return Trigger(kind="time", value=float(moment["seconds"]))
    if then := afterwards(told, structure):
        return then[1]
    match = re.match(table()["awaits"], told)
    if match is None or re.search(r"\d", condition := match["before"] or match["after"]):
        return None
    other = refer(condition, structure, alone=False)
    if other is None or not (actions := [p.action for p in getattr(other.spec, "phases", ())]):
        return None
    said = [a for a in actions if doing(condition, (a,))]
    if other.id == "E":
        return Trigger(kind="action", of="ego", action=said[0]) if said else None
    return Trigger(kind="action", of=other.id, action=(said or actions_named(condition) or actions)[0])


def afterwards(told: str, structure: Structure) -> tuple[str, Trigger] | None:
    """ "Brakes 2 s after the cut-in", "only after the car has passed": the text without the moment, and this one told
    by what somebody does by S; None where nobody there does it."""
    match = next((m for m in AFTER.finditer(told)), None) or AFTER_AHEAD.match(told)
    if match is None or re.search(r"\d", match["what"]):
        return None
    main = f"{told[: match.start()]} {told[match.end() :]}".strip(" ,")
    delay = float(match["delay"]) if match["delay"] else None
    named = refer(match["what"], structure, alone=False)
    if named is not None and PASSED.search(match["what"]):
        of = "ego" if named.id == "E" else named.id
        return main, Trigger(kind="passed", of=of, delay=delay)
    if named is not None and re.fullmatch(r"(?:the )?[\w-]+", match["what"]):
        act = next(iter(actions_named(main)), None)  # "brakes 1 s after ego"
        return (main, _of(named, act, delay)) if act and delay is not None else None
    if named is not None and delay is None:
        return None
    doers = [named] if named is not None else list(structure.components)
    found = [(c, p.action) for c in doers for p in getattr(c.spec, "phases", ()) if doing(match["what"], (p.action,))]
    if len(found) != 1:
        return None
    ((doer, act),) = found
    subject = refer(main, structure, alone=False)
    if delay is None and subject is not None and subject.id == doer.id:
        return None  # the order of his acts says it
    return main, _of(doer, act, delay)


def _of(doer: Component, act: Action, delay: float | None) -> Trigger:
    return Trigger(kind="action", of="ego" if doer.id == "E" else doer.id, action=act, delay=delay)


def begun(phases: tuple[Phase, ...], waited: Trigger | None, old: Sequence[Phase]) -> tuple[Phase, ...]:
    """The phases, of which the first that is told anew begins when what is waited for happens."""
    if waited is None or not phases or any(p.trigger == waited for p in phases):
        return phases
    known = {p.action for p in old}
    new = [i for i, p in enumerate(phases) if p.action not in known] or [0]
    at = new[0] if all(p.action in known for p in phases[: new[0]]) else 0
    if phases[at].trigger is not None and phases[at].trigger.kind != waited.kind:  # type: ignore[union-attr]
        return phases
    return (*phases[:at], phases[at].model_copy(update={"trigger": waited}), *phases[at + 1 :])


def in_other_words(phases: tuple[Phase, ...], now: EgoSpec | ObjectSpec) -> tuple[Phase, ...]:
    """The phases, of which one that tells what he does already by another name is that: who comes over the line from
    the oncoming lane does not cut in."""
    if not _over_the_line(now):
        return phases
    same = {"action": "oncoming", "side": None, "target": None}
    return tuple(p.model_copy(update=same) if p.action in OVER else p for p in phases)


def begun_at(changed: list[tuple[str, Any]], there: Component) -> list[tuple[str, Any]]:
    """The changes, in which a distance at which one comes over the line is when he does so, not where he starts."""
    acts = next((value for path, value in changed if path == "phases"), ())
    at = next((i for i, p in enumerate(acts) if p.action == "oncoming"), None)
    gap = next((value for path, value in changed if path == "placement.gap" and value is not None), None)
    if at is None or not _over_the_line(there.spec) or not any(path == "placement.position" for path, _ in changed):
        return changed
    if gap is not None:
        acts = (
            *acts[:at],
            acts[at].model_copy(update={"trigger": Trigger(kind="distance", value=gap)}),
            *acts[at + 1 :],
        )
    return [("phases", acts), *(c for c in changed if c[0] != "phases" and not c[0].startswith("placement"))]


def _over_the_line(spec: Any) -> bool:
    acts = {p.action for p in getattr(spec, "phases", ())}
    return isinstance(spec, ObjectSpec) and spec.placement.position == "oncoming_lane" and "oncoming" in acts


def settled(edits: Sequence[Edit], structure: Structure) -> list[Edit]:
    """The edits, and what follows from them for who only stands now, and for how ego reacts."""
    return _at_rest(_from_the_other_lane(_by_the_side(_evading(edits), structure), structure), structure)


def _by_the_side(edits: Sequence[Edit], structure: Structure) -> list[Edit]:
    """The edits, and that one who is to overtake ego on a side comes in the lane there."""
    found = list(edits)
    for edit in edits:
        if not isinstance(edit, SetField) or edit.path != "phases" or not edit.component.startswith("O"):
            continue
        sides = [p.side for p in edit.value if p.action == "overtake" and p.side and p.target == "ego"]
        now = spec_of(structure[edit.component]).placement.position
        if sides and now in ("left_lane", "right_lane") and now != f"{sides[0]}_lane":
            found.append(SetField(component=edit.component, path="placement.position", value=f"{sides[0]}_lane"))
            back = tuple(
                p.model_copy(update={"side": OPPOSITE[sides[0]]}) if p.action == "cut_in" else p for p in edit.value
            )
            found[found.index(edit)] = edit.model_copy(update={"value": back})
    return found


def _from_the_other_lane(edits: Sequence[Edit], structure: Structure) -> list[Edit]:
    """The edits, and that one who is now in the lane on ego's other side cuts in towards ego from there."""
    told = {e.component for e in edits if isinstance(e, SetField) and e.path == "phases"}
    found = list(edits)
    for edit in edits:
        if not isinstance(edit, SetField) or edit.path != "placement.position" or edit.component in told:
            continue
        _phases, _before = (
            spec_of(structure[edit.component]).phases,
            spec_of(structure[edit.component]).placement.position,
        )
    return found


def _at_rest(edits: Sequence[Edit], structure: Structure) -> list[Edit]:
    """The edits, and that nobody has a speed who only stands now: "the van has broken down"."""
    found = list(edits)
    paced = {e.component for e in edits if isinstance(e, SetField) and e.path == "speed"}
    for edit in edits:
        if isinstance(edit, SetField) and edit.path == "phases" and edit.component not in {"E", *paced}:
            stands = [p.action for p in edit.value] == ["stationary"]
            if stands and spec_of(structure[edit.component]).speed:
                found.append(SetField(component=edit.component, path="speed", value=0.0))
    return found


def _evading(edits: Sequence[Edit]) -> list[Edit]:
    """The edits, and ego's swerving as its reaction where no side and no moment of it are told."""
    found: list[Edit] = []
    for edit in edits:
        swerves = isinstance(edit, SetField) and (edit.component, edit.path) == ("E", "phases") and edit.value
        if swerves and all(p.action == "swerve" and not p.side and not p.trigger for p in edit.value):  # type: ignore[union-attr]
            edit = SetField(component="E", path="reaction", value="evade")
        if edit not in found:
            found.append(edit)
    return found


def given_up(clause: str, structure: Structure) -> list[Edit]:
    """The edit after which ego does no longer what the clause denies; none for its way through an intersection."""
    assert isinstance(structure.ego.spec, EgoSpec)
    phases = structure.ego.spec.phases
    said = re.sub(table()["meanwhile"], "", clause)
    kept = tuple(p for p in phases if p.action in WAYS or not doing(said, (p.action,)))
    return [SetField(component="E", path="phases", value=kept)] if kept != phases else []


def paused(phases: tuple[Phase, ...], clause: str) -> tuple[Phase, ...]:
    """The phases with how long one stands who stops: "stops for 2 s"."""
    said = re.search(table()["paused"], clause)
    stops = [i for i, p in enumerate(phases) if p.action == "stop"]
    if said is None or not stops or any(p.action == "wait" for p in phases[stops[0] :]):
        return phases
    wait = Phase(action="wait", duration=float(said["seconds"]))
    return (*phases[: stops[0] + 1], wait, *phases[stops[0] + 1 :])


def without_awaited(changed: list[tuple[str, Any]]) -> list[tuple[str, Any]]:
    """The changes without a gap that is only the one for which somebody waits."""
    awaited_at = {p.trigger.value for path, value in changed if path == "phases" for p in value if p.trigger}
    return [(path, value) for path, value in changed if path != "placement.gap" or value not in awaited_at]


def mapped(phase: Phase, ids: dict[str, str]) -> Phase:
    trigger = phase.trigger
    if trigger is not None and trigger.of:
        trigger = trigger.model_copy(update={"of": ids.get(trigger.of, trigger.of)})
    target = ids.get(phase.target, phase.target) if phase.target else None
    return phase.model_copy(update={"trigger": trigger, "target": target})


def _so_long_after(old: tuple[Phase, ...], new: tuple[Phase, ...], clause: str) -> tuple[Phase, ...]:
    """The new phases, of which a first one so long after a stop waits as long: "sets off again after 4 s"."""
    trigger = new[0].trigger if new else None
    since = re.search(r"\b(?:start|beginning) (?:of|$)|\bafter the (?:start|beginning)\b", clause)
    if not old or old[-1].action != "stop" or trigger is None or trigger.kind != "time" or since:
        return new
    return (Phase(action="wait", duration=trigger.value), new[0].model_copy(update={"trigger": None}), *new[1:])


def joined(old: tuple[Phase, ...], new: tuple[Phase, ...], clause: str) -> tuple[Phase, ...]:
    """What it does from now on: the new phases; behind the old ones where the clause says so; where they only say more
    of an old phase, that one with what is new."""
    if re.search(table()["besides"], clause) and (len(new) == 1 or re.match(table()["afterwards"], clause)):
        turns = any(p.action in WAYS for p in new)
        new = _so_long_after(old, new, clause)
        if old and new and old[-1].action == new[0].action:
            new = new[1:]
        if new and new[0].action in PASSING:
            return (*new, *old)
        return (*(p for p in old if not (turns and p.action in WAYS)), *new)
    if re.search(r"\bfirst\b", clause) and len(new) == 1 and new[0].action not in WAYS:
        return (*new, *(p for p in old if p.action in WAYS))
    if old and [p.action for p in new] == ["move_along"]:
        return old  # how fast it goes, not what it does
    ways = [p for p in old if p.action in WAYS]
    passed = [p for p in old if p.action in PASSING]
    others = {p.action for p in new} - WAYS.keys()
    obeys = bool(others) and others <= {"stop", "wait", "yield", "start"}
    if obeys and ways and (passed or others == {"yield"} or re.search(table()["at_the_line"], clause)):
        told = [p for p in new if p.action in WAYS and p.action != "go_straight"]
        return (*(p for p in new if p.action not in WAYS), *(told or ways))
    only = re.search(table()["only_that"], clause)
    if passed and not only and not obeys and not others & {*PASSING, "stationary"}:
        new = (*passed, *new)
    same = [i for i, p in enumerate(old) if len(new) == 1 and p.action == new[0].action]
    if not same:
        return with_old(old, new, clause)
    said = {k: v for k, v in new[0].model_dump().items() if v is not None}
    said |= {} if len(said) > 1 or not re.search(table()["plainly"], clause) else {"rate": None}
    merged = Phase.model_validate(old[same[0]].model_dump() | said)
    return (*old[: same[0]], merged, *old[same[0] + 1 :])
