"""Each stage by itself: quantities, names, spelling, agents, modes, relations."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import pytest

from c2s_engine.interpret import understanding
from c2s_engine.interpret.reading import amounts, division, scan
from c2s_engine.interpret.reading.spelling import NormalisedText


def quantity(text: str) -> tuple[str, float, float]:
    found = amounts.quantities(scan.normalised(text))
    assert len(found) == 1, found
    return found[0].data["dimension"], round(found[0].data["low"], 2), round(found[0].data["high"], 2)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("at 36 km/h", ("speed", 10.0, 10.0)), ("30 mph", ("speed", 13.41, 13.41)), ("35-40 km/h", ("speed", 9.72, 11.11)), ("12 m/s", ("speed", 12.0, 12.0)),
        ("6 m/s²", ("acceleration", 6.0, 6.0)), ("0.5 g", ("acceleration", 4.91, 4.91)), ("80 ft ahead", ("distance", 24.38, 24.38)), ("twenty metres", ("distance", 20.0, 20.0)),
        ("between 20 and 30 m", ("distance", 20.0, 30.0)), ("a dozen seconds", ("time", 12.0, 12.0)), ("two car lengths", ("distance", 9.6, 9.6)), ("1.5 s", ("time", 1.5, 1.5)),
    ],
)  # fmt: skip
def test_quantities_are_read_in_si(text: str, expected: tuple[str, float, float]) -> None:
    assert quantity(text) == expected


@pytest.mark.parametrize("text", ["İstanbul’da “ego” — Ｖ１", "e\u0301go \u202f brakes\t", "Straße ﬁne"])
def test_the_normalised_text_keeps_every_offset(text: str) -> None:
    assert len(scan.normalised(text)) == len(text)


def test_sentences_do_not_end_at_abbreviations_and_numbers() -> None:
    text = "V1 drove approx. 3.5 m/s on Main St. in the rain, e.g. slowly. V2 stopped; it waited.\n- It left"
    assert [text[s:e] for s, e in division.sentences(text)] == [
        "V1 drove approx. 3.5 m/s on Main St. in the rain, e.g. slowly.", "V2 stopped;", "it waited.", "It left",
    ]  # fmt: skip


def test_misspellings_are_mended_and_mapped_back() -> None:
    text = "the vehcile brakes sudenly"
    mended = NormalisedText(text)
    assert mended.text == "the vehicle brakes suddenly"
    at = mended.text.index("suddenly")
    assert text[mended.back(at) : mended.back(at + len("suddenly"))] == "sudenly"


def test_words_that_are_right_stay_as_they_are() -> None:
    text = "The motorcyclist lost traction near the kerb and the lorry slewed sideways."
    assert NormalisedText(text).text == text


def acts(text: str) -> list[tuple[str, str, str, str | None]]:
    found = understanding.understand(text)
    return [(e.agent.key, e.act, e.mode, e.patient.key if e.patient else None) for e in found.clauses.events]


def test_passive_and_active_have_the_same_agent() -> None:
    assert ("a1", "collide", "fact", "ego") in acts("Ego was hit from behind by a truck.")
    assert ("a1", "collide", "fact", "ego") in acts("A truck hit ego from behind.")


def test_a_denied_act_is_no_fact() -> None:
    assert [m for _, a, m, _ in acts("The ego fails to brake.") if a == "brake"] == ["negated"]
    assert [m for _, a, m, _ in acts("Ego passes the truck without braking.") if a == "brake"] == ["negated"]


def test_after_and_before_put_events_in_order() -> None:
    order = [a for _, a, _, _ in acts("The van brakes after it has overtaken the ego.")]
    assert order.index("overtake") < order.index("brake")


def test_the_parser_does_not_load_torch() -> None:
    import subprocess
    import sys

    code = "import sys; from c2s_engine.interpret import EmbeddedInterpreter as E; E().interpret('a car brakes ahead of ego'); print('torch' in sys.modules)"
    assert (
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()
        == "False"
    )
