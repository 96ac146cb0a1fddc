"""Questions and answers of a witness, abbreviations of the text's own, and what whoever is behind does."""

import pytest

from c2s_engine.interpret.reading.spelling import NormalisedText


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Q1. Which lane? A1. Right lane. Ego follows a truck.", "Which lane?"),
        ("A. Ego follows a truck. B. The truck brakes.", "A. Ego follows a truck. B."),
    ],
)
def test_only_questions_with_answers_are_read_so(text: str, said: str) -> None:
    assert said in NormalisedText(text).text
