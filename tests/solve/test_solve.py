"""The planner's search: only what is open is chosen, each choice is said, and what is better is kept."""

import math

import pytest

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.require import require
from c2s_engine.solve import PLANNER, Outcome, solve, unknowns
from c2s_engine.solve.defaults import with_usual_reaction
from c2s_engine.solve.moves import moves
from c2s_engine.solve.reaching import further
from c2s_engine.solve.unknowns import LIMITS, STRAYS, chosen
from c2s_engine.structure.components import Assumption, Component, Structure
from c2s_engine.structure.edits import SetField, apply
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import (
    EgoSpec,
    LightChange,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    SettingsSpec,
    Trigger,
)
from c2s_engine.write.typed.usual_values import usual_values
from tests.write import draws


def lead(**fields: object) -> Structure:
    """Ego behind one that brakes hard."""
    spec = ObjectSpec(name="lead", phases=(Phase(action="brake", rate=6.0),), **fields)  # type: ignore[arg-type]
    return Structure(
        place=Component(id="R", spec=PlaceSpec(kind="straight")),
        ego=Component(id="E", spec=EgoSpec(speed=14.0, reaction="brake", hard=True)),
        objects=(Component(id="O1", spec=spec),),
    )


def paths(structure: Structure) -> set[str]:
    return {f"{u.component}.{u.path}" for u in unknowns(structure, usual_values(structure, 1.0))}


def test_of_who_comes_out_from_behind_another_on_a_cue_only_where_that_one_stands_is_open():
    hider = ObjectSpec(name="van", type="van", placement=Placement(position="parked"), speed=0.0)
    cue = Trigger(kind="seen", subject="ego", of="O1")
    phases = (Phase(action="wait", duration=1.0), Phase(action="cross_road", trigger=cue))
    behind = Placement(position="roadside", hidden_by="O1")
    runner = ObjectSpec(name="runner", type="pedestrian", placement=behind, phases=phases)
    objects = (Component(id="O1", spec=hider), Component(id="O2", spec=runner))
    structure = lead().model_copy(update={"objects": objects})
    assert paths(structure) >= {"O1.placement.gap"}
    assert not {p for p in paths(structure) if p.startswith("O2.placement")}
    open_ = unknowns(structure, usual := usual_values(structure, 1.0))
    threat = next(r for r in require(structure) if r.check == "threatens")
    late = Result(requirement=threat.id, holds=False, robustness=-0.5, said="", due=1.0)
    assert any(u.component == "O1" and value < u.value for move in moves(structure, [(threat, late)], open_, usual)
               for u, value in move)  # fmt: skip


def test_what_is_said_is_no_unknown():
    assert paths(lead()) == {"O1.placement.gap", "O1.speed", "O1.phases.0.trigger", "T.duration"}
    said = lead(speed=14.0, placement=Placement(gap=30.0))
    assert paths(said) == {"O1.phases.0.trigger", "T.duration"}


def test_when_the_light_changes_is_open_where_s_says_only_that_it_does():
    structure = lead().with_component(Component(id="G", spec=SettingsSpec(
        light="red", light_changes=(LightChange(to="green", when=Trigger(kind="time")),))))  # fmt: skip
    structure = structure.with_component(Component(id="R", spec=PlaceSpec(kind="intersection", control="signal")))
    path = "light_changes.0.when.value"
    assert f"G.{path}" in paths(structure)
    unknown = next(u for u in unknowns(structure, usual_values(structure, 1.0)) if u.path == path)
    settled = chosen(structure, unknown, 6.0)
    assert settled.settings.spec.light_changes[0].when.value == 6.0
    assert f"G.{path}" in paths(settled)
    said = apply(structure, SetField(component="G", path=path, value=8.0))
    assert f"G.{path}" not in paths(said)


def test_a_run_that_was_shortened_before_grows_where_something_is_not_seen_in_it():
    structure = lead(speed=14.0, placement=Placement(gap=30.0))
    structure = structure.with_spec("O1", phases=(Phase(action="brake", trigger=Trigger(kind="time", value=20.0)),))
    open_ = unknowns(structure, usual_values(structure, 1.0))
    structure = chosen(structure, next(u for u in open_ if u.component == "T"), 9.0)
    open_ = unknowns(structure, usual := usual_values(structure, 1.0))
    shown = next(r for r in require(structure) if r.check == "shown")
    unseen = Result(requirement=shown.id, holds=False, robustness=None, said="")
    first = moves(structure, [(shown, unseen)], open_, usual)[0]
    assert [(u.path, value) for u, value in first] == [("duration", 28.0)]


def test_what_was_assumed_is_an_unknown():
    structure = lead(speed=14.0)
    note = Assumption(field="speed", value="50 km/h", reason="the same as ego's")
    assumed = structure["O1"].model_copy(update={"assumed": (note,)})
    assert "O1.speed" in paths(structure.with_component(assumed)) - paths(structure)


def test_code_by_hand_has_no_unknowns():
    structure = lead()
    by_hand = structure["O1"].model_copy(update={"origin": "by_hand", "code": "lead = new Car"})
    assert paths(structure.with_component(by_hand)) == {"T.duration"}


@pytest.mark.parametrize("seed", range(0, 120, 6))
def test_choices_touch_only_what_is_open_and_are_said(seed):
    structure = draws.structure(seed)
    try:
        usual = usual_values(structure, 1.0)
    except ValueError:
        pytest.skip("the draw contradicts itself")
    before = {r.id: r for r in require(structure)}
    for unknown in unknowns(structure, usual):
        low, high = unknown.limits
        least, most = LIMITS[unknown.path.rsplit(".", 1)[-1]]
        assert least <= low <= high <= most
        if not unknown.usual:
            assert (low, high) == (least, most)
        else:  # a speed does not stray from what is usual
            assert low >= min(unknown.value, (1 - STRAYS) * unknown.usual) - 0.01
            assert high <= max(unknown.value, (1 + STRAYS) * unknown.usual) + 0.01
        for factor in (0.6, 1.5):
            value = unknown.within(unknown.value * factor)
            assert low <= value <= high
            changed = chosen(structure, unknown, value)
            notes = [a for a in changed[unknown.component].assumed if a.by == PLANNER]
            assert [a.field for a in notes] == [unknown.path]
            others = [c.id for c in changed.components if c != structure[c.id]]
            assert others == [unknown.component]
            demanded = {r.id for r in require(changed)} - before.keys()
            assert not demanded, f"{unknown.path} became a demand: {demanded}"


def test_an_edit_of_a_chosen_field_is_no_choice_any_more():
    structure = lead()
    gap = next(u for u in unknowns(structure, usual_values(structure, 1.0)) if u.path == "placement.gap")
    structure = apply(chosen(structure, gap, 12.0), SetField(component="O1", path="placement.gap", value=20.0))
    assert not structure["O1"].assumed and "O1.placement.gap" not in paths(structure)


def outcome(structure: Structure, *results: tuple[str, float, float | None]) -> Outcome:
    """What a run came to: (check, robustness, measured)."""
    of = [Requirement(id=f"T.{c}", kind="pace", component="T", text=c, check=c) for c, _, _ in results]
    found = [
        Result(requirement=f"T.{c}", holds=r >= 0, robustness=r, time=20.0, value=v, bounds=(2.0, 10.0))
        for c, r, v in results
    ]  # fmt: skip
    return Outcome(structure, tuple(of), tuple(found))


async def test_the_length_of_the_run_is_found_at_once():
    asked = []

    async def evaluate(structure: Structure) -> Outcome:
        asked.append(structure.restrictions.spec.duration)
        return outcome(structure, ("soon_over", 0.5, 3.0))

    best = await solve(outcome(lead(), ("soon_over", -3.0, 12.0)), evaluate, 1.0)
    assert asked == [11.0] and not best.failing


async def test_what_goes_further_than_what_does_not_run_is_not_tried():
    asked = []

    async def evaluate(structure: Structure) -> Outcome | None:
        asked.append(
            next(u.value for u in unknowns(structure, usual_values(structure, 1.0)) if u.path == "placement.gap")
        )
        return None if asked[-1] > 50 else outcome(structure, ("shown", -1.0, None), ("threatens", -1.0, None))

    structure = lead(speed=14.0, placement=Placement(gap=40.0)).with_spec("T", duration=15.0)
    structure = structure.with_spec(
        "O1", phases=(Phase(action="brake", rate=6.0, trigger=Trigger(kind="time", value=3.0)),)
    )
    note = Assumption(field="placement.gap", value="40 m", reason="left open")
    structure = structure.with_component(structure["O1"].model_copy(update={"assumed": (note,)}))
    first = outcome(structure, ("shown", -1.0, None), ("threatens", -1.0, None))
    of = tuple(r.model_copy(update={"actor": "O1", "component": "O1", "other": "O1"}) for r in first.requirements)
    await solve(Outcome(structure, of, first.results), evaluate, 1.0)
    assert [gap > 50 for gap in asked].count(True) == 1 and len(asked) > 1


async def test_nothing_better_leaves_the_first():
    first = outcome(lead(), ("first_event", -1.0, 1.0), ("threatens", -1.0, None))

    async def evaluate(structure: Structure) -> Outcome:
        return outcome(structure, ("first_event", -2.0, 0.5), ("threatens", -1.0, None))

    assert await solve(first, evaluate, 1.0, most=6) is first


async def test_the_search_is_bounded_and_the_same_each_time():
    trails = []
    for _ in range(2):
        trail: list[Structure] = []

        async def evaluate(structure: Structure, trail: list[Structure] = trail) -> Outcome:
            trail.append(structure)
            return outcome(structure, ("threatens", -1.0 + 0.01 * len(trail), None))

        threat = outcome(lead(), ("threatens", -1.0, None))
        of = tuple(r.model_copy(update={"actor": "O1", "component": "O1"}) for r in threat.requirements)
        await solve(Outcome(lead(), of, threat.results), evaluate, 1.0, most=5)
        trails.append([s.model_dump_json() for s in trail])
    assert trails[0] == trails[1] and 0 < len(trails[0]) <= 5


@pytest.mark.parametrize("slope", [-0.4, 0.15])
async def test_how_far_is_told_by_what_was_tried(slope):
    """A measure that depends on one unknown is brought within its bounds by the slope between two runs."""
    structure = lead(speed=14.0, placement=Placement(gap=30.0))  # only when it brakes is open

    def measured(structure: Structure) -> Outcome:
        trigger = structure["O1"].spec.phases[0].trigger
        begins = trigger.value if trigger is not None else 3.0
        value = 1.0 + slope * (begins - 3.0) if slope > 0 else 2.0 + slope * (begins - 3.0)
        low, high = 1.5, 1.6
        off = max(low - value, value - high)
        found = Result(requirement="T.c", holds=off <= 0, robustness=-off, value=value, bounds=(low, high))
        of = Requirement(id="T.c", kind="outcome", component="O1", actor="O1", text="c", check="closest")
        return Outcome(structure, (of,), (found,))

    tried = []

    async def evaluate(structure: Structure) -> Outcome:
        tried.append(structure)
        return measured(structure)

    best = await solve(measured(structure), evaluate, 1.0)
    assert not best.failing and len(tried) <= 3


@pytest.mark.parametrize("kind, unit", [("distance", "m"), ("ttc", "s")])
@pytest.mark.parametrize("field", ["trigger", "until"])
def test_how_near_is_near_is_open_where_s_does_not_say(kind, unit, field):
    phase = Phase(action="lane_change", side="left", **{field: Trigger(kind=kind, of="ego")})
    structure = lead().with_spec("O1", phases=(phase,))
    near = next(u for u in unknowns(structure, usual_values(structure, 1.0)) if u.path == f"phases.0.{field}.value")
    changed = chosen(structure, near, 2 * near.value)
    assert [a.value for a in changed["O1"].assumed] == [f"{2 * near.value:g} {unit}"]
    said = changed.with_component(changed["O1"].model_copy(update={"assumed": ()}))
    assert near.path not in {u.path for u in unknowns(said, usual_values(said, 1.0))}


def test_who_is_to_be_a_danger_is_slower_and_as_much_further_ahead():
    structure = lead(placement=Placement(position="right_lane", along="ahead"))
    usual = usual_values(structure, 1.0)
    of = Requirement(id="O1.threat", kind="conflict", component="O1", actor="O1", text="c", check="threatens")
    found = Result(requirement="O1.threat", holds=False, robustness=-1.0)
    for move in moves(structure, [(of, found)], unknowns(structure, usual), usual):
        new = {u.path: value for u, value in move}
        if new.keys() == {"speed", "placement.gap"}:
            slower = usual.speeds["O1"] - new["speed"]
            assert slower > 0 and math.isclose(new["placement.gap"] - usual.gaps["O1"], 4.0 * slower, abs_tol=0.2)
            return
    raise AssertionError("no such move")


def test_the_scene_begins_earlier_with_everybody_as_far_off_as_they_drive():
    structure = lead(placement=Placement(position="parked"), speed=0.0)
    usual = usual_values(structure, 1.0)
    failing = outcome(structure, ("first_event", -1.0, 0.6)).failing
    shift = moves(structure, failing, unknowns(structure, usual), usual)[0]
    gap = next(value for unknown, value in shift if unknown.path == "placement.gap")
    assert math.isclose(gap, usual.gaps["O1"] + 14.0 * 1.8, abs_tol=0.1)


REACTIONS = {
    "drives on of its own accord": (EgoSpec(phases=(Phase(action="keep_lane"),)), Phase(action="brake"), "none"),
    "is hit": (EgoSpec(), Phase(action="collide", target="ego"), "none"),
    "nothing is said": (EgoSpec(), Phase(action="brake"), "brake"),
    "yields": (EgoSpec(reaction="yield"), Phase(action="brake"), "yield"),
}


DUE = [  # position, what else S says of the other, s by which it is due, what is tried first
    ("crossing_left", {}, 0.8, ("placement.later", 0.8)),
    ("opposite_approach", {"later": -0.5}, -0.4, ("placement.later", -0.9)),
    ("oncoming_lane", {"gap": 80.0}, 0.5, ("placement.gap", 85.0)),
    ("ahead", {"gap": 30.0}, 0.5, ("placement.gap", 25.0)),
]


@pytest.mark.parametrize(("position", "said", "due", "expected"), DUE)
@pytest.mark.parametrize("of", ["other", "ego"])
def test_who_comes_too_early_or_too_late_is_set_right_at_once(position, said, due, expected, of):
    """By so much as the run shows, whoever of the two the requirement is about."""
    spec = ObjectSpec(speed=10.0, placement=Placement(position=position, **said))
    notes = tuple(Assumption(field=f"placement.{f}", value="", reason="") for f in said)
    kind = "road" if position in ("ahead", "oncoming_lane") else "intersection"
    structure = Structure(
        place=Component(id="R", spec=PlaceSpec(kind=kind)),
        ego=Component(id="E", spec=EgoSpec(speed=10.0, reaction="brake")),
        objects=(Component(id="O1", spec=spec, assumed=notes),),
    )
    who = {"actor": "O1", "other": "ego"} if of == "other" else {"actor": "ego", "other": "O1"}
    required = Requirement(id="x", kind="outcome", component="O1", text="", check="contact", **who)
    late = Result(requirement="x", holds=False, robustness=-0.5, due=due if of == "other" else -due)
    usual = usual_values(structure, 1.0)
    ((unknown, value),) = moves(structure, [(required, late)], unknowns(structure, usual), usual)[0]
    assert (unknown.component, unknown.path, value) == ("O1", *expected)


@pytest.mark.parametrize(("position", "along"), [("left_lane", "ahead"), ("oncoming_lane", None)])
@pytest.mark.parametrize("of", ["O1", "E"])
def test_who_was_too_near_at_a_trigger_starts_further_off(position, along, of):
    """By as much as they were too near, whoever of the two waited for it; not where the gap is said."""
    waits = (Phase(action="brake", trigger=Trigger(kind="distance", of="ego" if of == "O1" else "O1", value=35.0)),)
    for gap in (None, 20.0):
        at = Placement(position=position, along=along, gap=gap)
        spec = ObjectSpec(speed=15.0, placement=at, phases=waits if of == "O1" else ())
        structure = Structure(
            place=Component(id="R", spec=PlaceSpec(kind="road")),
            ego=Component(id="E", spec=EgoSpec(speed=20.0, phases=waits if of == "E" else ())),
            objects=(Component(id="O1", spec=spec),),
        )
        required = next(r for r in require(structure) if r.check == "at_distance")
        near = Result(requirement=required.id, holds=False, robustness=-1.0, value=15.0, bounds=(26.0, 44.0))
        usual = usual_values(structure, 1.0)
        found = further(structure, required, near, unknowns(structure, usual))
        assert [(u.component, u.path, v) for u, v in found] == (
            [] if gap else [("O1", "placement.gap", round(usual.gaps["O1"] + 20.0, 1))])  # fmt: skip


@pytest.mark.parametrize("case", REACTIONS)
def test_the_usual_reaction(case):
    ego, phase, reaction = REACTIONS[case]
    other = Component(id="O1", spec=ObjectSpec(phases=(phase,)))
    structure = with_usual_reaction(Structure(ego=Component(id="E", spec=ego), objects=(other,)))
    assert structure.ego.spec.reaction == reaction
    assert bool(structure.ego.assumed) == (reaction != ego.reaction)


async def test_a_text_is_solved_and_says_what_was_chosen(engine):
    """Without the search ego follows too closely to brake for a cause that it can see."""
    text = "The lead car brakes hard and ego, which follows it, brakes too."
    last = None
    async for event in engine.generate(text):
        last = event
    assert all(r.holds for r in last.results), [r for r in last.results if not r.holds]
    assert any(a.by == PLANNER for c in last.structure.components for a in c.assumed)
    assert [s.name for s in last.stages].count("solve") == 1


@pytest.mark.full
async def test_settings_switch_the_search_off():
    async with Engine(Settings(solve=False)) as engine:
        async for event in engine.generate("A truck ahead of ego brakes hard and ego stops."):
            last = event
    assert "solve" not in [s.name for s in last.stages]


def test_all_exact_corrections_are_made_at_once_then_one_by_one_and_by_half():
    """What the text says of an arrival stays; two who are late are corrected together."""
    objects = tuple(
        Component(id=cid, spec=ObjectSpec(speed=10.0, placement=Placement(position=position, arrives=0.0)))
        for cid, position in (("O1", "crossing_left"), ("O2", "crossing_right"))
    )
    structure = Structure(
        place=Component(id="R", spec=PlaceSpec(kind="intersection")),
        ego=Component(id="E", spec=EgoSpec(speed=10.0, reaction="brake")),
        objects=objects,
    )
    failing = [
        (Requirement(id=c.id, kind="conflict", component=c.id, text="", check="threatens", actor=c.id, other="ego"),
         Result(requirement=c.id, holds=False, robustness=-0.5, due=due))
        for c, due in zip(objects, (-2.0, 1.0), strict=True)
    ]  # fmt: skip
    usual = usual_values(structure, 1.0)
    tried = moves(structure, failing, unknowns(structure, usual), usual)
    found = [{(u.component, u.path): value for u, value in move} for move in tried]
    both = {("O1", "placement.later"): -2.0, ("O2", "placement.later"): 1.0}
    assert found[0] == both
    for cid, value in (("O1", -2.0), ("O1", -1.0), ("O2", 0.5)):
        assert {(cid, "placement.later"): value} in found
    assert all(path != "placement.arrives" for move in found for _, path in move)


@pytest.mark.parametrize(
    ("checks", "time", "ends"),
    [(("unseen",), 9.2, 8.7), (("unseen",), 3.0, None), (("contact",), 9.2, None), (("unseen", "contact"), 9.2, None)],
)
def test_the_run_ends_before_what_is_not_to_happen_in_it(checks, time, ends):
    structure = lead(speed=14.0, placement=Placement(gap=30.0))
    usual = usual_values(structure, 1.0)
    rule = Requirement(id="E.rule", kind="rules", component="E", text="Ego stops at its sign.", check="unseen")
    missed = Result(requirement="E.rule", holds=False, robustness=-1.0, time=time)
    failing = [(rule.model_copy(update={"check": check}), missed) for check in checks]
    lengths = {value for move in moves(structure, failing, unknowns(structure, usual), usual)
               for unknown, value in move if unknown.path == "duration"}  # fmt: skip
    assert lengths == ({ends} if ends else set())
