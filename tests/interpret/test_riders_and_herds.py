"""Who rides what, told by "of", by "on" or behind the verb; animals and bicycles that somebody on foot takes along."""

import pytest

RIDERS = """\
The rider of the scooter ahead looked back, wobbled and fell. | motorcycle swerve lose_control
The rider of a motorcycle ahead of ego lost control. | motorcycle lose_control
The rider of the bicycle swerves into ego's lane. | bicycle swerve
The riders of two quad bikes race past ego on the left. | motorcycle overtake
A rider on a moped cuts in front of ego. | motorcycle cut_in
The rider gets impatient and overtakes ego. | motorcycle overtake
A girl crosses on her bike from the right in front of ego. | bicycle cross_road
A lad pops out between two parked cars on a BMX. | bicycle cross_road
A woman with a shopping bag on an old bicycle wobbles along ahead of ego. | bicycle swerve
A rider on a bicycle turns left in front of ego. | bicycle turn_left
The rider of the motorcycle gets off and walks across the road. | pedestrian cross_road
A boy runs out in front of a girl on a bike. | child cross_road
A man crosses the road with his bike. | pedestrian cross_road"""


def _told(structure) -> list[str]:
    return [f"{o.spec.type} {' '.join(p.action for p in o.spec.phases)}" for o in structure.objects]


@pytest.mark.parametrize("row", RIDERS.splitlines())
def test_a_rider_is_what_is_ridden(read, row: str) -> None:
    text, wanted = row.split(" | ")
    told = [t for t in _told(read(text)) if not t.startswith("car ")]
    assert wanted in told
    assert len(told) == (2 if "girl on a bike" in text else 1)


@pytest.mark.parametrize(
    ("text", "both"),
    [
        ("A shepherd drives a flock of sheep over the road ahead of ego.", ("pedestrian", "animal", "cross_road")),
        ("A farmer drives his cows across the road ahead of ego.", ("pedestrian", "animal", "cross_road")),
        ("A farmer is herding three cows along the lane ahead of ego.", ("pedestrian", "animal", "move_along")),
        ("A girl leads her pony across the road.", ("child", "animal", "cross_road")),
    ],
)
def test_animals_go_with_who_leads_them(read, text: str, both: tuple[str, str, str]) -> None:
    who, animal, act = both
    assert _told(read(text)) == [f"{who} {act}", f"{animal} {act}"]


def test_a_dog_that_breaks_free_goes_alone(read) -> None:
    woman, dog = read("A woman walks her dog on the right pavement. It runs across the road.").objects
    assert [p.action for p in dog.spec.phases] == ["cross_road"]
