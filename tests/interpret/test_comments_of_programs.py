"""Comments above a program: their marks, their line breaks, names as in code; own vehicles, stops, queues."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter


def _specs(text: str) -> dict:
    return {c.id: c.spec for c in EmbeddedInterpreter().interpret(text).structure.components}


@pytest.mark.parametrize("name", ["car 1"])
def test_names_as_in_programs(name: str) -> None:
    assert _specs(f"Ego follows {name}. {name} brakes.") == _specs("Ego follows car 1. Car 1 brakes.")


@pytest.mark.parametrize(
    ("own", "kind"),
    [("our camper", "van"), ("my tipper", "truck"), ("my moped", "motorcycle"), ("our motorhome", "truck")],
)
def test_what_the_narrator_drives(own: str, kind: str) -> None:
    structure = EmbeddedInterpreter().interpret(f"I was going uphill in {own}. A bus came towards us.").structure
    assert structure.ego.spec.type == kind and [o.spec.type for o in structure.objects] == ["bus"]


@pytest.mark.parametrize(
    ("where", "control"),
    [
        ("Ego comes to a four way stop.", "stop"),
        ("Ego is at a 3 way stop.", "stop"),
        ("Ego was in the queue for the lights.", "signal"),
        ("Ego was stopped at the lights.", "signal"),
    ],
)
def test_stops_and_lights(where: str, control: str) -> None:
    place = EmbeddedInterpreter().interpret(f"{where} A car crosses from the right.").structure.place.spec
    assert place.kind == "intersection" and place.control == control
