"""Places that follow from others: lanes full of standing cars, the other side of the road, who is got round."""


def test_hidden_on_the_other_side(read) -> None:
    s = read("A bus standing on the opposite side of the street hides a child, who darts out towards the ego.")
    assert s["O1"].spec.placement.position == "oncoming_lane" and s["O2"].spec.placement.side == "left"


def test_got_round_in_its_own_lane(read) -> None:
    s = read("A grey car stopped in the right lane. Our vehicle comes at 100 km/h and avoids it by the left lane.")
    assert s["O1"].spec.placement.position == "ahead" and s["R"].spec.ego_lane == "rightmost"


def test_past_the_works_by_the_oncoming_lane(read) -> None:
    s = read("Roadworks occupy the lane of the ego. It drives past the works on the oncoming lane.")
    assert s["O1"].spec.placement.position == "ahead"
    assert [p.action for p in s["E"].spec.phases] == ["oncoming", "overtake"]


def test_over_the_line(read) -> None:
    s = read("A van coming the other way skids over the line and hits us.")
    assert [p.action for p in s["O1"].spec.phases] == ["oncoming", "collide"]


def test_a_light_of_another(read) -> None:
    s = read("The ego turns right on red after a full stop. The cyclist from the left has the green.")
    assert s["G"].spec.light == "red"
