"""Road users called by letters, bare or after their noun, and who does the same as another."""

import pytest


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Truck P drives at 80 km/h. Ego follows P with 30 m.", ["truck"]),
        ("Ego trails K by 20 m. K stops.", ["car"]),
        ("Car P waits at the kerb, Q, a bus, pulls out. Ego overtakes P.", ["car", "bus"]),
        ("A tram stops. The ego drives on the B road near Point A.", ["bus"]),
    ],
)
def test_letters_name_road_users(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_a_bare_letter_follows_another(read) -> None:
    s = read("M is in the right lane, N follows M at 20 m. The ego is in the left lane.")
    follow = s["O2"].spec.phases[0]
    assert follow.action == "follow" and follow.target == "O1"


def test_a_letter_is_no_article(read) -> None:
    s = read("Car B is a hundred metres ahead of the ego. A bus overtakes the ego.")
    assert sorted(o.spec.type for o in s.objects) == ["bus", "car"]


def test_a_noun_right_after_a_label(read) -> None:
    s = read("Unit 1 gray pickup was going north. Unit 2 white van ran the stop sign and hit Unit 1.")
    assert s["E"].spec.type == "truck" and [o.spec.type for o in s.objects] == ["van"]
