"""The same crash told in many manners: the parties, where they come from, what they do and who strikes whom agree."""

import pytest

CRASHES = {
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
]


@pytest.mark.parametrize("text", CHAINS)
def test_a_chain_of_three(read, text: str) -> None:
    s = read(text)
    named = {o.spec.name: o for o in s.objects}
    assert set(named) == {"v2", "v3"}
    assert [(p.action, p.target) for p in s["E"].spec.phases] == [("collide", named["v2"].id)]
    assert all([p.action for p in o.spec.phases] == ["stationary"] for o in s.objects)
