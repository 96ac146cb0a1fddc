"""Comments above a program: their marks, their line breaks, names as in code; own vehicles, stops, queues."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

LINES = [
    "A van stands in ego's lane. Ego would like to go round it,",
    "but a taxi is coming up from behind in the left lane",
    "at 50 km/h. Ego waits behind the van.",
]


def _specs(text: str) -> dict:
    return {c.id: c.spec for c in EmbeddedInterpreter().interpret(text).structure.components}


@pytest.mark.parametrize("mark", ["# ", "## ", "// ", "#"])
def test_marks_of_comments_are_not_read(mark: str) -> None:
    assert _specs("\n".join(mark + line for line in LINES)) == _specs(" ".join(LINES))


@pytest.mark.parametrize("name", ["car_1", "car 1"])
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
