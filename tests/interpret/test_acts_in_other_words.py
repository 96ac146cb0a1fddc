"""The same act in the other words that people have for it comes out as the same phase."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

ACTS = {
    "accelerate": (
        "puts its foot down",
        "guns the engine",
        "opens up",
    ),
    "brake": (
        "lifts off",
        "backs off",
        "lets off the gas",
        "takes its foot off the accelerator",
        "comes off the power",
    ),
    "stop": (),
    "cut_out": ("swings out", "peels off", "ducks out", "jumps out of the lane", "changes lane", "changes lanes late"),
    "swerve": ("takes evasive action to the left", "makes an evasive manoeuvre"),
}


@pytest.mark.parametrize(("act", "words"), [(act, words) for act, all_words in ACTS.items() for words in all_words])
def test_an_act_in_other_words(act: str, words: str) -> None:
    structure = EmbeddedInterpreter().interpret(f"The car ahead of ego {words}.").structure
    assert [p.action for p in structure.objects[0].spec.phases] == [act]


@pytest.mark.parametrize(
    ("text", "act"),
    [
        ("The parked car on the right starts moving.", "enter_road"),
        ("The parked van on the right gets going.", "enter_road"),
        ("The stationary van ahead starts to roll.", "start"),
        ("The truck ahead starts rolling backwards.", "reverse"),
        ("The car ahead starts moving into the left lane.", "cut_out"),
    ],
)
def test_one_begins_to_move(text: str, act: str) -> None:
    structure = EmbeddedInterpreter().interpret(text).structure
    assert structure.objects[0].spec.phases[-1].action == act
