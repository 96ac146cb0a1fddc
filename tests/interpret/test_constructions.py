"""The same motion told in many constructions of English gives the same road user, place and action."""

import pytest

DEEDS = {  # subject, third person, past, base form, participle
    "brake": ("a van ahead of ego", "brakes hard", "braked hard", "brake hard", "braking hard"),
    "speed up": ("a van ahead of ego", "accelerates", "accelerated", "accelerate", "accelerating"),
    "cut in": ("a van in the left lane", *(f"{v} in in front of ego" for v in ("cuts", "cut", "cut", "cutting"))),
    "change": ("a van in the left lane", *(f"chang{e} into ego's lane" for e in ("es", "ed", "e", "ing"))),
    "turn": ("an oncoming van", *(f"turn{e} left across ego's path" for e in ("s", "ed", "", "ing"))),
    "lose control": ("an oncoming van", *(f"{v} control" for v in ("loses", "lost", "lose", "losing"))),
    "pull out": ("a parked van", *(f"pull{e} out of a parking space in front of ego" for e in ("s", "ed", "", "ing"))),
    "reverse": ("a van ahead of ego", *(f"revers{e} towards ego" for e in ("es", "ed", "e", "ing"))),
    "slow": ("a van ahead of ego", *(f"slow{e} down to 20 km/h" for e in ("s", "ed", "", "ing"))),
    "cross": ("a cyclist", *(f"cross{e} the road from the right" for e in ("es", "ed", "", "ing"))),
}
WAYS = [
    "{S} {past}.",
    "Ego sees {s} {ing}.",
    "There is {s} which {v}.",
    "Ego encounters {s} {ing}.",
    "{S} begins {ing}.",
    "Ego must brake because {s} {v}.",
    "When {s} {v}, ego brakes.",
    "We need {s} to {base}.",
    "I want {s} to {base}.",
    "Create a scene with {s} {ing}.",
    "Ego drives at 50 km/h with {s} {ing}.",
    "Ego is confronted with {s} {ing}.",
    "The ego vehicle has to deal with {s} that is {ing}.",
    "A collision is imminent as {s} {v}.",
    "Let {s} {base}.",
    "Have {s} {base}.",
    "Due to {s} {ing}, ego must brake.",
    "Ego, going 50 km/h, notices {s} {ing}.",
    "Precondition: ego drives at 50 km/h. Event: {s} {v}. Expected: ego brakes.",
    "- ego at 50 km/h\n- {s} {v}\n- ego brakes",
]


def told(read, text: str) -> list[tuple]:
    """Who is there, where, and what each does."""
    specs = (o.spec for o in read(text).objects)
    return [(s.type, s.placement.position, [p.action for p in s.phases]) for s in specs]


@pytest.mark.parametrize("way", WAYS)
def test_a_construction_changes_nothing(read, way: str) -> None:
    for name, (s, v, past, base, ing) in DEEDS.items():
        capital = s[0].upper() + s[1:]
        plainly = told(read, f"{capital} {v}.")
        assert plainly and plainly[0][2]
        assert told(read, way.format(s=s, S=capital, v=v, past=past, base=base, ing=ing)) == plainly, name


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives past a truck parking area at 50 km/h.",
        "A van in the lane that ends brakes.",
        "A car waits at a pedestrian crossing ahead of ego.",
    ],
)
def test_what_only_looks_like_a_participle_is_none(read, text: str) -> None:
    assert not {"enter_road", "stop", "cross_road"} & {p.action for o in read(text).objects for p in o.spec.phases}
