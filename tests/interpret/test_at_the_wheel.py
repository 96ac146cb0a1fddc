"""Who drives and what is driven are one road user; whose turn it is that is completed."""

import pytest


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("The guy ahead of me with a flatbed braked hard.", ["truck"]),
        ("A woman in front of us in a red Mini slammed on her brakes.", ["car"]),
        ("A farmer was riding his quad in the middle of the lane ahead of the ego.", ["motorcycle"]),
        ("The ego follows a lorry. A pensioner drove his Opel towards them on the wrong side.", ["truck", "car"]),
        ("A man crosses the road in front of the ego.", ["pedestrian"]),
    ],
)
def test_driver_and_vehicle(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_people_by_name(read) -> None:
    s = read("Mrs Pell, alone in her Land Rover, pulled out of a side road. Mr Osei, on a motorcycle, hit her.")
    assert s.ego.spec.type == "car"
    assert [(o.spec.type, o.spec.phases[-1].target) for o in s.objects] == [("motorcycle", "ego")]


def test_whose_turn_is_completed(read) -> None:
    s = read("The ego waited to turn left. After an oncoming motorcycle had passed, it completed its turn.")
    assert [p.action for p in s.ego.spec.phases] == ["turn_left"]
    assert [p.action for p in s["O1"].spec.phases] == ["go_straight"]
