"""One and the other of a group; nouns that are the same in singular and plural."""


def test_one_and_the_other(read) -> None:
    s = read("2 deer stand on the verge on the left. One bolts across, the other stays put.")
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["cross_road"], ["stationary"]]
    s = read("Two vans are parked on the right. One pulls out in front of the ego, the other stays where it is.")
    assert sorted(o.spec.phases[0].action for o in s.objects) == ["enter_road", "stationary"]


def test_sheep_are_counted(read) -> None:
    assert read("Five sheep stand on the road ahead of the ego.")["O1"].spec.count == 5


def test_both_lanes(read) -> None:
    s = read("In the left lane a bus drives, and in the right lane one truck. Ego is in the middle lane.")
    assert {o.spec.type: o.spec.placement.position for o in s.objects} == {"bus": "left_lane", "truck": "right_lane"}
