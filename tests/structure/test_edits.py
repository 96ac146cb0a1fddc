"""Edits of S: what they change, what they refuse, and that they touch nothing else."""

import pytest
from pydantic import TypeAdapter

from c2s_engine.structure.components import Assumption, Component, Structure, Unmet
from c2s_engine.structure.edits import (
    AddObject,
    Edit,
    EditError,
    MoveObject,
    RemoveObject,
    SetCode,
    SetField,
    SetSpec,
    apply,
)  # fmt: skip
from c2s_engine.structure.program import assemble
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement


@pytest.fixture
def structure() -> Structure:
    lead = Component(id="O1", spec=ObjectSpec(name="lead"))
    follower = Component(id="O2", spec=ObjectSpec(name="follower", placement=Placement(position="behind", of="O1")))
    return Structure(objects=(lead, follower))


def test_a_field_deep_in_a_spec(structure):
    after = apply(structure, SetField(component="O2", path="placement.gap", value=[10, 20]))
    assert after["O2"].spec.placement.gap == (10, 20)
    assert after["O1"] == structure["O1"]


@pytest.mark.parametrize("name", ["O1", "o1", "lead", "Lead", "the lead", "car"])
def test_a_reference_takes_the_name_that_is_shown(structure, name):
    structure = apply(structure, AddObject(spec=ObjectSpec(name="old_van", type="van")))
    assert apply(structure, SetField(component="O2", path="placement.of", value=name))["O2"].spec.placement.of == "O1"
    step = {"action": "follow", "target": "old van", "trigger": {"kind": "distance", "of": name, "value": 9}}
    phase = apply(structure, SetField(component="O2", path="phases", value=[step]))["O2"].spec.phases[0]
    assert (phase.target, phase.trigger.of) == ("O3", "O1")
    with pytest.raises(EditError, match=r"is one of ego, O1 \(lead\), O2 \(follower\): car can be O1 or O2$"):
        apply(structure, SetField(component="O3", path="placement.of", value="car"))


def test_a_phase_can_be_appended_and_removed(structure):
    after = apply(structure, SetField(component="O1", path="phases.0", value={"action": "stop"}))
    assert after["O1"].spec.phases == (Phase(action="stop"),)
    assert apply(after, SetField(component="O1", path="phases.0", value=None))["O1"].spec.phases == ()


def test_an_edit_is_the_same_after_it_was_read_in_another_process():
    assumed = (Assumption(field="speed", value="5 km/h", reason="usual"),)
    unmet = (Unmet(text="a", reason="b"),)
    edit: Edit = SetSpec(component="O1", spec=ObjectSpec(name="lead"), assumed=assumed, unmet=unmet)
    assert TypeAdapter(Edit).validate_json(TypeAdapter(Edit).dump_json(edit)) == edit


@pytest.mark.parametrize(
    ("edit", "says"),
    [
        (SetField(component="O9", path="speed", value=3), "no component O9"),
        (SetField(component="O1", path="colour", value="red"), "no field colour"),
        (SetField(component="O1", path="speed", value=[9, 3]), "above its upper end"),
        (SetField(component="O1", path="placement.side", value="right"), "a place ahead has no side"),
        (SetField(component="O1", path="type", value="unicorn"), "O1.type: unicorn is not one of 'car',"),
        (SetField(component="O1", path="speed", value=-3), "^O1.speed: a speed is not below 0; who drives backwards"),
        (SetField(component="E", path="speed", value=[20, 250]), "^E.speed: a speed is at most 360 km/h$"),
        (SetField(component="E", path="phases", value=[{"action": "brake", "speed": -1}]), "a speed is not below 0"),
        (SetField(component="O1", path="speed", value="banana"), "^O1.speed: banana is no number$"),
        (SetField(component="O2", path="placement.of", value="van"),
         r"^O2.placement.of is one of ego, O1 \(lead\)$"),
        (RemoveObject(component="O1"), "referred to by O2"),
        (RemoveObject(component="R"), "no object"),
        (SetSpec(component="O1", spec=EgoSpec()), "does not fit"),
    ],
)
def test_an_impossible_edit_says_why(structure, edit, says):
    with pytest.raises(EditError, match=says):
        apply(structure, edit)


def test_ids_are_stable(structure):
    after = apply(apply(structure, RemoveObject(component="O2")), AddObject(spec=ObjectSpec(name="new")))
    assert after.ids == ("G", "R", "E", "O1", "O2", "T")
    moved = apply(structure, MoveObject(component="O2", index=0))
    assert [o.id for o in moved.objects] == ["O2", "O1"]


def test_code_by_hand_is_kept_as_it_is(structure):
    after = apply(structure, SetCode(component="O1", code="lead = new Car\n"))
    assert after["O1"].origin == "by_hand"
    assert assemble(after).text == "lead = new Car\n"
    assert apply(after, SetCode(component="O1", code=None))["O1"].origin == "rendered"


def test_another_type_drops_the_model_of_the_old_one(structure):
    modelled = apply(structure, SetField(component="O1", path="model", value="vehicle.audi.a2"))
    assert apply(modelled, SetField(component="O1", path="type", value="truck"))["O1"].spec.model is None
    kind = modelled["O1"].spec.type
    assert apply(modelled, SetField(component="O1", path="type", value=kind))["O1"].spec.model == "vehicle.audi.a2"
