"""Who is ego by a number or a demand, whose speed it is, and places that only the manner of speaking tells."""

import pytest

from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.surroundings import environment


@pytest.mark.parametrize(
    ("text", "kind", "others"),
    [
        ("Coach 417, route 9. A taxi nipped across its bows from the lane to the left.", "bus", ["car"]),
        ("Truck 22: a car cut in ahead of it on the motorway. Truck 22 braked.", "truck", ["car"]),
        ("Unit 7: deer ran out from the left, harsh brake.", "car", ["animal"]),
        ("Bus no. 2044 was turning right when a cyclist came up on its inside.", "bus", ["bicycle"]),
        ("The person directing the Skoda passenger car (participant 1) overtook a lorry.", "car", ["truck"]),
        ("Participant 1 turned right and struck participant 2, a cyclist.", "car", ["bicycle"]),
        ("When an ambulance approaches from the rear, the vehicle shall clear the lane.", "car", ["ambulance"]),
        ("Company car entered the crossroads. A van came from the left.", "car", ["van"]),
    ],
)
def test_ego_by_its_number_or_what_is_demanded(read, text: str, kind: str, others: list[str]) -> None:
    s = read(text)
    assert s["E"].spec.type == kind
    assert [o.spec.type for o in s.objects] == others


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        (
            "Both vehicles shall be driven at 50 ± 1 km/h in one lane. At T0 the target vehicle shall brake. "
            "The subject vehicle shall not collide with it.",
            50,
            50,
        ),
        ("The VUT follows a car and departs to the right at a lateral speed of 0.4 m/s, at 70 km/h.", 70, None),
        ("V1 was travelling at the posted 40 mph behind V2.", 64, None),
        ("v_e = 80 km/h and v_o = 60 km/h; the lead vehicle brakes ahead of ego.", 80, 60),
        ("VUT at 72 km/h in the right lane. The motorcyclist target is in the left lane at 80 km/h.", 72, 80),
    ],
)
def test_whose_speed_it_is(read, text: str, ego: float, other: float | None) -> None:
    s = read(text)
    low = lambda v: v[0] if isinstance(v, tuple) else v  # noqa: E731
    assert round(low(s["E"].spec.speed) * 3.6) == ego
    assert len(s.objects) == 1
    if other is not None:
        assert round(low(s["O1"].spec.speed) * 3.6) == other


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("The ego backed into a bollard.", "behind"),
        ("Backing out of my space, I hit a van parked across the way.", "behind"),
        
        ("The ego left the road on the right and hit a tree.", "roadside"),
        ("At the all-way stop the AV met a pickup to the AV's right. The pickup turned left in front of the AV.",
         "crossing_right"),
    ],
)  # fmt: skip
def test_places_that_what_happens_tells(read, text: str, position: str) -> None:
    assert read(text)["O1"].spec.placement.position == position


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("A deer ran out from ten o'clock in front of ego.", "left"),
        ("A dog ran across the road from two o'clock in front of ego.", "right"),
        ("A man left the raised median and walked across the road in front of the AV.", "left"),
    ],
)
def test_sides_of_people_and_animals(read, text: str, side: str) -> None:
    assert read(text)["O1"].spec.placement.side == side


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("It happened in the small hours.", "night"),
        ("The road is not lit and it was 22:30.", "night"),
        ("Just before sunrise a car braked.", "dawn"),
        ("It was growing dark.", "dusk"),
        ("During the evening rush a car braked.", "day"),
        ("Rain was coming down in sheets.", "heavy_rain"),
        ("The surface was slick with rain.", "wet"),
        ("The sky was grey.", "cloudy"),
        ("A squall caught the van.", "wind"),
    ],
)
def test_light_and_weather(text: str, value: str) -> None:
    plain = scan.normalised(text)
    whole = [(0, len(plain))]
    time = environment.time_of_day(plain, whole)
    assert value in {f.value for f in (*environment.weather(plain, whole), *([time] if time else []))}


def test_what_is_clear_of_somebody_is_no_weather() -> None:
    plain = scan.normalised("V1 was nearly clear. It let the bus clear, and went on when the road was clear.")
    assert not environment.weather(plain, [(0, len(plain))])


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("I missed the bollard and backed into it.", ["reverse", "collide"]),
        ("A motorcoach was in the right lane of the highway when its driver saw a ladder lying ahead. He took the "
         "coach into the passing lane.", ["lane_change"]),
        ("The VUT departs gradually to the right at 70 km/h on a straight road.", ["drift"]),
    ],
)  # fmt: skip
def test_what_ego_does(read, text: str, acts: list[str]) -> None:
    assert [p.action for p in read(text)["E"].spec.phases] == acts


@pytest.mark.parametrize(
    ("text", "position", "acts"),
    [
        ("A van standing in a driveway on the right backs out onto the road ahead of ego.", "roadside", ["reverse"]),
        ("The VUT hits a stationary GVT in fog.", "ahead", ["stationary"]),
        ("A car reaches the crossroads from the right and drives straight across; the ego gives way.",
         "crossing_right", ["go_straight"]),
        ("An ambulance nears from behind; it shall be able to go by the ego.", "behind", ["overtake"]),
    ],
)  # fmt: skip
def test_what_another_does(read, text: str, position: str, acts: list[str]) -> None:
    spec = read(text)["O1"].spec
    assert spec.placement.position == position
    assert [p.action for p in spec.phases if p.action != "stationary" or len(spec.phases) == 1] == acts
