"""Who comes back over the line, waits before it acts, or is come up to; who is only listed beside ego."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "The target vehicle, travelling at 20 km/h in the same lane, is approached from behind.",
        "A cyclist in ego's lane is caught up from behind.",
        "A slow tractor is approached from behind by ego at 70 km/h.",
    ],
)
def test_who_is_approached_is_ahead(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "ahead"


def test_who_comes_up_to_ego_is_behind(read) -> None:
    s = read("Ego is approached from behind by a fast car at 150 km/h.")
    assert s["O1"].spec.placement.position == "behind"


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Ego, a van, is driving behind a bus.", ["bus"]),
        (
            "There are two vehicles ahead of ego: a van directly ahead and a truck in front of the van.",
            ["van", "truck"],
        ),
    ],
)
def test_who_is_listed_beside_ego(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_what_is_blocked_is_not_done(read) -> None:
    s = read("Ego in the right lane at 100 km/h, another car left of ego blocks the lane change.")
    assert acts(s.ego) == [] and acts(s["O1"]) == []
    s = read("A truck blocks the lane. Ego changes lanes.")
    assert acts(s.ego) == ["lane_change"] and acts(s["O1"]) == ["stationary"]
