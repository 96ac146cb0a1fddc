"""Parts of S in plain words, and the words themselves explained."""

import pytest

from c2s_engine.paths import shipped
from c2s_engine.session.glossary import meaning, page, terms
from c2s_engine.structure.happening import ACTS, WORDS
from c2s_engine.structure.specs import Placement, Trigger
from c2s_engine.structure.values import summary
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
      "yields, once O2 crosses the road")],
)  # fmt: skip
def test_what_a_step_does_and_waits_for(phase, words):
    trigger = {"trigger": Trigger(**phase["trigger"]).model_dump(mode="json")} if "trigger" in phase else {}
    assert summary({**phase, **trigger}) == words


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
