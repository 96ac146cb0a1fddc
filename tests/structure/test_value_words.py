"""Parts of S in plain words, and the words themselves explained."""

import pytest

from c2s_engine.paths import shipped
from c2s_engine.session.glossary import meaning, page, terms
from c2s_engine.structure.event_words import ACTS, WORDS
from c2s_engine.structure.specs import Condition, Limit, ObjectSpec, Phase, Placement, Trigger
from c2s_engine.structure.values import field_at, fields, parse, show, summary
from c2s_engine.structure.vocabulary import Action


@pytest.mark.parametrize(
    ("placement", "words"),
    [({"position": "left_lane", "gap": 15.0}, "in the lane to the left, 15 m ahead of ego"),
     ({"position": "left_lane", "along": "abreast"}, "in the lane to the left, level with ego"),
     ({}, "ahead of ego"),
     ({"position": "behind", "gap": (10.0, 20.0)}, "10-20 m behind ego"),
     ({"position": "roadside", "side": "right", "gap": 40.0}, "at the roadside on the right, 40 m ahead of ego"),
     ({"position": "beside", "side": "left", "of": "O2"}, "beside O2 on the left"),
     ({"position": "crossing_left", "gap": 30.0}, "on the road from the left, 30 m before the intersection"),
     ({"position": "parked", "side": "right", "hidden_by": "O2"}, "parked on the right, hidden by O2")],
)  # fmt: skip
def test_where_an_object_starts(placement, words):
    assert summary(Placement(**placement).model_dump(mode="json")) == words


@pytest.mark.parametrize(
    ("phase", "words"),
    [({"action": "cut_in", "side": "right", "target": "ego",
       "trigger": {"kind": "distance", "value": 25, "of": "ego"}}, "cuts in (ego) to the right, when ego is 25 m away"),
     ({"action": "brake", "rate": 4.0, "duration": 2.0}, "brakes with 4 m/s2 for 2 s"),
     ({"action": "start", "trigger": {"kind": "time", "value": 3}}, "sets off, 3 s after the start"),
     ({"action": "stop", "trigger": {"kind": "place", "place": "intersection", "value": 10}},
      "stops, 10 m before the intersection"),
     ({"action": "yield", "trigger": {"kind": "action", "of": "O2", "action": "cross_road"}},
      "yields, once O2 crosses the road"),
     ({"action": "brake", "trigger": {"kind": "action", "of": "O1", "action": "cut_in", "delay": 2}},
      "brakes, once O1 cuts in, and 2 s later"),
     ({"action": "brake", "trigger": {"kind": "speed", "subject": "O1", "value": 10}},
      "brakes, when O1 goes at 36 km/h"),
     ({"action": "start", "trigger": {"kind": "passed", "subject": "ego", "of": "O1"}},
      "sets off, when ego has gone by O1")],
)  # fmt: skip
def test_what_a_step_does_and_waits_for(phase, words):
    trigger = {"trigger": Trigger(**phase["trigger"]).model_dump(mode="json")} if "trigger" in phase else {}
    assert summary({**phase, **trigger}) == words


@pytest.mark.parametrize(
    ("kind", "value", "shown", "unit"),
    [("time", 4.0, "4 s", "s"), ("ttc", 1.6, "1.6 s", "s"), ("distance", 25.0, "25 m", "m"), ("apart", 5.0, "5 m", "m"),
     ("speed", 10.0, "36 km/h", "m/s")],
)  # fmt: skip
def test_the_unit_of_what_a_trigger_waits_for_is_that_of_its_kind(kind, value, shown, unit):
    phase = Phase(action="brake", trigger=Trigger(kind=kind, value=value))
    spec = ObjectSpec(phases=(phase,))
    field = next(f for f in fields(spec) if f.path == "phases.0.trigger.value")
    assert (show(field), field.unit) == (shown, unit)
    assert parse(field, shown) == pytest.approx(value) == parse(field, shown.split()[0])
    gone = "phases.0.trigger.value"
    empty = ObjectSpec(phases=(phase.model_copy(update={"trigger": Trigger(kind=kind, value=None)}),))
    assert next(f for f in fields(empty) if f.path == gone).unit == field_at(spec, gone).unit == unit


def test_the_unit_of_a_limit_and_of_a_condition_is_that_of_its_kind():
    limits = [Limit(kind=kind, minimum=5.0, maximum=10.0) for kind in ("speed", "deceleration", "gap", "ttc", "jerk")]
    ends = (Condition(kind="time", minimum=5.0), Condition(kind="distance", maximum=10.0))
    shown = [show(f) for part in (*limits, *ends) for f in fields(part) if f.label in ("minimum", "maximum") and f.set]
    assert shown == ["18 km/h", "36 km/h", "5 m/s2", "10 m/s2", "5 m", "10 m", "5 s", "10 s", "5", "10", "5 s", "10 m"]


def test_every_action_and_event_has_its_words():
    from typing import get_args

    import yaml

    assert set(ACTS) == set(get_args(Action))
    assert set(WORDS) == set(yaml.safe_load(shipped("events.yaml").read_text()))


def test_the_glossary_is_asked_and_printed():
    assert meaning("what is TTC?").startswith("TTC: Time to collision")
    assert meaning("What does PET mean?").startswith("PET: ") and meaning("gap") and meaning("phases")
    assert meaning("what is the weather?") == "" and meaning("make it faster") == ""
    assert (shipped("glossary.yaml").parents[1] / "docs" / "glossary.md").read_text() == page()
    assert all(text.endswith(".") for text in terms().values())
