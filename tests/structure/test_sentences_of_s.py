"""A component's sentence says what its spec does, also once something else chose another value."""

import pytest

from c2s_engine.solve.unknowns import Unknown, chosen
from c2s_engine.structure.components import Component, Structure, field_words
from c2s_engine.structure.edits import SetDescription, SetField, apply
from c2s_engine.structure.sentences import described, with_updated_sentences
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement
from c2s_engine.structure.values import fields, show

VAN = ObjectSpec(name="van", type="van", speed=13.89, placement=Placement(position="left_lane", gap=15.0),
                 phases=(Phase(action="cut_in"),))  # fmt: skip
SCENE = described(Structure(
    ego=Component(id="E", spec=EgoSpec(speed=13.89, reaction="brake")), objects=(Component(id="O1", spec=VAN),),
))  # fmt: skip


def test_what_a_search_chooses_is_in_the_sentence():
    assert "at 50 km/h" in SCENE["O1"].description
    changed = chosen(SCENE, Unknown("O1", "speed", 13.89), 10.4)
    assert "at 37.4 km/h" in changed["O1"].description and changed["E"] == SCENE["E"]
    assert chosen(SCENE, Unknown("T", "duration", 20.0), 19.0)["T"].description == "The run ends after 19 s."


@pytest.mark.parametrize("speed", [4.5, 13.89, 10.4, (9.7222, 11.1111)])
def test_the_sentence_says_a_speed_as_the_field_does(speed):
    spec = EgoSpec(speed=speed)
    shown = next(show(f) for f in fields(spec) if f.path == "speed")
    assert f"at {shown.replace('-', ' to ')}" in described(Structure(ego=Component(id="E", spec=spec))).ego.description


def test_a_sentence_of_the_users_own_stays():
    own = apply(SCENE, SetDescription(component="O1", description="That awful van again."))
    changed = apply(own, SetField(component="O1", path="speed", value=10.0))
    assert with_updated_sentences(own, changed)["O1"].description == "That awful van again."
    by_hand = changed.with_component(SCENE["O1"].model_copy(update={"origin": "by_hand"}))
    assert with_updated_sentences(SCENE, by_hand)["O1"].description == SCENE["O1"].description


def test_a_field_in_words():
    found = [field_words(p) for p in ("phases.0.trigger", "placement.gap", "speed_limit", "terminate_when.1")]
    assert found == ["phase 1 trigger", "gap", "speed limit", "terminate when 1"]
