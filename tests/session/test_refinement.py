"""A conversation upon S without a model: the reply says what changed and what was written anew, and what did not."""

import pytest

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.session.sessions import SessionError, Sessions
from c2s_engine.structure.progress import Passage, Say

TEXT = (
    "In the rain ego drives at 50 km/h on a straight road with two lanes. A car drives 25 m ahead of it. "
    "When ego is 30 m away, a pedestrian crosses the road from the right."
)


async def take(events):
    found = [event async for event in events]
    return found[-1], [e.text for e in found if isinstance(e, Say)]


@pytest.fixture
async def session(tmp_path):
    sessions = Sessions(tmp_path / "sessions")
    async with Engine(Settings(offers=False)) as engine:

        async def search(query, **options):
            return [Passage(kind="doc", title="Cut-in", text="A vehicle enters ego's lane ahead of it.", score=0.9)]

        engine.search = search
        opened = sessions.open("one", engine)
        done, _ = await take(opened.say(TEXT, run=False))
        assert done.ok and [o.spec.type for o in done.structure.objects] == ["car", "pedestrian"]
        yield opened
        opened.close()
    sessions.close()


async def test_a_conversation(session):
    first = session.structure.model_dump_json()

    done, told = await take(session.say("make the lead a truck", run=False))
    assert done.ok and session.structure["O1"].spec.type == "truck"
    assert any("O1" in t and "truck" in t for t in told), "what changed"
    written, stayed = next(t for t in told if t.startswith("Rewritten: ")).split(";")
    assert "O1" in written and all(c in stayed for c in ("G", "R", "O2", "T")), "what was written, and what was not"

    done, told = await take(session.say("undo that"))
    assert told == ["Undone: make the lead a truck"] and session.structure.model_dump_json() == first
    assert [t.text for t in session.history] == [TEXT] and session.can_redo
    await take(session.say("redo that"))
    assert session.structure["O1"].spec.type == "truck" and len(session.history) == 2

    before = session.structure.model_dump_json(), session.program.text
    for question in ("what is a cut-in?", "why is the pedestrian there?"):
        done, told = await take(session.say(question))
        assert told and done.details["unchanged"]
        assert (session.structure.model_dump_json(), session.program.text) == before
    _, told = await take(session.say("undo that"))
    assert told == ["Undone: make the lead a truck"] and session.structure.model_dump_json() == first
    await take(session.say("what is a cut-in?"))
    await take(session.say("redo that"))
    assert (session.structure.model_dump_json(), session.program.text) == before

    done, told = await take(session.say("what if it were a motorway?", run=False))
    assert session.structure.place.spec.kind == "motorway"
    assert any("motorway" in t for t in told)
    turns = len(session.history)
    for nonsense in ("make it more purple", "blah blah", "Der Wagen soll ein Bus sein"):
        done, told = await take(session.say(nonsense, run=False))
        assert any("did not understand" in t or "English" in t for t in told)
    assert len(session.history) == turns, "what came to nothing is no turn"


async def test_a_text_that_replaces_what_is_there_says_so(engine, tmp_path):
    sessions = Sessions(tmp_path / "sessions")
    session = sessions.open("one", engine)
    _, told = await take(session.say(TEXT, run=False))
    assert not any("new description" in t for t in told)
    _, told = await take(session.say("Two trucks stand behind a bend to the left. Ego comes at 40 km/h.", run=False))
    replaced = "Taken as a new description: it replaces O1 (car) and O2 (pedestrian); undo brings them back."
    assert replaced in told
    session.close()
    sessions.close()



async def test_undo_with_nothing_to_take_back_is_one_sentence(engine, tmp_path):
    sessions = Sessions(tmp_path / "sessions")
    session = sessions.open("one", engine)
    with pytest.raises(SessionError, match="nothing to undo"):
        await take(session.say("undo that"))
    await take(session.say("blah blah"))
    assert session.history == []
    session.close()
    sessions.close()
