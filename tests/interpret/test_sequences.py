"""Two motions of one road user in many constructions of English come in their order."""

import pytest

PAIRS = [  # where it is; of the first motion third person, participle, past participle; of the second the first two
    ("a van in the left lane", *(f"{v} in in front of ego" for v in ("cuts", "cutting", "cut")), "brakes", "braking"),
    ("a van ahead of ego", "brakes hard", "braking hard", "braked hard", "accelerates", "accelerating"),
    ("a van in the left lane", "accelerates", "accelerating", "accelerated", "cuts in", "cutting in"),
    (
        "a van behind ego",
        *(f"{v} ego on the left" for v in ("overtakes", "overtaking", "overtaken")),
        "stops",
        "stopping",
    ),
    ("a van ahead of ego", "stops", "stopping", "stopped", "reverses towards ego", "reversing towards ego"),
]
WAYS = [
    "{S} {v1} before {g2}.",
    "After {g1}, {s} {v2}.",
    "{S} {v1} and then {v2}.",
    "{S} first {v1}, then {v2}.",
    "{S} {v2} after {g1}.",
    "{S} {v1}. It then {v2}.",
    "Having {p1}, {s} {v2}.",
    "As soon as {s} has {p1}, it {v2}.",
    "Once {s} has {p1}, it {v2}.",
    "1. {S} {v1}.\n2. It {v2}.",
    "{S}, after {g1}, {v2}.",
]


@pytest.mark.parametrize("way", WAYS)
def test_what_comes_first_comes_first(read, way: str) -> None:
    for s, v1, g1, p1, v2, g2 in PAIRS:
        text = way.format(s=s, S=s[0].upper() + s[1:], v1=v1, g1=g1, p1=p1, v2=v2, g2=g2)
        plainly = read(f"{s[0].upper()}{s[1:]} {v1} and {v2}.").objects
        expected = [p.action for p in plainly[0].spec.phases]
        assert len(expected) == 2
        assert [[p.action for p in o.spec.phases] for o in read(text).objects] == [expected], text
