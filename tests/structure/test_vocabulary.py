"""The vocabulary's names and meanings agree, and nothing in the data names what is not there."""

import typing

import pytest
import yaml

from c2s_engine.paths import shipped
from c2s_engine.structure import vocabulary as v
from c2s_engine.write.typed import tables

MEANINGS = yaml.safe_load(shipped("vocabulary.yaml").read_text())
TABLES = {
    "places": v.PlaceKind,
    "controls": v.Control,
    "manoeuvres": v.Manoeuvre,
    "ego_lanes": v.EgoLane,
    "positions": v.Position,
    "alongs": v.Along,
    "parts": v.Part,
    "actions": v.Action,
    "triggers": v.TriggerKind,
    "trigger_places": v.TriggerPlace,
    "reactions": v.Reaction,
    "weather": v.Weather,
    "times": v.TimeOfDay,
    "conditions": v.ConditionKind,
    "limits": v.LimitKind,
    "object_types": v.ObjectType,
}


@pytest.mark.parametrize("table", TABLES)
def test_every_name_has_a_meaning(table):
    assert set(MEANINGS[table]) == set(typing.get_args(TABLES[table]))


def test_shown_events_are_events_of_the_dry_run():
    table = yaml.safe_load(shipped("events.yaml").read_text())
    events = set(table.get("events", table))
    shown = {e for action in MEANINGS["actions"].values() for e in action["shows"]}
    assert shown <= events


def test_blueprints_are_in_the_tables_of_both_carla_versions():
    from scenic.simulators.carla._blueprintData import _IDS

    for version in ("0.9.15", "0.9.16"):
        known = {b for models in _IDS[version].values() for b in models}
        for kind, blueprints in tables.BLUEPRINTS.items():
            assert set(blueprints) <= known, (version, kind)


def test_every_type_is_placed_and_classed():
    assert set(tables.CLASS) == set(typing.get_args(v.ObjectType)) == set(tables.LENGTH)
