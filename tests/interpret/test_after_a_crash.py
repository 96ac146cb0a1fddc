"""What is told of the time after a crash, and of who sat where, leaves the scene as it is."""


def test_a_straight_road_with_a_light_has_a_junction(read) -> None:
    s = read("V1 struck the rear of V2, which was stopped at a light. The roadway was straight, level and dry.")
    assert s.place.spec.kind == "intersection"
