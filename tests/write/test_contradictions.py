"""Which names go together: every pair is drawn or listed as a contradiction, and what is listed is refused."""

import itertools
import typing
from pathlib import Path

import draws
import pytest
import yaml

from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import (
    Condition,
    EgoSpec,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    RestrictionsSpec,
    SettingsSpec,
    Trigger,
)
from c2s_engine.write.typed import ResolveError, contradiction, make_plan
from c2s_engine.write.typed.contradictions import contradictions

ACTIONS, POSITIONS, PLACES = (typing.get_args(x) for x in (v.Action, v.Position, v.PlaceKind))


def listed(**names: str) -> bool:
    return any(row.pairs(**names) for row in contradictions())


def drawn(seeds, **names: str) -> bool:
    """Whether a structure with these names can be planned."""
    return any(contradiction(draws.structure(seed, **names)) is None for seed in seeds)


@pytest.mark.parametrize("action", ACTIONS)
def test_every_pair_of_an_action_is_drawn_or_listed(action):
    for position in POSITIONS:
        assert drawn(range(8), action=action, position=position) != listed(action=action, position=position), position
    for kind in PLACES:
        assert drawn(range(8), action=action, kind=kind) != listed(action=action, place=kind), kind


@pytest.mark.parametrize("row", contradictions(), ids=lambda row: row.because[:40])
def test_what_is_listed_is_refused_with_its_reason(row):
    for kind, position, action in itertools.product(
        row.places or ("road",), row.positions or ("ahead",), row.actions or ("brake",)
    ):
        said = {row.said: 1.0} if row.said else {}
        by = Placement(position=position, of="O1" if row.of_another else "ego", **said)
        trigger = Trigger(kind="time", value=3.0) if row.triggered else None
        spec = ObjectSpec(name="a", placement=by, phases=(Phase(action=action, trigger=trigger),))
        place = PlaceSpec(kind=kind, oncoming=row.oncoming or None, sidewalk=row.sidewalk or None)
        structure = Structure(
            place=Component(id="R", spec=place),
            objects=(
                *([Component(id="O1", spec=ObjectSpec(name="b"))] if row.of_another else ()),
                Component(id="O2" if row.of_another else "O1", spec=spec),
            ),
        )
        with pytest.raises(ResolveError) as refused:
            make_plan(structure)
        assert refused.value.fields and str(refused.value) in {r.because for r in contradictions()}


def test_no_time_is_required_of_a_scene():
    required = RestrictionsSpec(require=(Condition(kind="time", minimum=5.0),))
    refused = contradiction(Structure(restrictions=Component(id="T", spec=required)))
    assert refused is not None and "T.duration" in refused.fields


@pytest.mark.parametrize(
    "spec",
    [
        ObjectSpec(name="a", placement=Placement(position="ahead", of="O1")),
        ObjectSpec(name="a", placement=Placement(position="partly_in_lane", of="O1"), speed=10.0),
        ObjectSpec(name="a", phases=(Phase(action="follow", target="O1"),)),
    ],
)
def test_nobody_is_placed_by_one_or_names_one_that_is_not_there(spec):
    refused = contradiction(Structure(objects=(Component(id="O2", spec=spec),)))
    assert refused is not None and "O1" in str(refused) and "not there" in str(refused)


@pytest.mark.parametrize("other", ["ego", "O1"])
def test_two_may_wait_for_one_another(other):
    """Or one for itself: that is no fault of the solver."""
    waits = Trigger(kind="action", of=other, action="brake")
    ego = EgoSpec(speed=14.0, phases=(Phase(action="brake"), Phase(action="lane_change", trigger=waits)))
    follows = Trigger(kind="action", of="ego", action="lane_change")
    coming = ObjectSpec(
        name="a", speed=18.0, placement=Placement(position="left_lane", along="behind"),
        phases=(Phase(action="lane_change", trigger=follows), Phase(action="brake", trigger=follows)),
    )  # fmt: skip
    found = contradiction(Structure(ego=Component(id="E", spec=ego), objects=(Component(id="O1", spec=coming),)))
    assert found is None or found.fields


def test_rows_name_only_what_the_vocabulary_has():
    for row in contradictions():
        assert row.places <= set(PLACES) and row.positions <= set(POSITIONS) and row.actions <= set(ACTIONS)
        assert row.because and row.fields


CANNOT_COME = yaml.safe_load((Path(__file__).parent / "cannot_come.yaml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("said", CANNOT_COME, ids=lambda said: f"{said['field']} {said['words']}")
def test_what_cannot_come_about_is_refused_with_what_to_change(said):
    structure = Structure(
        settings=Component(id="G", spec=SettingsSpec.model_validate(said.get("G", {}))),
        place=Component(id="R", spec=PlaceSpec(kind="straight")),
        objects=(Component(id="O1", spec=ObjectSpec.model_validate({"name": "a", **said.get("O1", {})})),),
    )
    error = contradiction(structure)
    assert error is not None and said["field"] in error.fields and said["words"] in str(error)
