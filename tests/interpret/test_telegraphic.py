"""Notes without verbs: what they are spelt out to, and the scene that is read from them."""

import pytest

from c2s_engine.interpret.reading.spelling import NormalisedText


@pytest.mark.parametrize(
    ("note", "sentences"),
    [
        (
            "ego 50 r lane, van 60 l lane 10 m behind, cuts in",
            "ego drives at 50 km/h in the right lane. van drives at 60",
        ),
        ("lead @ 40, gap 25, full stop", "lead drives at 40 km/h. The lead is 25 m ahead of ego. The lead stops"),
        ("ego + lead both 70 kph", "ego drives at 70 kph. lead drives at 70 kph"),
        ("truck A 85 right lane, truck B 88 alongside left lane", "in the left lane alongside truck A"),
        ("lead decel 6 m/s2 after 3 s, ego 50", "lead brakes at 6 m/s2 after 3 s"),
    ],
)
def test_notes_become_sentences(note: str, sentences: str) -> None:
    assert sentences.lower() in NormalisedText(note).text.lower()


@pytest.mark.parametrize(
    "text",
    [
        "The van in the left lane cuts in at 20 m.",
        "A truck drives ahead of ego at 60 km/h.",
        "Lead vehicle decelerating on a wet road",
        "V2 stopped at the line.",
    ],
)
def test_plain_sentences_stay_as_they_are(text: str) -> None:
    assert NormalisedText(text).text == text


def objects(read, text: str) -> dict:
    return {c.spec.type: c.spec for c in read(text).objects}
