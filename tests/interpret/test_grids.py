"""Tables with a row for each road user."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "actor; type; lane (of 3); v; dx // ego; car; middle; 90; 0 // X; van; right; 80; +20 // X cuts in",
        "who, kind, lane, speed, gap\nego, car, middle, 90, 0\nX, van, right, 80, 20\nX moves into the middle lane",
        "| Actor | Type | Lane | Speed | Distance |\n|---|---|---|---|---|\n| ego | car | middle | 90 km/h | 0 |\n"
        "| V2 | van | right | 80 km/h | 20 m |\nV2 changes into ego's lane.",
    ],
)
def test_rows_become_road_users(read, text: str) -> None:
    s = read(text)
    assert round(s["E"].spec.speed * 3.6) == 90 and s["R"].spec.ego_lane == "middle"
    assert len(s.objects) == 1
    van = s.objects[0].spec
    assert (van.type, round(van.speed * 3.6), van.placement.gap) == ("van", 80, 20)
    assert van.placement.position == "right_lane" and [p.action for p in van.phases] == ["cut_in"]


def test_a_lead_in_the_lane_of_ego_and_what_rows_do(read) -> None:
    s = read("actor, lane, speed, gap, action\nego, right, 60, 0, brakes\nlead, right, 60, 25, brakes hard")
    lead = s.objects[0].spec
    assert lead.placement.position == "ahead" and lead.placement.gap == 25
    assert [p.action for p in lead.phases] == ["brake"] and s["E"].spec.reaction == "brake"


def test_other_lists_stay_as_they_are(read) -> None:
    s = read("A bus, a van, and a car wait at the lights.\nThe bus, slow, and late, turns left ahead of ego.")
    assert {c.spec.type for c in s.objects} == {"bus", "van", "car"}
