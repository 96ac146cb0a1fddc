"""Any text gives S or a sentence that says why not: other languages, code, verse, tables, random words."""

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from c2s_engine.interpret import EmbeddedInterpreter, InterpretError, typologies
from c2s_engine.interpret.reading.spelling import Mended
from c2s_engine.structure.components import Structure

STRANGE = [
    "Das Ego-Fahrzeug bremst, weil ein Kind auf die Straße läuft.",
    "自动驾驶汽车在路口左转，一名行人横穿马路。",
    "Le véhicule devant freine brusquement; l'ego doit s'arrêter.",
    "السيارة تتوقف فجأة أمام المركبة",
    "def ego(v=50):\n    return v / 3.6  # km/h\nfor car in cars: car.brake()",
    "SELECT * FROM vehicles WHERE speed > 50; -- DROP TABLE lanes",
    "<html><body><p>Ego &amp; car</p></body></html>",
    "The road was a ribbon of moonlight over the purple moor,\nand the rider came riding, riding.",
    "ego ego ego ego: : : ; ; -> -> | | / / () (( ))",
    "|a|b|\n|-|-|\n|ego speed|x|\n|speed|50 km/h|",
    "V1 V2 V3 V4 V5 V6 V7 V8 V9 hit each other.",
    "🚗💥🚙 at 50 km/h 🌧️",
    "\u202eego brakes\u202c \u0000 car\ufeff ahead",
    "a) b) c) 1. 2. 3. Step 4: Event 5:",
    "km/h m s ft mph 50 60 - 70 to 80 and 90 or 100",
    "Vehicle 1 swerved, hitting Vehicle 3. A boy ran in front of a car. Accounts of riders and walkers.",
]
WORDS = st.sampled_from(
    [
        "ego", "the", "a", "an", "it", "which", "where", "who", "both", "V1", "V2", "D1", "truck", "A", "B", "car",
        "van", "bus", "jam", "moose", "granny", "Ford", "BMW", "ambulance", "driver", "door", "brakes", "slows",
        "stops", "turns", "left", "right", "crosses", "merges", "cuts", "in", "front", "of", "ahead", "behind",
        "into", "lane", "lanes", "2", "intersection", "roundabout", "ramp", "kerb", "at", "50", "60", "km/h", "mph",
        "20", "m", "s", "%", "+", "-", "->", "/", ":", ";", ",", ".", "(", ")", "|", "=", "<", "and", "or", "but",
        "while", "when", "after", "before", "until", "not", "no", "never", "must", "has", "to", "waits", "yields",
        "red", "green", "light", "stop", "sign", "night", "rain", "fog", "westbound", "northbound", "second", "first",
        "another", "other", "them", "parked", "stopped", "slow", "oncoming", "decelerating", "following", "collision",
        "with", "manoeuvre", "departure", "five", "zero", "\n-", "\n1.", "\n|",
    ]
)  # fmt: skip


@pytest.mark.parametrize("text", STRANGE)
def test_strange_texts_are_read_or_refused_in_a_sentence(read, text: str) -> None:
    check(text)


def check(text: str) -> None:
    try:
        structure = EmbeddedInterpreter().interpret(text).structure
    except InterpretError as refused:
        assert refused.__cause__ is None, repr(refused.__cause__)
        assert str(refused).endswith((".", "”."))
        return
    Structure.model_validate(structure.model_dump())
    assert not any("could not be read beside" in u.reason for u in structure.not_understood), "a stage failed"
    for component in structure.components:
        spans = [link.span for link in component.links] + [note.span for note in component.unmet]
        for span in spans:
            assert span is None or 0 <= span[0] < span[1] <= len(text)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(WORDS, max_size=45).map(" ".join))
def test_word_salads_never_defeat_the_interpreter(text: str) -> None:
    check(text)


@pytest.mark.full
@settings(max_examples=400, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@example("a crosses van a")
@given(st.one_of(st.lists(WORDS, max_size=90).map(" ".join), st.text(max_size=400)))
def test_many_word_salads_never_defeat_the_interpreter(text: str) -> None:
    check(text)


@settings(max_examples=60, deadline=None)
@given(st.lists(WORDS, max_size=40).map(" ".join))
def test_places_in_the_mended_text_lead_back_in_order(text: str) -> None:
    mended = Mended(text)
    back = [mended.back(i) for i in range(len(mended.text) + 1)]
    assert all(0 <= i <= len(text) for i in back)
    assert mended.text != text or back == list(range(len(text) + 1))


def test_a_sentence_that_defeats_the_reader_is_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = typologies.understand

    def fails(text: str):
        if "zeppelin" in text:
            raise KeyError("zeppelin")
        return whole(text)

    monkeypatch.setattr(typologies, "understand", fails)
    text = "Ego follows a truck. A zeppelin overtakes the moon. The truck brakes hard."
    got = EmbeddedInterpreter().interpret(text)
    assert [p.action for p in got.structure.objects[0].spec.phases] == ["brake"]
    assert [u.text for u in got.structure.not_understood] == ["A zeppelin overtakes the moon."]
    assert text[slice(*got.not_understood[-1].span)] == "A zeppelin overtakes the moon."
    assert got.structure.text == text
    with pytest.raises(InterpretError, match="plainer"):
        EmbeddedInterpreter().interpret("A zeppelin brakes.")
