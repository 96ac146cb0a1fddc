"""Parties by a code of the text's own ("01 = lorry"), by their part in a suit, by a vehicle named in a head."""

import pytest

from c2s_engine.interpret.reading.spelling import Mended


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


@pytest.mark.parametrize(
    "text",
    [
        "S1: lorry, broken down, hard shoulder. S2: ego at 100 km/h.",
        "On the M1: lorry, right lane, 80 km/h. Ego: middle lane.",
        "V1: lorry, right lane, 80 km/h. V2: car, left lane.",
        "Step 2: van ahead brakes.",
    ],
)
def test_steps_roads_and_known_labels_are_no_codes(text: str) -> None:
    assert "VOI" not in Mended(text).text


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Host box truck, lane 1 of 2, 80 km/h. Car ahead brakes to a stop.", "truck"),
        ("Subject semi, right lane of two, 60 mph. Car ahead brakes to a stop.", "truck"),
        ("VEH 77 city bus / host at 30 km/h / car ahead brakes to a stop.", "bus"),
        ("I stayed behind the car in the van for a while. Then it braked.", "van"),
        ("I came up behind a car in the pickup. Then it braked.", "truck"),
    ],
)
def test_what_ego_is_told_beside_its_name(read, text: str, kind: str) -> None:
    s = read(text)
    assert s.ego.spec.type == kind
    assert _types(s) == ["car"]


@pytest.mark.parametrize(
    "text",
    [
        '"Look twice" is what I tell every pupil. I was going at 40 km/h when a bus in front of me braked.',
        "A rule for every learner. I was going at 40 km/h when a bus in front of me braked.",
    ],
)
def test_all_of_a_kind_are_not_there(read, text: str) -> None:
    assert _types(read(text)) == ["bus"]


@pytest.mark.parametrize("where", ["onto the hard shoulder", "onto the grass verge"])
@pytest.mark.parametrize("verb", ["pulls over", "moves over", "draws"])
def test_over_to_a_side_onto_the_shoulder_is_off_the_road(read, verb: str, where: str) -> None:
    s = read(f"In fog the AV slows, {verb} to the right {where} and stops there.")
    assert [(p.action, p.side) for p in s.ego.spec.phases if p.side] == [("leave_road", "right")]


def test_traffic_that_had_backed_up_stands(read) -> None:
    s = read("The truck was going 65 mph. Traffic had backed up. The truck struck the last car in the queue.")
    assert "reverse" not in [a for o in s.objects for a in _acts(o)]
    assert "reverse" in _acts(read("The lorry ahead backed up and I braked.").objects[0])
