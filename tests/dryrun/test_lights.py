"""The library's `Lights`: what those on their way come to, in the dry run on the town."""

import pytest

from c2s_engine import driving

pytestmark = pytest.mark.full(one_of=2)

PROGRAM = """
from c2s_driving import *
place = Uniform(*junctions(STRAIGHT, control='signal', approach=60, others=[From('left'), From('opposite')]))
ego = new Car at place.lane.centerline.pointAlongBy(place.length - 30),
    with behavior {ego}
crossing = new Car at place.from_left.centerline.pointAlongBy(-40),
    with behavior Cruise(route(place.from_left), 2)
opposite = new Car at place.from_opposite.centerline.pointAlongBy(-40), {opposite}
    with behavior Cruise(route(place.from_opposite), 2)
require monitor Lights({arguments})
"""
CASES = {  # arguments, of whom is opposite -> what ego, who crosses and who is opposite come to
    "plain": ("", "", ("green", "green", "green")),
    "ego's is green": ("place.turn", "", ("green", "red", "green")),
    "ego's is red": ("place.turn, 'red'", "", ("red", "green", "red")),
    "all are out": ("place.turn, 'off'", "", ("off", "off", "off")),
    "one of its own": ("place.turn", "with light 'red',", ("green", "red", "red")),
}


@pytest.fixture
def shown(run, town, monkeypatch):
    monkeypatch.syspath_prepend(str(driving.path().parent))

    def go(arguments, opposite="", ego="Cruise(route(place.lane, place.turn), 2)"):
        recording = run(PROGRAM.format(arguments=arguments, opposite=opposite, ego=ego), seconds=4).recording
        roads = [town.index.lanes[town.index.lane_at(p.x[0], p.y[0], p.heading[0])].road for p in recording.paths]
        lights = {(junction, road) for _, junction, road, _ in recording.lights}
        # a road may have lights at both ends
        (there,) = set.intersection(*({j for j, road in lights if road == each} for each in roads))
        return [{t: colour for t, *light, colour in recording.lights if light == [there, each]} for each in roads]

    return go


@pytest.mark.parametrize("case", CASES)
def test_who_comes_to_which_light(shown, case):
    arguments, opposite, expected = CASES[case]
    assert tuple(list(states.values())[-1] for states in shown(arguments, opposite)) == expected


def test_a_red_light_turns_green_for_who_stands_there(shown):
    stops = "StopAtLine(route(place.lane, place.turn), place.lane, 9, 6)"
    ego, crossing, _ = shown("place.turn, 'red', turns_green=True", ego=stops)
    assert "red" in ego.values() and list(ego.values())[-1] == "green"
    assert "green" in crossing.values() and list(crossing.values())[-1] == "red"
