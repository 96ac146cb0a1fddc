"""The components' sentences have words for all that the specs can say."""

from typing import get_args

import pytest

from c2s_engine.interpret.language import table
from c2s_engine.structure import sentences as describe
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, SettingsSpec


@pytest.mark.parametrize(
    ("section", "names"),
    [("actions", v.Action), ("positions", v.Position), ("places", v.PlaceKind), ("weather", v.Weather)],
)
def test_every_word_of_the_vocabulary_has_its_words(section, names):
    assert set(table("sentences")[section]) == set(get_args(names))


def test_several_of_a_kind_take_the_plural():
    spec = ObjectSpec(
        type="child", count=3, placement=Placement(position="sidewalk", side="left"),
        phases=(Phase(action="cross_road"), Phase(action="wait")),
    )  # fmt: skip
    assert describe.obj(spec) == "3 children on the left sidewalk; they cross the road, then wait."


def test_a_label_stands_without_an_article():
    spec = ObjectSpec(phases=(Phase(action="overtake", target="O2"),))
    assert describe.obj(spec, {"O2": "v2"}).endswith("it overtakes V2.")
    assert describe.obj(spec, {"O2": "red_van"}).endswith("it overtakes the red van.")


def test_ego_and_the_settings():
    assert describe.ego(EgoSpec(speed=10, reaction="brake", hard=True)).endswith(
        "drives at 36 km/h; it brakes hard for what comes into its way."
    )
    assert describe.settings(SettingsSpec(weather=("rain", "wind"), time="dusk")) == "Rain and strong wind, dusk."
