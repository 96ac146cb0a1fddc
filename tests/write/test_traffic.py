"""Those who drive in one direction: where they start so that gaps are as said (tests/write/traffic.yaml)."""

from pathlib import Path
from typing import Any

import pytest
import yaml

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed import contradiction, lateral, traffic
from c2s_engine.write.typed.spread import spread
from c2s_engine.write.typed.tables import LENGTH

CASES = yaml.safe_load(Path(__file__).with_name("traffic.yaml").read_text(encoding="utf-8"))
WRITTEN = [case for case in CASES if "refused" not in case]
REFUSED = [case for case in CASES if "refused" in case]


def structure(case: dict[str, Any]) -> Structure:
    things = [ObjectSpec.model_validate({"component": "O", "name": f"car_{'ab'[i]}", **o})
              for i, o in enumerate(case["O"])]  # fmt: skip
    return Structure(
        place=Component(id="R", spec=PlaceSpec.model_validate(case["R"])),
        ego=Component(id="E", spec=EgoSpec.model_validate(case["E"])),
        objects=tuple(Component(id=f"O{i + 1}", spec=spec) for i, spec in enumerate(things)),
    )


def ahead(ego: EgoSpec, spec: ObjectSpec, seconds: float) -> float:
    """m by which an object's rear is ahead of ego's front so many s after the start, both driving on."""
    at, bodies = spec.placement, (LENGTH[spec.type] + LENGTH[ego.type]) / 2
    start = {"ahead": 1, "behind": -1}.get(at.along or "ahead", 0) * (middle(at.gap or 0.0) + bodies) - bodies
    return start + (middle(spec.speed or 0.0) - middle(ego.speed or 0.0)) * seconds


@pytest.mark.parametrize("case", WRITTEN, ids=[c["id"] for c in WRITTEN])
def test_what_is_written(writer, case) -> None:
    given = structure(case)
    found = spread(given)
    specs = [c.spec for c in found.objects]
    for i, (along, gap) in case.get("start", {}).items():
        at = specs[i].placement
        assert at.along in (along, None) and (gap is None or middle(at.gap) == pytest.approx(gap, abs=0.5))
    for i, speed in case.get("speed", {}).items():
        assert middle(specs[i].speed) == pytest.approx(speed, abs=0.1)
    for i, actions in case.get("phases", {}).items():
        assert [p.action for p in specs[i].phases] == actions
    if "then" in case:
        i, seconds, metres = case["then"]
        assert ahead(found.ego.spec, specs[i], seconds) == pytest.approx(metres, abs=1.0)
    for i, parts in case.get("code", {}).items():
        code = writer.write(given, "E" if i == "E" else f"O{i + 1}").code
        assert all(part in code for part in parts), code


@pytest.mark.parametrize("case", REFUSED, ids=[c["id"] for c in REFUSED])
def test_what_does_not_go_together_is_refused_with_its_field(case) -> None:
    field, words = case["refused"]
    error = contradiction(structure(case))
    assert error is not None and field in error.fields and words in str(error)


@pytest.mark.parametrize(("metres", "shift"), [(0.8, 1.2), (0.8, 3.0), (3.5, 2.2), (0.1, 2.0)])
def test_the_time_of_a_move_to_the_side_is_that_of_its_steps(metres, shift) -> None:
    moved, speed, seconds, step = 0.0, 0.0, 0.0, 0.0005
    while moved < metres:
        speed = min(shift, speed + lateral.gained_at(shift) * step)
        moved, seconds = moved + speed * step, seconds + step
    assert lateral.sideways(metres, shift) == pytest.approx(seconds, abs=0.01)


@pytest.mark.parametrize("gap", [8, 20, 35])
@pytest.mark.parametrize("own", [14, 19, 20, 22, 27])
@pytest.mark.parametrize("along", [None, "ahead", "behind"])
def test_every_gap_that_can_be_is_there_as_it_comes_over_the_line(gap, own, along) -> None:
    """From its start, driving on, it comes to the gap said, and not at once."""
    at, phases = {"position": "left_lane", "along": along}, [{"action": "cut_in", "gap": gap}]
    case = {"R": {"kind": "motorway"}, "E": {"speed": 20}, "O": [{"speed": own, "placement": at, "phases": phases}]}
    if contradiction(structure(case)) is not None:
        assert along == "behind" and (own <= 20 or (gap + 10) / (own - 20) > traffic.LATEST)
        return
    found = spread(structure(case))
    spec, gains = found["O1"].spec, own - 20
    start = ahead(found.ego.spec, spec, 0.0)
    if not gains:
        assert start == pytest.approx(gap, abs=0.2)
        return
    seconds = (gap - start) / gains
    assert 0.9 < seconds <= traffic.LATEST + 0.1
