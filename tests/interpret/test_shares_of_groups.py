"""Shares of a group: the first two, the rest, each of them, one of two, the former; rows from front to back."""

import pytest

SHARED = """\
Each of the two steps into the road as ego comes near. | 2 cross_road
All of them step into the road as ego comes near. | 2 cross_road
One of them steps into the road as ego comes near. | 1 cross_road
The former steps into the road. | 1 cross_road"""
TOLD = """\
There are four cars in front of ego. The first two turn off to the left, the remaining two go straight on. \
| 2 turn_left, 2 go_straight
Ego drives behind three motorcycles. Each of the three brakes. | 3 brake
Two of the three vans ahead of ego brake hard. | 2 brake, 1 -
Three trucks are ahead of ego. The first two trucks brake, the third changes to the left lane. | 2 brake, 1 lane_change
Three vans are ahead of ego. One of them brakes, the others change to the left lane. | 1 brake, 2 lane_change
A car, a van and a bus drive ahead of ego. All three brake. | 1 brake, 1 brake, 1 brake
A car and a van are ahead of ego. Both of them change to the left lane. | 1 cut_out, 1 cut_out
Ego follows two trucks. The nearest brakes. | 1 brake, 1 -
Two trucks are ahead of ego; the latter brakes. | 1 -, 1 brake"""


def _told(structure) -> str:
    return ", ".join(f"{o.spec.count} {' '.join(p.action for p in o.spec.phases) or '-'}" for o in structure.objects)


@pytest.mark.parametrize("row", SHARED.splitlines())
def test_shares_of_people(read, row: str) -> None:
    text, wanted = row.split(" | ")
    assert wanted in _told(read(f"Two pedestrians stand at the kerb on the right. {text}"))


@pytest.mark.parametrize("row", TOLD.splitlines())
def test_shares_of_vehicles(read, row: str) -> None:
    text, wanted = row.split(" | ")
    assert _told(read(text)) == wanted


def test_a_part_is_counted_and_the_rest_stays(read) -> None:
    s = read(
        "Six deer stand on the verge on the left; two of them run across the road and the rest stay where they are."
    )
    assert sorted((o.spec.count, o.spec.phases[0].action) for o in s.objects) == [(2, "cross_road"), (4, "stationary")]


def test_the_last_of_a_platoon_is_the_nearest(read) -> None:
    last, others = read("A platoon of four trucks travels ahead of ego. The last one brakes hard.").objects
    assert last.spec.phases[0].action == "brake" and others.spec.count == 3
    assert others.spec.placement.of == last.id


def test_the_second_of_two_is_the_farther(read) -> None:
    first, second = read("Two cars are ahead of ego. The second one brakes.").objects
    assert second.spec.phases[0].action == "brake" and second.spec.placement.of == first.id


@pytest.mark.parametrize(
    "text",
    ["Ego passes the first two intersections; a van is behind it.", "A van is ahead of ego in one of the two lanes."],
)
def test_no_share_of_places(read, text: str) -> None:
    assert len(read(text).objects) == 1


def test_all_three_may_have_ego_among_them(read) -> None:
    s = read(
        "A truck is ahead of ego, an SUV is behind ego. A worker stands at the kerb. All three drive past the worker."
    )
    assert "overtake" not in [p.action for o in s.objects for p in o.spec.phases]
