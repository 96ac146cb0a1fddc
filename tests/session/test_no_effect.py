"""Words of a text that nothing in S says are named."""

import pytest
from session_fake import FakeEngine

from c2s_engine.api import Engine
from c2s_engine.interpret.learned import reading
from c2s_engine.interpret.learned.change import changed_structure
from c2s_engine.interpret.phrases import phrases_of
from c2s_engine.session.no_effect import REASON, phrases_sentence
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished

CUTS_IN = "R: motorway\nE: car speed=100km/h\nO1: car at=right_lane along=ahead ; cut_in side=left gap=15m"
BRAKES = "R: road\nE: car speed=50km/h\nO1: car at=ahead ; brake rate=6m/s2"
CASES = [
    ("Ego drives on a motorway at 100 km/h. A car in the right lane cuts in 15 m ahead of ego.", CUTS_IN, []),
    ("Ego drives at 50 km/h. A red car ahead of ego brakes hard without indicating.", BRAKES,
     ["red", "without indicating"]),
    ("Ego drives at 50 km/h. My cousin owns a boat. A car ahead brakes.", BRAKES, []),  # named as background
    ("Ego drives at 50 km/h with a smile. A car ahead brakes.", f"{BRAKES}\nX: with a smile", []),  # named as left out
    ("Ego goes straight on at a signalised intersection. A car comes towards it.",
     "R: intersection control=signal manoeuvre=straight\nE: car\nO1: car at=opposite_approach", []),
]  # fmt: skip


@pytest.fixture(scope="module")
def engine():
    return Engine()


@pytest.mark.parametrize(("text", "answer", "idle"), CASES, ids=[t[:40] for t, _, _ in CASES])
async def test_what_nothing_in_s_says_is_named(engine, text, answer, idle):
    structure = reading(answer, text)
    found = await engine.without_effect(text, structure)
    assert [u.text for u in found] == idle
    assert all(text[u.span[0] : u.span[1]].strip(" ,;.") == u.text and u.reason == REASON for u in found)


async def test_of_a_change_what_s_does_not_say_after_it(engine):
    structure = reading(BRAKES, "Ego drives at 50 km/h. A car ahead brakes.")
    found = await engine.without_effect("make the car brake with 6 m/s2, with a nice driver", structure)
    assert [u.text for u in found] == ["with a nice driver"]
    assert phrases_sentence(found) == "Nothing in S says: “with a nice driver”."


@pytest.mark.parametrize(
    ("text", "line", "lost"),
    [
        ("make the car slower", "O1: speed=30km/h", []),
        ("make the car slower", "O1: gap=30m", ["make the car slower"]),
        ("add a car 5 m closer behind ego", "+O2: car at=behind gap=5m", []),
        ("make the car a van and let ego drive 35 km/h", "O1: van", ["35 km/h"]),
        ("put the car 5 m closer", "O1: gap=20m", []),
        ("remove the car", "-O1", []),
        ("add a van behind ego and remove the braking", "+O2: van at=behind", ["remove the braking"]),
        ("add a van behind ego and remove the braking", "O1: ;\n+O2: van at=behind", []),
        ("remove the car and add a bus that turns left in front of ego", "-O1", ["bus"]),
    ],
)
async def test_of_a_change_the_fields_that_it_changed_say_it_and_no_others(engine, text, line, lost):
    before = reading(BRAKES, "Ego drives at 50 km/h. A car ahead brakes.")
    after = changed_structure(before, line.splitlines())
    assert [u.text for u in await engine.without_effect(text, after, before)] == lost


def test_what_the_model_left_out_though_fields_say_it_is_not_lost():
    text = "Ego drives at 50 km/h and has to brake. A car ahead brakes with a smile."
    structure = reading(f"{BRAKES.replace('50km/h', '50km/h reaction=brake')}\nX: has to brake | with a smile", text)
    assert [u.text for u in structure.not_understood] == ["with a smile"]


async def test_what_was_found_stays_with_the_session(tmp_path):
    """It is looked for once a text; a question about it, the session opened again and the app have the same."""
    text, idle = "A red car brakes.", Unmet(text="red", reason=REASON, span=(2, 5))

    class Describing(FakeEngine):
        looked, shown = 0, None

        async def say(self, structure, text, *, shown, **options):
            self.shown = shown
            done = structure if text.endswith("?") else Structure(text=text)
            yield Finished(ok=True, structure=done, program=assemble(done))

        async def without_effect(self, text, structure, before=None):
            self.looked += 1
            return (idle,)

    engine = Describing()
    session = Sessions(tmp_path).open("one", engine)
    assert session.idle is None
    async for _ in session.say(text):
        pass
    assert not engine.looked
    async for _ in session.say("what did you not understand?"):
        pass
    assert engine.shown.details["without_effect"] == (idle,)
    assert await session.without_effect() == session.idle == (idle,)
    async for _ in session.say("A blue car brakes."):
        pass
    session.keep_idle(text, (idle,))  # of a change now: its phrases lie in no text of S
    session.keep_idle("A blue car brakes.", ())
    async for _ in session.say("which words were not used?"):
        pass
    assert engine.shown.details["without_effect"] == (idle.model_copy(update={"span": None}),)
    async for _ in session.undo():
        pass
    session.close()
    again = Sessions(tmp_path).open("one", engine)
    assert again.idle == (idle,) and engine.looked == 1
    again.close()


def test_phrases_and_what_stands_between_commas():
    text = "A car brakes hard and stops behind a parked bus."
    assert {"and stops behind a parked bus", "behind a parked bus", "hard"} <= {text[a:b] for a, b in phrases_of(text)}
    note = "truck ahead, no hurry; rain"
    assert {"truck ahead", "no hurry", "rain"} <= {note[a:b] for a, b in phrases_of(note)}
