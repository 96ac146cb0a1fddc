"""What is said by a verb that stands for another, and what is only tried, denied or held back."""

import pytest


def actions(spec):
    return [p.action for p in spec.phases]


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("The oncoming truck drifted over the line, as did the car behind it.", "oncoming"),
    ],
)
def test_a_verb_that_stands_for_the_one_before(read, text, action):
    second = read(text).objects[1].spec
    assert action in actions(second)


@pytest.mark.parametrize(
    "text",
    [
        "A van ahead of ego brakes harder than the bus behind ego does.",
        "A van ahead of ego brakes. The bus behind ego did not.",
        "A van ahead of ego brakes. What the bus behind ego does is unknown.",
    ],
)
def test_a_verb_that_stands_for_none(read, text):
    structure = read(text)
    assert all("brake" not in actions(o.spec) for o in structure.objects if o.spec.type == "bus")


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("V2 was no longer able to stop and struck the rear of V1.", "stop"),
        ("V2 no longer braked and struck the rear of V1.", "brake"),
    ],
)
def test_what_is_only_tried(read, text, never):
    structure = read(text)
    assert structure.ego.spec.reaction == "none"
    assert actions(structure.objects[0].spec) == ["collide"] and never not in actions(structure.objects[0].spec)


def test_who_tried_and_skidded_did_brake(read):
    spec = read("V2 attempted to stop but skidded and struck V1 from behind.").objects[0].spec
    assert actions(spec) == ["stop", "lose_control", "collide"]


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("Not until the ego vehicle was 10 m away did the cyclist turn left.", "distance", 10),
        ("Only when ego was 12 m away did the pedestrian cross the road.", "distance", 12),
    ],
)
def test_moments_in_other_orders(read, text, kind, value):
    (trigger,) = [p.trigger for p in read(text).objects[0].spec.phases if p.trigger]
    assert (trigger.kind, trigger.value) == (kind, value)


def test_what_is_held_back_until_then_is_done(read):
    spec = read("Ego must not overtake the cyclist until the oncoming car has passed.").ego.spec
    assert actions(spec) == ["overtake"] and spec.reaction == "yield"
    spec = read("Ego does not move off until the pedestrian has crossed.").ego.spec
    assert actions(spec) == ["start"] and spec.phases[0].trigger is None and spec.reaction == "yield"


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("A van cut me off and I had to hit the shoulder to avoid it.", "leave_road"),
        ("A van cut me off and I took to the shoulder.", "leave_road"),
        ("The light turned green, I hit the gas and a cyclist came from the left.", "accelerate"),
    ],
)
def test_hitting_what_is_no_road_user(read, text, action):
    spec = read(text).ego.spec
    assert action in actions(spec) and "collide" not in actions(spec)
