"""Parties by a code of the text's own ("01 = lorry"), by their part in a suit, by a vehicle named in a head."""

import pytest

from c2s_engine.interpret.reading.spelling import NormalisedText


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


@pytest.mark.parametrize(
    "text",
    [
        "S1: lorry, broken down, hard shoulder. S2: ego at 100 km/h.",
        "On the M1: lorry, right lane, 80 km/h. Ego: middle lane.",
        "V1: lorry, right lane, 80 km/h. V2: car, left lane.",
        "Step 2: van ahead brakes.",
    ],
)
def test_steps_roads_and_known_labels_are_no_codes(text: str) -> None:
    assert "VOI" not in NormalisedText(text).text
