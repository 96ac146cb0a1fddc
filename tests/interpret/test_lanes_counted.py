"""How many lanes a road has, and which of them is ego's, in numbers."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

LANES = [
    ("in the second lane from the left of four", 4, "middle"),
    ("in the number two lane of a five-lane freeway", 4, "middle"),
    ("in the second lane from the right of a freeway with five northbound lanes", 4, "middle"),
    ("in the far left lane of a ten-lane freeway (five lanes each way)", 4, "leftmost"),
    ("in the leftmost of four eastbound lanes", 4, "leftmost"),
    ("in the carpool lane of a six-lane freeway", 3, "leftmost"),
    ("on a road with seven lanes, three lanes in each direction and a center turn lane", 3, None),
    ("on a five-lane arterial with a two-way left-turn lane", 2, None),
    ("in the second from the right of four lanes that run in the same direction", 4, "middle"),
    ("on a highway with a total of six lanes", 3, None),
    ("in the curb lane of a street with three through lanes", 3, "rightmost"),
]


@pytest.mark.parametrize(("where", "lanes", "own"), LANES)
def test_lanes_in_numbers(where: str, lanes: int, own: str | None) -> None:
    place = EmbeddedInterpreter().interpret(f"Ego drives {where}. A car ahead brakes.").structure.place.spec
    assert place.lanes == lanes and own in (None, place.ego_lane)
    assert place.kind != "intersection"


def test_the_others_lane_in_numbers() -> None:
    text = (
        "Ego is in the second lane from the left on a four-lane one-way road. A truck in the third lane from the left"
        " brakes."
    )
    structure = EmbeddedInterpreter().interpret(text).structure
    assert structure.objects[0].spec.placement.position == "right_lane"
    assert structure.place.spec.ego_lane == "middle"
