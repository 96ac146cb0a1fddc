"""Notes without verbs: what they are spelt out to, and the scene that is read from them."""

import pytest

from c2s_engine.interpret.reading.spelling import Mended


@pytest.mark.parametrize(
    ("note", "sentences"),
    [
        (
            "ego 50 r lane, van 60 l lane 10 m behind, cuts in",
            "ego drives at 50 km/h in the right lane. van drives at 60",
        ),
        ("lead @ 40, gap 25, full stop", "lead drives at 40 km/h. The lead is 25 m ahead of ego. The lead stops"),
        ("ego + lead both 70 kph", "ego drives at 70 kph. lead drives at 70 kph"),
        ("truck A 85 right lane, truck B 88 alongside left lane", "in the left lane alongside truck A"),
        ("lead decel 6 m/s2 after 3 s, ego 50", "lead brakes at 6 m/s2 after 3 s"),
    ],
)
def test_notes_become_sentences(note: str, sentences: str) -> None:
    assert sentences.lower() in Mended(note).text.lower()


@pytest.mark.parametrize(
    "text",
    [
        "The van in the left lane cuts in at 20 m.",
        "A truck drives ahead of ego at 60 km/h.",
        "Lead vehicle decelerating on a wet road",
        "V2 stopped at the line.",
    ],
)
def test_plain_sentences_stay_as_they_are(text: str) -> None:
    assert Mended(text).text == text


def objects(read, text: str) -> dict:
    return {c.spec.type: c.spec for c in read(text).objects}


def test_lane_gap_speed_and_act_of_one_note(read) -> None:
    van = objects(read, "ego 50 r lane, van 60 l lane 10 m behind, cuts in")["van"]
    assert (van.placement.position, van.placement.along, van.placement.gap) == ("left_lane", "behind", 10)
    assert round(van.speed * 3.6) == 60 and [p.action for p in van.phases] == ["cut_in"]


def test_who_stopped_in_a_note_stands(read) -> None:
    lorry = objects(read, "lorry stopped ahead 60 m, ego 80")["truck"]
    assert lorry.speed == 0 and lorry.placement.gap == 60


def test_a_bracket_after_a_road_user_is_its_note(read) -> None:
    s = read("ego (mid lane, 110), car (right lane, 90, +30), car changes lanes left")
    car = s.objects[0].spec
    assert round(s["E"].spec.speed * 3.6) == 110 and round(car.speed * 3.6) == 90
    assert car.placement.position == "right_lane" and [p.action for p in car.phases] == ["cut_in"]


@pytest.mark.parametrize(("told", "sign"), [("+20 kph rel speed", 1), ("+15 km/h relative", 1)])
def test_a_relative_speed_is_not_ego_s_own(read, told, sign) -> None:
    s = read(f"pov L lane, 20m behind, {told}. ego (80, right lane) keeps its lane")
    assert round(s.ego.spec.speed * 3.6) == 80
    assert (s.objects[0].spec.speed - s.ego.spec.speed) * sign > 0
