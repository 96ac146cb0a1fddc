"""Who only asks for a scenario is not in it; who says "I" is never "he"."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "I need a scenario in which a taxi turns left at a crossroads and hits a cyclist.",
        "Please write me a scene where a taxi hits a cyclist at a crossroads while turning left.",
        "For my thesis I would like to see a taxi that turns left at a crossroads and hits a cyclist.",
        "Can you make a simulation where a taxi turns left at a crossroads and strikes a cyclist?",
    ],
)
def test_the_asker_is_not_ego(read, text: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == ["bicycle"]
    assert "collide" in [p.action for p in s["E"].spec.phases]


def test_first_person_is_never_he(read) -> None:
    s = read("I'm doing 90 in the left lane. A sedan is ahead of me. Okay, he has moved over right. I get past him.")
    assert len(s.objects) == 1 and s["O1"].spec.phases[0].side == "right"
    assert [p.action for p in s["E"].spec.phases] == ["overtake"]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("The robot car behind the coach stopped.", "car"),
        ("My lorry was hit from behind by a taxi.", "truck"),
    ],
)
def test_who_is_called_ego(read, text: str, kind: str) -> None:
    s = read(text)
    assert s["E"].spec.type == kind and len(s.objects) <= 1
