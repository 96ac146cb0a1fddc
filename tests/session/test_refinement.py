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
    async with Engine(Settings(method="embedded", offers=False)) as engine:

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


async def test_a_relative_change_counts_from_what_is_there(engine, tmp_path):
    """S says neither the gap nor ego's speed: the run's count."""
    sessions = Sessions(tmp_path / "sessions")
    session = sessions.open("one", engine)
    done, _ = await take(session.say("Ego drives on a road. A cyclist rides out from the right in front of ego."))
    cyclist = next(o for o in done.facts[0].objects if o.component == "O1")
    gap = round(cyclist.starts["ego"].gap, 1)
    assert session.structure["O1"].amount("placement.gap") is None and gap > 26
    _, told = await take(session.say("the cyclist should be 5 m closer", run=False))
    assert f"O1 (cyclist): gap {gap:.3g} m -> {gap - 5:.3g} m" in told
    assert session.structure["O1"].spec.placement.gap == pytest.approx(gap - 5)
    held = next(o for o in done.facts[0].objects if o.name == "ego").held_speed
    base = session.structure.ego.amount("speed") or held
    _, told = await take(session.say("ego 5 km/h faster", run=False))
    assert f"ego: speed {base * 3.6:.3g} km/h -> {base * 3.6 + 5:.3g} km/h" in told
    session.close()
    sessions.close()


@pytest.mark.parametrize(("said", "shift"), [("brake 2 s later", 2.0), ("brake 1 s earlier", -1.0)])
async def test_another_moment_counts_from_when_the_run_shows_it(engine, tmp_path, said, shift):
    sessions = Sessions(tmp_path / "sessions")
    session = sessions.open("one", engine)
    told = "Ego follows a truck at 60 km/h on a straight road. The truck brakes hard and stops."
    done, _ = await take(session.say(told))
    assert all(p.trigger is None for p in session.structure["O1"].spec.phases)
    truck = next(o for o in done.facts[0].objects if o.component == "O1")
    begun = min(e.time for e in truck.events if e.event.startswith("brake"))
    await take(session.say(f"the truck should {said}", run=False))
    moments = [p.trigger.value for p in session.structure["O1"].spec.phases if p.trigger]
    assert moments == [pytest.approx(begun + shift, abs=0.06)]
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
