"""What words and triggers require, each from both sides (watched.yaml): a run that shows it, and one that does not."""

from pathlib import Path
from typing import Any

import pytest
import yaml
from roads import Actor, Scene, event, ramp

from c2s_engine.require import evaluate, require
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.facts import Mark
from c2s_engine.structure.specs import SPEC_OF, ObjectSpec

CASES = yaml.safe_load((Path(__file__).parent / "watched.yaml").read_text(encoding="utf-8"))
WAY = (
    Mark(kind="line", start=60.0, end=60.0, name="1/1", control="signal"),
    Mark(kind="junction", start=60.0, end=80.0, name="1"),
)


def structure(case: dict[str, Any]) -> Structure:
    one = {k: Component(id=k, spec=SPEC_OF[k].model_validate(case.get(k, {}))) for k in ("G", "R", "E", "T")}
    objects = tuple(
        Component(id=f"O{i}", spec=ObjectSpec.model_validate(row)) for i, row in enumerate(case.get("O", ()), 1)
    )
    return Structure(settings=one["G"], place=one["R"], ego=one["E"], restrictions=one["T"], objects=objects)


def actor(name: str, values: dict[str, Any]) -> Actor:
    told = {k: ramp(*v) if isinstance(v, list) and k in ("speed", "x") else v for k, v in values.items()}
    told["events"] = tuple(event(*e) for e in told.get("events", ()))
    told["sight"] = tuple(map(tuple, told.get("sight", [[0.0, True]])))
    walks = tuple(Mark(kind="crosswalk", start=a, end=b) for a, b in told.pop("marks", ()))
    return Actor(name, "E" if name == "ego" else name, marks=WAY + walks, **told)


def scene(case: dict[str, Any], side: str) -> Scene:
    own = case[side]
    names = sorted({"ego", *case.get("run", {}), *own} - {"lights"})
    actors = [actor(n, {**case.get("run", {}).get(n, {}), **own.get(n, {})}) for n in sorted(names, key="ego".__ne__)]
    lights = own.get("lights", case.get("lights", ()))
    return Scene(actors, lights=tuple((float(t), "1/1", state) for t, state in lights))


@pytest.mark.parametrize("side", ["shows", "misses"])
@pytest.mark.parametrize("name", CASES)
def test_it_holds_of_the_one_and_not_of_the_other(name, side):
    case = CASES[name]
    run = scene(case, side).run()
    asked = require(structure(case))
    found = {r.requirement: r for r in evaluate(asked, run.facts, run.trajectories)}[case["requires"]]
    assert found.holds is (side == "shows"), found
