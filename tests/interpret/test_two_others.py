"""Two others in one text, joined in many manners: each with its own place and its own deed."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

JOINED = (
    "{S} {v} and {t} {w}.",
    "{S} {v} while {t} {w}.",
    "There are {s} and {t}. The {n} {v} and the {m} {w}.",
    "There is {s} that {v} and {t} that {w}.",
    "{S}, which {v}, and {t}, which {w}.",
    "{S} {v}, followed by {t} {h}.",
    "I want {s} to {b} and {t} to {c}.",
    "{S} should {b} and {t} should {c}.",
    "Create a scenario with {s} {g} and {t} {h}.",
)
FIRST = (
    ("van", "a van ahead", "brakes", "braking", "brake", ("ahead", "brake")),
    ("pedestrian", "a pedestrian on the right", "crosses the road", "crossing the road", "cross the road")
    + (("roadside", "cross_road"),),
)
SECOND = (
    ("cyclist", "a cyclist in the right lane", "swerves to the left", "swerving to the left", "swerve to the left")
    + (("right_lane", "swerve"),),
    ("taxi", "a taxi parked on the right", "pulls out", "pulling out", "pull out", ("parked", "enter_road")),
)


@pytest.mark.parametrize("joined", JOINED)
@pytest.mark.parametrize("first", FIRST, ids=lambda f: f[0])
@pytest.mark.parametrize("second", SECOND, ids=lambda s: s[0])
def test_each_has_its_own(joined: str, first: tuple, second: tuple) -> None:
    n, s, v, g, b, own = first
    m, t, w, h, c, other = second
    text = joined.format(n=n, s=s, S=s.capitalize(), v=v, g=g, b=b, m=m, t=t, w=w, h=h, c=c)
    structure = EmbeddedInterpreter().interpret(text).structure
    read = [(o.spec.placement.position, *(p.action for p in o.spec.phases)) for o in structure.objects]
    assert sorted(read) == sorted([own, other]), text
    assert not structure.ego.spec.phases


@pytest.mark.parametrize(
    ("text", "types", "acts"),
    [
        ("The driver ahead turns left.", ["car"], [["turn_left"]]),
        ("The driver behind honks and overtakes.", ["car"], [["overtake"]]),
        ("The motorist in the left lane cuts in.", ["car"], [["cut_in"]]),
        ("Neither the van ahead nor the bus behind brakes.", ["bus", "van"], [[], []]),
        ("Not a pedestrian but a cyclist crosses from the right.", ["bicycle"], [["cross_road"]]),
        ("The car ahead almost stops and then accelerates.", ["car"], [["brake", "accelerate"]]),
    ],
)
def test_who_is_there_and_who_is_not(text: str, types: list[str], acts: list[list[str]]) -> None:
    structure = EmbeddedInterpreter().interpret(text).structure
    assert sorted(o.spec.type for o in structure.objects) == types
    assert [[p.action for p in o.spec.phases] for o in structure.objects] == acts
