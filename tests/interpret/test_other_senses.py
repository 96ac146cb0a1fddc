"""Words with another sense, what is left out on purpose, counts, and what is only waited for."""

import pytest


def kinds(read, text: str) -> list[str]:
    return [c.spec.type for c in read(text).objects]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Logs attached. Ego at 50 km/h, a cyclist rides ahead.", ["bicycle"]),
        ("It was raining buckets. A truck ahead of ego brakes.", ["truck"]),
        ("You can leave out the ambulance. A van stands in ego's lane.", ["van"]),
        ("Ego waits until the lorry is done reversing.", ["truck"]),
        ("Planner stalls as the other car was there first. A grey sedan waits on the right arm. Ego stops.", ["car"]),
    ],
)
def test_only_who_belongs_to_the_scene(read, text: str, types: list[str]) -> None:
    assert kinds(read, text) == types


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("3 kids cross from the left. Ego brakes.", 3),
        ("Wild boars, 4 pcs, run over the road from the left.", 4),
        ("A wall of trucks, 3 of them, drives in the right lane. Ego is in the left lane.", 3),
    ],
)
def test_counts(read, text: str, count: int) -> None:
    assert read(text).objects[0].spec.count == count


def test_compound_number_words(read) -> None:
    s = read("A truck drives at sixty-five km/h ahead of ego, ego at eighty-two km/h.")
    assert round(s["E"].spec.speed * 3.6) == 82 and round(s.objects[0].spec.speed * 3.6) == 65


@pytest.mark.parametrize(
    ("text", "acts"),
    [
        ("The lead peels off left at the last second, a dead hatchback stands in our lane.", ["cut_out"]),
        ("A van in the right lane cuts left in front of ego.", ["cut_in"]),
        ("At the junction the lead car pulls left into a side street, ego follows.", ["turn_left"]),
    ],
)
def test_verbs_that_are_turns_only_at_junctions(read, text: str, acts: list[str]) -> None:
    assert [p.action for p in read(text).objects[0].spec.phases] == acts


@pytest.mark.parametrize(
    ("text", "manoeuvre"),
    [
        ("We let the pickup go past before turning left.", "left"),
        ("Ego rolls up to a 4-way stop, waves the sedan through and goes straight.", "straight"),
    ],
)
def test_one_who_is_let_past_is_given_way(read, text: str, manoeuvre: str) -> None:
    s = read(text)
    assert s["E"].spec.reaction == "yield" and s["R"].spec.manoeuvre == manoeuvre
    assert not {"overtake", "run_stop"} & {p.action for c in (s["E"], *s.objects) for p in c.spec.phases}


def test_standing_in_the_lane_that_ego_is_in(read) -> None:
    s = read("Ego drives in the left lane. A broken-down van stands in the left lane.")
    assert s.objects[0].spec.placement.position == "ahead" and s.objects[0].spec.speed == 0


def test_the_light_that_has_changed(read) -> None:
    s = read("The light was green but has just gone amber when ego is 40 m away. Ego stops at the line.")
    assert s["G"].spec.light == "yellow"
