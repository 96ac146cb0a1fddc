"""Before whom somebody crosses, as S says it."""

import pytest

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.crossers import crossed_vehicle
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.specs import EgoSpec, ObjectSpec

STOPS = {"action": "stop", "trigger": {"kind": "action", "of": "O2", "action": "cross_road"}}
HITS = {"action": "collide", "target": "O2"}
CASES = {
    "nobody answers": ({}, {}, {}, EGO),
    "the one ahead stops for it": ({}, {"phases": [STOPS]}, {}, "O1"),
    "the one ahead hits it": ({}, {"phases": [HITS]}, {}, "O1"),
    "it runs into the one ahead": ({}, {}, {"phases": [{"action": "collide", "target": "O1"}]}, "O1"),
    "one beside hits it": ({}, {"phases": [HITS], "placement": {"position": "left_lane"}}, {}, EGO),
    "ego reacts to it, too": ({"reaction": "brake", "react_to": "O2"}, {"phases": [STOPS]}, {}, EGO),
    "ego reacts to it, and the one ahead hits it": (
        {"reaction": "brake", "react_to": "O2"}, {"phases": [HITS]}, {}, "O1"),
    "ego hits it": ({"phases": [HITS]}, {"phases": [STOPS]}, {}, EGO),
    "it comes when ego does": ({}, {"phases": [STOPS]}, {"placement": {"position": "roadside", "arrives": 0.0}}, EGO),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_before_whom_somebody_crosses(name):
    ego, ahead, crosser, whom = CASES[name]
    across = {"name": "walker", "type": "pedestrian", "placement": {"position": "roadside"},
              "phases": [{"action": "cross_road"}], **crosser}  # fmt: skip
    objects = (Component(id="O1", spec=ObjectSpec.model_validate({"name": "lead", **ahead})),
               Component(id="O2", spec=ObjectSpec.model_validate(across)))  # fmt: skip
    structure = Structure(ego=Component(id="E", spec=EgoSpec.model_validate(ego)), objects=objects)
    assert crossed_vehicle(structure, "O2") == whom
