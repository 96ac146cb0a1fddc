"""Whom plurals mean after single ones were told, and where those are who follow somebody."""

import pytest

from c2s_engine.structure.components import Structure


def acts(structure: Structure) -> dict[str, list[str]]:
    found = {c.spec.type: [p.action for p in c.spec.phases if p.action != "stationary"] for c in structure.objects}
    return found | {"ego": [p.action for p in structure.ego.spec.phases]}


@pytest.mark.parametrize(
    "who", ["Both", "They both", "The two", "Both vehicles", "These two vehicles", "The two of them"]
)
def test_a_plural_means_each_of_those_told_before(read, who):
    found = acts(read(f"Ego drives along. A bus and a van wait at the kerb. {who} pull out into the road."))
    assert found["bus"] and found["bus"] == found["van"]


def test_those_of_two_clauses_are_meant_together(read):
    found = acts(read("Ego drives. A cyclist rides ahead and a scooter comes behind it. They both brake."))
    assert all("brake" in found[kind] or "stop" in found[kind] for kind in found if kind != "ego")


def test_ego_is_one_of_both(read):
    structure = read("Ego drives behind a truck. Both vehicles change to the left lane.")
    assert [c.spec.type for c in structure.objects] == ["truck"]
    assert acts(structure)["ego"] == ["follow", "lane_change"]


def test_a_group_of_one_noun_is_still_one(read):
    (cars,) = read("Two cars are ahead of ego. Both brake.").objects
    assert cars.spec.count == 2 and [p.action for p in cars.spec.phases] == ["brake"]


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives on a motorway. A truck follows a car in the left lane.",
        "Ego drives along. A car comes towards ego. A truck follows the car.",
        "Ego turns left. An oncoming car goes straight on, followed by a truck.",
        "Ego drives straight on at a junction. A car crosses from the right, chased by a police car.",
    ],
)
def test_who_follows_somebody_starts_behind_that_one(read, text):
    structure = read(text)
    leader = next(c for c in structure.objects if c.spec.type == "car")
    follower = next(c for c in structure.objects if c.spec.type != "car")
    assert (follower.spec.placement.position, follower.spec.placement.of) == ("behind", leader.id)


def test_nobody_follows_itself(read):
    text = "Ego drives. Two cars approach from the opposite direction, the second tailgating the first."
    targets = {c.id: [p.target for p in c.spec.phases] for c in read(text).objects}
    assert sorted(len(t) for t in targets.values()) == [0, 1] and not any(cid in t for cid, t in targets.items())


def test_a_second_of_time_is_no_second_car(read):
    structure = read("Ego drives. A car drives ahead of ego. A second later it brakes.")
    assert [p.action for c in structure.objects for p in c.spec.phases] == ["brake"]
