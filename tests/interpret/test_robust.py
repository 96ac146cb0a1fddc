"""Any text and any answer give S or a sentence that says why not; nothing of a text is outside its account."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c2s_engine.interpret import InterpreterFault
from c2s_engine.interpret.english import is_english
from c2s_engine.interpret.errors import InterpretError, faults
from c2s_engine.interpret.learned import reading, units
from c2s_engine.structure.account import account
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import EditError

ANSWER = "G: weather=rain\nR: road\nE: car speed=50km/h ; brake\nO1: van at=ahead gap=20m ; stop\nX: a smile | 3 s"
SENTENCES = [
    "Ego drives at 50 km/h.", "A van brakes hard, and ego stops.", "the truck, which was parked, wobbles", "(rain)",
    "Two men were hurt!", "- ped X-ing @ zebra", "E/B unit 1 -> struck by V2;", "\n\n", "“No,” she said...", "🚗",
    "自动驾驶汽车在路口左转", "\u202eego brakes\u202c \u0000 car\ufeff ahead", "a) b) c) 1. 2. Step 4:",
    "with a smile, 3 s",
]  # fmt: skip


@given(st.lists(st.sampled_from(SENTENCES) | st.text(max_size=12), min_size=1, max_size=4).map(" ".join))
def test_nothing_of_any_text_is_outside_the_account(text: str) -> None:
    structure = reading(ANSWER, text)
    assert structure is not None
    Structure.model_validate(structure.model_dump())
    found = account(structure)
    held = {i for c in found for i in range(*c.span)}
    assert all(text[i].isspace() for i in set(range(len(text))) - held)
    assert all(c.text == text[slice(*c.span)] for c in found)
    assert all(c.components or c.lost for c in found), "a clause of which nothing is said"
    spans = [note.span for component in structure.components for note in (*component.links, *component.unmet)]
    assert all(span is None or 0 <= span[0] < span[1] <= len(text) for span in spans)


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


@pytest.mark.parametrize(("text", "english"), [*((t, False) for t in OTHERS), *((t, True) for t in ENGLISH)])
def test_english_and_what_is_none(text: str, english: bool) -> None:
    assert is_english(text) is english


@pytest.mark.parametrize(("error", "kind", "said"), [
    (KeyError("zeppelin"), InterpreterFault, r"KeyError in units\.py.*report"),
    (EditError("O1 is referred to by T: change that first"), InterpreterFault, r"that first. Nothing was changed.$"),
    (InterpretError("This is none."), InterpretError, "^This is none.$"),
])  # fmt: skip
def test_a_fault_is_told_in_a_sentence(error: Exception, kind: type[Exception], said: str) -> None:
    class Fails(dict):
        def get(self, *_: object) -> object:
            raise error

    with pytest.raises(kind, match=said), faults():
        units._said(3, [], "gap", Fails())
