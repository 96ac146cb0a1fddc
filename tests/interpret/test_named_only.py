"""Who is only named, with a place, and what it then does: as in live comments and notes."""

import pytest

DEEDS = {  # noun, place, third person, participle
    "step out": ("pedestrian", "on the left", "steps out", "stepping out"),
    "run out": ("child", "on the right pavement", "runs into the road", "running into the road"),
    "swerve": ("cyclist", "ahead", "swerves", "swerving"),
    "brake": ("van", "ahead", "brakes hard", "braking hard"),
    "cut in": ("van", "in the left lane", "cuts in", "cutting in"),
    "drift": ("truck", "in the oncoming lane", "drifts into our lane", "drifting into our lane"),
    "pull out": ("parked car", "on the right", "pulls out", "pulling out"),
    "overtake": ("motorbike", "behind us", "overtakes us", "overtaking us"),
    "turn": ("car", "at the junction on the left", "turns across us", "turning across us"),
    "dash": ("dog", "on the verge on the left", "runs across the road", "running across the road"),
}
WAYS = [
    "{N} {p}, {ing}. We brake.",
    "{N} {p}. {V}. We brake.",
    "{N} {p}; {v}. We brake.",
    "{N} {p}: {v}. Ego brakes.",
    "{N} {p} - {v}.",
    "{N} {p}, then {v}.",
    "{N} {p}, and now {ing}.",
    "{N} {p} now {ing}.",
    "{N} {p} that is {ing}.",
    "There's a {n} {p}, {ing}.",
    "Got a {n} {p} here, {ing}.",
    "Watch the {n} {p}, {ing}. I brake.",
    "I see a {n} {p} {ing}.",
    "Note: {n} {p}, {v}. AV braked.",
]


def told(read, text: str) -> list[tuple]:
    specs = (o.spec for o in read(text).objects)
    return [(s.type, s.placement.position, s.placement.side, [p.action for p in s.phases]) for s in specs]


@pytest.mark.parametrize("way", WAYS)
def test_a_fragment_tells_as_much_as_a_sentence(read, way: str) -> None:
    for name, (n, p, v, ing) in DEEDS.items():
        plainly = told(read, f"We are driving along the road. A {n} {p} {v}. We brake.")
        assert plainly and plainly[0][3]
        assert told(read, way.format(n=n, N=n.capitalize(), p=p, v=v, V=v.capitalize(), ing=ing)) == plainly, name


@pytest.mark.parametrize(
    "text", ["Bus at the stop. A boy steps out. We brake.", "Bus on the right. Pulls away. We brake."]
)
def test_what_is_watched_is_not_driven(read, text: str) -> None:
    structure = read(text)
    assert structure.ego.spec.type == "car" and structure.objects


@pytest.mark.parametrize(
    "text",
    [
        "A bus, having taken on passengers in a bay on the right, rejoins the road in front of a car.",
        "Ego in the right lane, overtaking a van.",
    ],
)
def test_a_participle_of_somebody_with_a_verb_stays_with_it(read, text: str) -> None:
    structure = read(text)
    assert "overtake" not in {p.action for o in structure.objects for p in o.spec.phases}
    assert structure.ego.spec.type != "bus"
