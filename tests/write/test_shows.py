"""Structures of typical phenomena (shows.yaml): what S says is what the run shows, as whoever gives that S gets it."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from c2s_engine.structure.components import Component
from c2s_engine.structure.facts import ObjectFacts
from c2s_engine.structure.progress import RunDone
from c2s_engine.structure.specs import RestrictionsSpec, SettingsSpec
from tests.write.test_golden import structure

CASES = yaml.safe_load((Path(__file__).parent / "shows.yaml").read_text(encoding="utf-8"))


def missing(thing: ObjectFacts, wanted: list[str], components: dict[str, str]) -> list[str]:
    """Which of the wanted events and speeds an object of a run does not show."""
    seen = {e.event for e in thing.events}
    seen |= {f"{e.event} {components[e.other]}" for e in thing.events if e.other}
    seen |= {f"hidden_behind {components[name]}" for name in thing.hidden_behind}
    return [w for w in wanted if not _holds(thing, w, seen)]


def _holds(thing: ObjectFacts, wanted: str, seen: set[str]) -> bool:
    kind, _, rest = wanted.partition(" ")
    if kind == "speed":
        low, high = map(float, rest.split("-"))
        return thing.held_speed is not None and low <= thing.held_speed <= high
    return rest not in seen if kind == "not" else wanted in seen


async def shown(engine: Any, case: dict[str, Any]) -> Any:
    """What came of a case: its program, the facts of the run, and what S requires of it."""
    made = structure(case)
    made = made.with_component(Component(id="G", spec=SettingsSpec.model_validate(case.get("G", {}))))
    if "T" in case:
        made = made.with_component(Component(id="T", spec=RestrictionsSpec.model_validate(case["T"])))
    async for event in engine.realise(made, seed=0):
        last = event
    assert last.ok, last
    return last


@pytest.mark.full(one_of=6)
@pytest.mark.parametrize("name", CASES)
async def test_the_run_shows_it(engine, name):
    case = CASES[name]
    done = await shown(engine, case)
    facts = done.facts[0]
    components = {o.name: o.component for o in facts.objects}
    for thing in facts.objects:
        assert not missing(thing, case["shows"].get(thing.component, []), components), thing.component
    failed = {r.requirement for r in done.results if not r.holds}
    assert not failed & set(case.get("holds", ()))
    if case.get("whole"):
        assert not [r for r in done.results if not r.holds]


@pytest.mark.full
async def test_a_limit_that_no_road_has_is_posted_by_the_program(engine):
    done = await shown(engine, {"R": {"kind": "straight", "speed_limit": 17.9}})
    assert "param speed_limit = 64" in done.program.text
    assert 64 in done.facts[0].speed_limits_kmh


@pytest.mark.parametrize(
    ("side", "said", "between"),
    [("right", {}, True), ("left", {}, True), ("right", {"of": "O1", "along": "ahead"}, False)],
)
async def test_one_whom_a_row_hides_comes_out_between_its_last_two(engine, side, said, between):
    """Unless S says that it stands beyond them."""
    row = {"name": "row", "count": 3, "placement": {"position": "parked", "along": "ahead", "side": side}, "speed": 0}
    child = {"type": "child", "placement": {"position": "roadside", "side": side, "hidden_by": "O1", **said}}
    phases = [{"action": "cross_road"}]
    case = {
        "R": {"kind": "road"}, "E": {"speed": 11.1, "reaction": "brake", "hard": True},
        "O": [{**row, "phases": [{"action": "stationary"}]}, {"name": "child", **child, "phases": phases}],
    }  # fmt: skip
    done = await shown(engine, case)
    things = {o.name: o for o in done.facts[0].objects}
    middle, last, own = (things[n].starts["ego"].gap for n in ("row[1]", "row[2]", "child"))
    assert (middle + things["row[1]"].length - 0.3 < own < last) == between
    assert (own > last + things["row[2]"].length - 0.3) != between
    assert "row[1]" in things["child"].hidden_behind and things["child"].shows("cross_road")
    assert not done.facts[0].contacts


@pytest.mark.parametrize("lead", [{"type": "car", "speed": 8.0}, {"type": "bicycle", "speed": 4.5}])
async def test_who_has_braked_for_somebody_keeps_behind_that_one_and_does_not_surge(engine, lead):
    case = {
        "R": {"kind": "straight"}, "E": {"speed": 14.0, "reaction": "brake", "react_to": "O1"},
        "O": [{"name": "lead", "placement": {"position": "ahead", "gap": 25}, **lead}],
        "T": {"duration": 20},
    }  # fmt: skip
    made = structure(case).with_component(Component(id="T", spec=RestrictionsSpec.model_validate(case["T"])))
    ways = []
    async for event in engine.realise(made, seed=0, trajectories=True):
        ways += [event.trajectories] if isinstance(event, RunDone) else []
    speeds = next(t.speed for t in ways[-1].tracks if t.name == "ego")
    lowest = speeds.index(min(speeds))
    assert min(speeds) <= lead["speed"] + 0.5, "it braked"
    later = speeds[lowest:]
    falls = [max(later[: i + 1]) - v for i, v in enumerate(later)]
    assert max(falls) < 0.6, "no braking again for who drives on as before"
    assert speeds[-1] == pytest.approx(lead["speed"], abs=1.0) and not event.facts[0].contacts
