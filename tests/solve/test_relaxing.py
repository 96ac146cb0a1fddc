"""Numbers of the text that contradict one another: each that alone resolves it is found, and none else."""

import pytest

from c2s_engine.solve import Outcome, relaxations, unknowns
from c2s_engine.solve.unknowns import said
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.offers import Offer, verdict
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec, Trigger
from c2s_engine.write.typed.usual_values import usual_values


def behind(gap: float = 10.0, speed: float = 14.0, trigger: Trigger | None = None) -> Structure:
    """Ego behind one that brakes, all numbers said."""
    lead = ObjectSpec(
        speed=speed, placement=Placement(gap=gap), phases=(Phase(action="brake", rate=6.0, trigger=trigger),)
    )
    return Structure(
        place=Component(id="R", spec=PlaceSpec(kind="straight")),
        ego=Component(id="E", spec=EgoSpec(speed=14.0, reaction="brake")),
        objects=(Component(id="O1", spec=lead),),
    )


def shown_where(holds):
    """An evaluation in which one requirement is met where `holds` says so of (gap, speed of the lead)."""
    requirement = Requirement(id="1", kind="phase", check="shown", component="O1", text="", actor="O1", other="ego")

    async def evaluate(structure: Structure) -> Outcome:
        spec = structure["O1"].spec
        ok = holds(middle(spec.placement.gap), middle(spec.speed))
        result = Result(requirement="1", holds=ok, robustness=0.5 if ok else -0.5)
        return Outcome(structure, (requirement,), (result,))

    return evaluate


async def found(structure: Structure, holds) -> dict[str, float]:
    evaluate = shown_where(holds)
    first = await evaluate(structure)
    return {f"{r.said.component}.{r.said.path}": r.value async for r in relaxations(first, evaluate, 1.0)}


async def test_each_number_that_alone_resolves_it_is_found_with_the_nearer_value():
    assert await found(behind(), lambda gap, speed: gap >= 12 or speed <= 6) == {
        "O1.placement.gap": 12.5,  # 15 holds, and so does half way to it
        "O1.speed": 5.6,  # half way to it does not
    }


async def test_a_number_that_does_not_matter_is_not_named():
    assert set(await found(behind(), lambda gap, speed: gap >= 12)) == {"O1.placement.gap"}


async def test_what_no_single_number_resolves_has_no_offer():
    assert await found(behind(), lambda gap, speed: gap >= 12 and speed <= 6) == {}


def test_what_is_open_is_not_said_and_the_other_way_round():
    structure = behind()
    usual = usual_values(structure, 1.0)
    names = {(u.component, u.path) for u in said(structure, usual)}
    assert names == {("E", "speed"), ("O1", "speed"), ("O1", "placement.gap"), ("O1", "phases.0.rate")}
    assert not names & {(u.component, u.path) for u in unknowns(structure, usual)}


@pytest.mark.parametrize(
    ("trigger", "timed"), [(Trigger(kind="time", value=4.0), True), (Trigger(kind="distance", value=20.0), False)]
)
def test_only_a_moment_in_time_is_a_number_to_change(trigger, timed):
    structure = behind(trigger=trigger)
    names = {u.path for u in said(structure, usual_values(structure, 1.0))}
    assert ("phases.0.trigger" in names) == timed


def test_the_verdict_names_all_that_contradict():
    offers = [
        Offer(component="E", field="speed", said="90 km/h", value="130 km/h", amount=36.1),
        Offer(component="O1", field="placement.gap", said="5 m", value="20 m", amount=20.0),
    ]
    assert verdict(offers) == (
        "These numbers contradict one another: E speed 90 km/h, O1 gap 5 m. Any one of these changes resolves it:\n"
        "- E: speed 130 km/h instead of 90 km/h\n- O1: gap 20 m instead of 5 m"
    )
    assert verdict(offers[:1]).endswith("E: speed 130 km/h instead of 90 km/h.") and verdict([]).startswith("No change")


@pytest.mark.full
async def test_a_faster_car_far_ahead_cannot_cut_in_just_ahead(engine):
    text = ("Ego drives at 90 km/h. A car in the left lane, 60 m ahead of ego, at 120 km/h, cuts in 10 m ahead of ego. "
            "Ego brakes.")  # fmt: skip
    async for event in engine.generate(text):
        done = event
    assert not all(r.holds for r in done.results)
    offers = [o async for o in engine.contradictions(done.structure, map=done.details["map"])]
    assert {(o.component, o.field) for o in offers} >= {("O1", "speed")}
    from c2s_engine.structure.edits import SetField

    for offer in offers:
        edit = SetField(component=offer.component, path=offer.field, value=offer.amount)
        async for event in engine.apply(done.structure, [edit]):
            last = event
        assert all(r.holds for r in last.results), (offer, [r for r in last.results if not r.holds])
