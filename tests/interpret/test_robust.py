"""Any text gives S or a sentence that says why not: other languages, code, verse, tables, random words."""

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from c2s_engine.interpret import EmbeddedInterpreter, InterpreterFault, InterpretError, embedded, turn, typologies
from c2s_engine.interpret.reading.spelling import NormalisedText
from c2s_engine.session import reader
from c2s_engine.session.reader import Unreadable
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
        assert str(refused).endswith((".", "”."))
        return
    Structure.model_validate(structure.model_dump())
    for component in structure.components:
        spans = [link.span for link in component.links] + [note.span for note in component.unmet]
        for span in spans:
            assert span is None or 0 <= span[0] < span[1] <= len(text)


@settings(max_examples=40, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(WORDS, max_size=45).map(" ".join))
def test_word_salads_never_defeat_the_interpreter(text: str) -> None:
    check(text)


@pytest.mark.full
@settings(max_examples=400, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@example("a crosses van a")
@given(st.one_of(st.lists(WORDS, max_size=90).map(" ".join), st.text(max_size=400)))
def test_many_word_salads_never_defeat_the_interpreter(text: str) -> None:
    check(text)


@settings(max_examples=60)
@given(st.lists(WORDS, max_size=40).map(" ".join))
def test_places_in_the_mended_text_lead_back_in_order(text: str) -> None:
    mended = NormalisedText(text)
    back = [mended.back(i) for i in range(len(mended.text) + 1)]
    assert all(0 <= i <= len(text) for i in back)
    assert mended.text != text or back == list(range(len(text) + 1))


OTHERS = [
    "Ego fährt mit 50 km/h auf der Autobahn und ein Lkw schert ein.",
    "Das Ego-Fahrzeug bremst, weil ein Kind auf die Straße läuft.",
    "Le véhicule devant freine brusquement; l'ego doit s'arrêter.",
    "Un coche frena de repente delante del vehículo y el ciclista cruza la calle.",
    "De auto voor ons remt plotseling en de fietser steekt over.",
    "Samochód przed nami nagle hamuje, a pieszy wchodzi na jezdnię.",
    "自动驾驶汽车在路口左转，一名行人横穿马路。",
    "Машина впереди резко тормозит.",
    "asdf qwer zxcv uiop hjkl",
    "lorem ipsum dolor sit amet consectetur adipiscing elit",
]
ENGLISH = [
    "Ego 50 km/h, lead car brakes hard, gap 20 m.",
    "V1 NB rear-ended V2 at the stop line.",
    "moose on rd, ego swerves",
    "teh car infront braks sudenly and ego stoped",
    "A granny with a pram steps off the kerb by the chippy.",
]


@pytest.mark.parametrize("text", OTHERS)
def test_other_languages_and_nonsense_are_told_as_such(text: str) -> None:
    with pytest.raises(InterpretError, match="This text is not English"):
        EmbeddedInterpreter().interpret(text)
    lead = EmbeddedInterpreter().interpret("A car brakes in front of ego.").structure
    turned = turn.route(text, lead)
    assert (turned.kind, turned.edits) == ("edit", [])
    assert "This text is not English" in turned.reply


@pytest.mark.parametrize(
    "text",
    ["I like cheese and my grandmother has a nice garden.", "My dog eats a banana while the moon sings about cars."],
)
def test_english_in_which_nobody_does_anything_is_no_scenario(text: str) -> None:
    with pytest.raises(InterpretError, match="^This describes no driving scenario: "):
        EmbeddedInterpreter().interpret(text)


def test_what_looks_like_english_is_answered_with_the_language_that_is_read() -> None:
    lead = EmbeddedInterpreter().interpret("A car brakes in front of ego.").structure
    assert "in English" in turn.route("Ein Auto bremst stark vor dem Ego.", lead).reply
    with pytest.raises(InterpretError, match="in English"):
        EmbeddedInterpreter().interpret("hallo welt")


@pytest.mark.parametrize("text", ENGLISH)
def test_notes_slips_and_shorthand_are_english(text: str) -> None:
    EmbeddedInterpreter().interpret(text)


def test_a_fault_of_the_interpreter_is_raised_with_its_cause_and_told_in_a_sentence(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    lead = EmbeddedInterpreter().interpret("A car brakes in front of ego.").structure

    def fails(*_: object) -> None:
        raise KeyError("zeppelin")

    monkeypatch.setattr(typologies, "understand", fails)
    monkeypatch.setattr(turn, "_route", fails)
    for act in (
        lambda: EmbeddedInterpreter().interpret("A zeppelin brakes."),
        lambda: turn.route("make the car a zeppelin", lead),
    ):
        with pytest.raises(InterpreterFault, match=r"KeyError in (embedded|turn)\.py.*report") as fault:
            act()
        assert isinstance(fault.value.__cause__, KeyError)
    with pytest.raises(Unreadable, match="please report it"):
        reader._answer("interpret", ("A zeppelin brakes.",))
    asked = reader._answer("route", ("make the car a zeppelin", lead, None))
    assert asked.edits == () and "please report it" in asked.reply


def test_a_number_that_s_does_not_take_is_said() -> None:
    said = r"^A speed is at most 360 km/h: correct the text\. Nothing was changed\.$"
    with pytest.raises(InterpreterFault, match=said):
        EmbeddedInterpreter().interpret("Ego drives at 900 km/h. A car ahead brakes.")
    lead = EmbeddedInterpreter().interpret("A car ahead of ego brakes.").structure
    with pytest.raises(InterpreterFault, match="^A speed is not below 0"):
        turn.route("ego drives -20 km/h", lead)


def test_what_is_beyond_the_longest_text_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(embedded, "READ_AT_MOST", 60)
    found = EmbeddedInterpreter().interpret("Ego drives at 50 km/h. It rains at dusk. " * 3)
    assert found.not_understood[-1].reason == "only the first 60 characters are read"
