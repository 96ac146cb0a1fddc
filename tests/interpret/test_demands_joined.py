"""Demands that are joined to others: with "so that ...", "while ...", "please"; so far before a place."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter
from c2s_engine.structure.components import Structure
from tests.interpret.demanded import changed, specs

STREET = "Ego follows a car at 50 km/h on an urban road. The car brakes hard and a pedestrian crosses from the right."
CROSSING = "At a stop-controlled intersection a police car comes from the right. Ego goes straight at 30 km/h."
COUNTRY = "Ego drives at 70 km/h on a rural road behind a cyclist."


def after(scene: str, *turns: str) -> Structure:
    structure = EmbeddedInterpreter().interpret(scene).structure
    for text in turns:
        structure = changed(structure, text)
    return structure


@pytest.mark.parametrize(
    ("scene", "joined", "apart"),
    [
        (
            STREET,
            "I want the car to be 20 m in front of ego and to start braking after 4 s",
            ["the car is 20 m ahead of ego", "the car brakes after 4 s"],
        ),
        (
            STREET,
            "the car should drive at 60 km/h and should brake after 5 s",
            ["the car drives at 60 km/h", "the car brakes after 5 s"],
        ),
        (
            STREET,
            "the pedestrian should come from the left and start when ego is 15 m away",
            ["the pedestrian comes from the left", "the pedestrian starts when ego is 15 m away"],
        ),
        (
            STREET,
            "make the car a truck and please lower the speed of ego to 40 km/h",
            ["make the car a truck", "ego drives at 40 km/h"],
        ),
        (
            STREET,
            "add a bus parked on the right so that the pedestrian is hidden behind it",
            ["add a bus parked on the right", "the pedestrian is hidden by the bus"],
        ),
        (
            CROSSING,
            "the police car stops and then turns left, while ego comes with 40 km/h",
            ["the police car stops and then turns left", "ego at 40 km/h"],
        ),
    ],
)
def test_joined_as_apart(scene: str, joined: str, apart: list[str]) -> None:
    assert specs(after(scene, joined)) == specs(after(scene, *apart))


@pytest.mark.parametrize(
    "text",
    [
        "three cyclists in a row, 4 m apart",
        "three bikes with 4 m in between",
        "make it three cyclists riding 4 m apart",
    ],
)
def test_how_far_apart(text: str) -> None:
    cyclist = after(COUNTRY, text)["O1"].spec
    assert cyclist.count == 3 and cyclist.spacing == 4.0


@pytest.mark.parametrize("place", ["intersection", "junction", "crossroads"])
@pytest.mark.parametrize("does", ["brakes", "brakes hard", "begins to brake", "starts braking"])
def test_so_far_before_a_place(does: str, place: str) -> None:
    text = f"A van ahead of ego {does} 25 m before the {place}."
    phase = EmbeddedInterpreter().interpret(text).structure.objects[0].spec.phases[0]
    assert phase.action == "brake" and phase.trigger is not None
    assert (phase.trigger.kind, phase.trigger.value, phase.trigger.place) == ("place", 25.0, "intersection")


def test_ego_has_to_brake_for_one_who_is_new() -> None:
    structure = after(CROSSING, "let a pedestrian cross from the left, so that ego has to brake for him")
    assert structure.ego.spec.reaction == "brake" and structure.objects[-1].spec.type == "pedestrian"


def test_an_order_amid_what_is_told_changes_the_scene() -> None:
    text = "In front of the car there is a queue: please set three cars standing still in the same lane, 80 m ahead."
    assert after(STREET, text).ids[:5] == EmbeddedInterpreter().interpret(STREET).structure.ids[:5]
