"""The same crash told in many manners: the parties, where they come from, what they do and who strikes whom agree."""

import pytest

CRASHES = {
    "turn": [
        (
            "V1 was northbound. V2 was southbound and turned left in front of V1. V1 struck the right "
            "side of V2 at the intersection."
        ),
        (
            "Vehicle 1 was traveling north on Oak St. Vehicle 2 was traveling south on Oak St and made a "
            "left turn at Elm in front of Vehicle 1. The front of Vehicle 1 hit the right side of "
            "Vehicle 2."
        ),
        "V2, southbound, turned left across the path of V1, which was northbound, at the intersection. V1 struck V2.",
        (
            "V2 attempted a left turn at the intersection and was struck by V1, which was coming from "
            "the opposite direction."
        ),
        "At the intersection, V2 turned left in front of oncoming V1 and was struck in the right side.",
        (
            "D1 stated she was northbound when V2, southbound, made a left turn in front of her at the "
            "intersection. She hit V2."
        ),
        (
            "I was driving north when a car coming the other way turned left in front of me at the "
            "intersection and I hit it."
        ),
        (
            "I was going straight through the intersection when the oncoming car turned left across me. "
            "I couldn't stop and hit its side."
        ),
        (
            "The AV was proceeding north. A sedan traveling south made a left turn in front of the AV at "
            "the intersection and the AV made contact with the right side of the sedan."
        ),
        (
            "While V1 was going straight through the intersection, V2 came from the opposite direction "
            "and turned left. V1 collided with V2."
        ),
        "V1 N/B. V2 S/B turning left at intersection. V1 struck V2.",
        (
            "P-1 was driving V-1 n/b. P-2 was driving V-2 s/b and made a left turn at the intersection "
            "directly in front of V-1. The front of V-1 struck V-2."
        ),
        (
            "Driver 2 failed to yield while turning left at the intersection and was hit by Driver 1, "
            "who was approaching from the opposite direction."
        ),
        (
            "Unit 2 made a left turn at the intersection in front of Unit 1, coming from the other "
            "direction, and Unit 1 hit Unit 2."
        ),
        (
            "The crash happened at an intersection when V2 turned left into the path of V1. V1, "
            "traveling in the opposite direction, struck V2."
        ),
        "V1 collided with V2 at the intersection as V2, an oncoming vehicle, was turning left.",
    ],
    "ped": [
        "V1 was eastbound. A pedestrian crossed the road from the right and V1 struck the pedestrian.",
        "V1, eastbound, struck a pedestrian who was crossing the road from the right.",
        "A pedestrian crossing the road from the right was struck by V1, which was eastbound.",
        "A pedestrian was hit by V1 as he crossed the road from the right.",
        "D1 was eastbound when a pedestrian crossed the road from the right. D1 hit the pedestrian.",
        "I was driving along when a man crossed the road from my right and I hit him.",
        "I hit a woman who was crossing the road from the right.",
        "The AV made contact with a pedestrian who was crossing the road from the right.",
        "P-2 (pedestrian) was crossing the road from the right. P-1 was driving V-1 and struck P-2.",
        "The pedestrian was crossing from the right side of the road when V1 hit her.",
        "A woman was knocked down by a car while crossing the road from the right.",
        "A car knocked down a woman who was crossing the road from the right.",
        "V1 hit a pedestrian. The pedestrian was crossing the road from the right.",
        "Unit 1 struck a pedestrian crossing from right to left.",
    ],
    "headon": [
        "V1 was eastbound. V2 was westbound, crossed the centerline and struck V1 head-on.",
        "V2, westbound, crossed the center line and collided head-on with V1, which was eastbound.",
        "V2 came across the centre line and hit V1 head-on.",
        "V1 was eastbound when V2, traveling in the opposite direction, crossed the centerline and struck V1 head-on.",
        "An oncoming car crossed the centerline and hit V1 head-on.",
        "V2 drifted over the centerline into V1's lane and the front of V2 struck the front of V1.",
        "I was driving along when an oncoming car came onto my side of the road and hit me head-on.",
        "V1 and V2 were traveling in opposite directions. V2 crossed the centerline and struck V1 head-on.",
        "D2 fell asleep, crossed the centerline and hit V1, eastbound, head-on.",
        "V1 was struck head-on by V2, which had crossed the centerline.",
        "A westbound car crossed the centerline and struck the AV, which was eastbound, head-on.",
    ],
    "offroad": [
        "V1 was northbound, ran off the road to the right and struck a tree.",
        "V1 left the roadway on the right side and hit a tree.",
        "V1 went off the right side of the road and collided with a tree.",
        "The driver of V1 lost control, ran off the road to the right and hit a tree.",
        "D1 ran off the road right and struck a tree.",
        "V1 departed the road to the right. The front of V1 struck a tree.",
        "I went off the road to the right and hit a tree.",
        "V1 drifted off the right edge of the road and its front hit a tree.",
        "A car left the road to the right and hit a tree.",
        "V1 was northbound when it ran off the right side of the road, striking a tree.",
        "Vehicle 1 exited the roadway to the right and impacted a tree.",
        "The vehicle left the road on the right before hitting a tree.",
        "V1 veered off the road to the right and into a tree.",
        "A tree was struck by V1 after it left the road to the right.",
    ],
    "backing": [
        "V1 was stopped behind V2. V2 backed up and struck V1.",
        "V2 was in front of V1, which was stopped. V2 reversed and hit V1.",
        "V2 reversed into V1, which was stopped behind it.",
        "V1 was stopped behind V2 when V2 backed into V1.",
        "I was stopped behind a car and it reversed into me.",
        "I was stationary behind a car when the driver reversed into the front of my car.",
        "The AV was stopped behind a car. The car backed up and made contact with the front bumper of the AV.",
        "V2 backed into V1. V1 was stopped behind V2.",
        "V1 was hit by V2, which was backing up. V1 was stopped behind V2.",
        "The car in front reversed into V1, which was stopped.",
    ],
    "swerve": [
        "V1 swerved to the left to avoid a deer in the road and struck a guardrail on the left.",
        "To avoid a deer in the road, V1 swerved left and hit the guardrail.",
        "I swerved to the left to avoid a deer in the road and hit the guardrail.",
        "The driver of V1 saw a deer in the road, swerved to the left and struck a guardrail.",
        "Avoiding a deer in the road, V1 swerved to the left and hit the guardrail.",
    ],
}
STRAIGHT_ON = "go_straight"


def told(read, text: str) -> tuple:
    """What ego does, and who else is where and does what."""
    s = read(text)
    own = [p.action for p in s["E"].spec.phases if p.action != STRAIGHT_ON]
    others = [(o.spec.type, o.spec.placement.position, *(p.action for p in o.spec.phases)) for o in s.objects]
    return s["R"].spec.kind, s["E"].spec.type, own, sorted(others)


@pytest.mark.parametrize("crash", CRASHES)
def test_a_manner_of_telling_changes_nothing(read, crash: str) -> None:
    first, *others = CRASHES[crash]
    plainly = told(read, first)
    assert plainly[3]
    for text in others:
        assert told(read, text) == plainly, text


CHAINS = [
    "V1 struck V2, which was stopped ahead, and V2 was pushed into V3, which was stopped ahead of V2.",
    "V3 and V2 were stopped in traffic, V2 behind V3. V1 rear-ended V2 and pushed it into V3.",
    "V2 was stopped behind V3, which was also stopped. V1 hit the rear of V2, which was then pushed into V3.",
    "V2 was stopped behind V3. V1 ran into V2 from behind. The impact pushed V2 into V3.",
    "V1 collided with the stopped V2, knocking it into V3, stopped ahead of it.",
]


@pytest.mark.parametrize("text", CHAINS)
def test_a_chain_of_three(read, text: str) -> None:
    s = read(text)
    named = {o.spec.name: o for o in s.objects}
    assert set(named) == {"v2", "v3"}
    assert [(p.action, p.target) for p in s["E"].spec.phases] == [("collide", named["v2"].id)]
    assert all([p.action for p in o.spec.phases] == ["stationary"] for o in s.objects)
