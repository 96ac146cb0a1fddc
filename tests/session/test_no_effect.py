"""Words of a text that make no difference to S are named."""

import pytest
from session_fake import FakeEngine

from c2s_engine.api import Engine
from c2s_engine.interpret.phrases import without_each
from c2s_engine.session.no_effect import REASON, UNSAID, phrases_sentence
from c2s_engine.session.reader import Unreadable, read
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished

CASES = [
    ("Ego drives on a motorway at 100 km/h. A car in the right lane cuts in 15 m ahead of ego.", []),
    ("Ego drives at 50 km/h. A red car ahead of ego brakes hard without indicating.", ["red", "without indicating"]),
    ("Ego follows a van at 60 km/h at night. My cousin owns a boat.", []),  # named as background
    ("A lorry behind ego stops in time. Ego stands at a red light.", ["in time"]),
    ("A child from the right, ego 30 km/h, at night, no collision", ["no collision"]),  # a note without a sentence
    ("Ego approaches a roundabout at 40 km/h. After ego has left the roundabout a pedestrian crosses on a crosswalk.",
     ["After ego has left the roundabout"]),
    ("Ego drives at 90 km/h on a motorway with three lanes. A truck ahead has jackknifed and blocks the middle "
     "and left lane.", ["middle and left"]),  # without it less is taken for granted
    ("Ego follows a truck at 50 km/h. The truck brakes hard and sings a song.", []),  # named as not understood
    ("V1 goes straight on at a junction. V2 turned left. The front of V1 struck the right side of V2 in light rain.",
     ["right", "light"]),
]  # fmt: skip


@pytest.fixture(scope="module")
def engine():
    return Engine()


@pytest.mark.parametrize(("text", "idle"), CASES, ids=[t[:40] for t, _ in CASES])
async def test_what_makes_no_difference_is_named(engine, text, idle):
    found = await engine.without_effect(text)
    assert [u.text for u in found] == idle
    assert all(text[u.span[0] : u.span[1]].strip(" ,;.") == u.text for u in found)


async def test_of_what_a_model_has_read_those_phrases_are_named_that_nothing_in_s_says(engine):
    """What the interpreter does without ("red", "without indicating") the model may have in S."""
    text = "Ego drives at 50 km/h. A red car ahead of ego brakes hard without indicating."
    read_so = (await read(text, engine.tools)).model_copy(update={"read_by": "reader", "not_understood": ()})
    found = await engine.without_effect(text, read_so=read_so)
    assert [(u.text, u.reason) for u in found] == [("red", UNSAID), ("without indicating", UNSAID)]
    assert phrases_sentence(found) == "Nothing in S says: “red”; “without indicating”."
    lead = read_so.objects[0]
    read_so = read_so.with_component(lead.model_copy(update={"description": "A red car brakes."}))
    assert [u.text for u in await engine.without_effect(text, read_so=read_so)] == ["without indicating"]


async def test_of_a_text_that_only_a_model_can_read_nothing_is_said(engine):
    text = "Ein Auto bremst vor uns."
    assert await engine.without_effect(text, read_so=Structure(text=text, read_by="typed")) == ()
    with pytest.raises(Unreadable):
        await engine.without_effect(text, read_so=Structure(text=text, read_by="embedded"))


CHANGES = [
    ("make the van a truck with a nice driver", ["with a nice driver"]),
    ("the van drives 80 km/h", []),
    ("what does the van do?", []),
    ("A bus stands in a bend. Ego drives at 50 km/h with little noise.", ["with little noise"]),
]


@pytest.mark.parametrize(("text", "idle"), CHANGES, ids=[t[:40] for t, _ in CHANGES])
async def test_what_makes_no_difference_to_a_change_is_named(engine, text, idle):
    cuts_in = "Ego drives at 100 km/h. A van in the left lane cuts in 20 m ahead of ego after 2 s."
    upon = await read(cuts_in, engine.tools)
    assert [u.text for u in await engine.without_effect(text, upon)] == idle


async def test_a_text_that_cannot_be_read_says_so(engine):
    with pytest.raises(Unreadable, match="No driving scene"):
        await engine.without_effect("Two plus two is four.")


async def test_what_was_found_stays_with_the_session(tmp_path):
    """It is looked for once a text; a question about it, the session opened again and the app have the same."""
    text, idle = "A red car brakes.", Unmet(text="red", reason=REASON, span=(2, 5))

    class Describing(FakeEngine):
        looked, shown = 0, None

        async def say(self, structure, text, *, shown, **options):
            self.shown = shown
            done = structure if text.endswith("?") else Structure(text=text)
            yield Finished(ok=True, structure=done, program=assemble(done))

        async def without_effect(self, text, read_so):
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


def test_phrases_are_taken_out_with_what_joins_them():
    text = "A car brakes hard and stops behind a parked bus."
    left = {text[a:b]: rest for (a, b), rest in without_each(text)}
    assert left["and stops behind a parked bus"] == "A car brakes hard."
    assert left["behind a parked bus"] == "A car brakes hard and stops."
    assert left["hard"] == "A car brakes and stops behind a parked bus."
    assert text not in left, "nothing would be left"


def test_what_stands_between_commas_is_a_phrase():
    note = "truck ahead, no hurry; rain"
    assert {"truck ahead", "no hurry", "rain"} <= {note[a:b] for (a, b), _ in without_each(note)}
