"""Sessions: durable turns, undo and redo byte for byte, and the life of a session as a whole."""

import asyncio
import sqlite3
import subprocess
import sys

import pytest
from langgraph.config import get_stream_writer
from langgraph.graph import START, StateGraph
from session_fake import FakeEngine

from c2s_engine.session import store as session_store
from c2s_engine.session.sessions import SessionError, Sessions
from c2s_engine.session.state import edit_words
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.edits import AddObject, RemoveObject, Replace, SetCode, SetDescription, SetField, SetProgram
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished, ProgramChanged, Say
from c2s_engine.structure.specs import ObjectSpec, Placement


async def take(events):
    return [event async for event in events]


def whole(session):
    return session.structure.model_dump_json(), session.program.model_dump_json()


@pytest.fixture
def sessions(tmp_path):
    made = Sessions(tmp_path / "sessions")
    yield made
    made.close()


async def test_a_turn_is_durable_when_its_end_is_told(sessions, tmp_path):
    session = sessions.open("one", FakeEngine())
    assert session.structure.objects == () and session.history == []
    async for event in session.say("cyclist"):
        if isinstance(event, Finished):
            other = Sessions(tmp_path / "sessions")
            assert other.list()[0].last == "cyclist"
            other.close()
            break
    session.close()
    again = Sessions(tmp_path / "sessions").open("one", FakeEngine())
    assert whole(again) == whole(session)
    (turn,) = again.history
    assert (turn.index, turn.kind, turn.text, turn.summary) == (0, "say", "cyclist", "added O1; changed G, R, E, T")
    assert turn.replies == ("heard cyclist",) and again.pending is None


async def test_undo_and_redo_restore_byte_for_byte(sessions):
    session = sessions.open("one", FakeEngine())
    states = [whole(session)]
    for text in ("car", "truck", "bus"):
        await take(session.say(text))
        states.append(whole(session))
    for k in range(2, -1, -1):
        assert session.can_undo
        events = await take(session.undo())
        assert whole(session) == states[k] and isinstance(events[-1], Finished)
    assert not session.can_undo and session.history == []
    with pytest.raises(SessionError, match="nothing to undo"):
        await take(session.undo())
    for k in range(1, 4):
        events = await take(session.redo())
        assert whole(session) == states[k]
    rewritten = next(e for e in events if isinstance(e, ProgramChanged)).rewritten
    assert rewritten == ("O3",) and not session.can_redo
    with pytest.raises(SessionError, match="nothing to redo"):
        await take(session.redo())


def texts(turns):
    return [t.text for t in turns]


async def test_undo_and_redo_pass_over_questions(sessions):
    session = sessions.open("one", FakeEngine())
    states = [whole(session)]
    for text in ("car", "who?", "truck", "what?", "why?"):
        await take(session.say(text))
        states.append(whole(session))
    assert [t.asked for t in session.history] == [False, True, False, True, True]
    for left in (["car", "who?"], []):
        await take(session.undo())
        assert texts(session.history) == left and whole(session) == states[len(left)]
    assert not session.can_undo
    for back in (["car", "who?"], ["car", "who?", "truck", "what?", "why?"]):
        await take(session.redo())
        assert texts(session.history) == back and whole(session) == states[len(back)]
    assert not session.can_redo


async def test_a_question_leaves_what_can_be_redone(sessions):
    session = sessions.open("one", FakeEngine())
    for text in ("car", "truck", "bus"):
        await take(session.say(text))
    states = [whole(session)]
    for _ in range(2):
        await take(session.undo())
        states.append(whole(session))
        await take(session.say("what?"))
        assert whole(session) == states[-1] and session.can_redo
    session.close()
    session = sessions.open("one", FakeEngine())
    assert texts([*session.history, *session.undone]) == ["car", "what?", "truck", "what?", "bus"]
    for state in states[-2::-1]:
        await take(session.redo())
        assert whole(session) == state
    assert texts(session.history) == ["car", "what?", "truck", "what?", "bus"] and not session.can_redo
    await take(session.back_to(0))
    await take(session.say("van"))
    assert texts(session.history) == ["car", "van"] and not session.can_redo


async def test_only_a_question_was_undone_by_an_earlier_version(sessions):
    session = sessions.open("one", FakeEngine())
    for text in ("car", "what?"):
        await take(session.say(text))
    path = session._path()
    session._store.move(session._thread, path[-2].checkpoint, [path[-1].checkpoint])
    session.close()
    session = sessions.open("one", FakeEngine())
    assert session.can_undo and not session.can_redo
    with pytest.raises(SessionError, match="nothing to redo"):
        await take(session.redo())


async def test_one_goes_to_any_turn_back_and_forward(sessions):
    session = sessions.open("one", FakeEngine())
    states = [whole(session)]
    for text in ("car", "truck", "bus", "van"):
        await take(session.say(text))
        states.append(whole(session))
    for index in (0, 2, -1, 3, 1, 1):
        events = await take(session.back_to(index))
        assert whole(session) == states[index + 1] and isinstance(events[-1], Finished)
        turns = [*session.history, *session.undone]
        assert [t.text for t in turns] == ["car", "truck", "bus", "van"] and [t.index for t in turns] == [0, 1, 2, 3]
        assert len(session.history) == index + 1
    for nowhere in (4, -2):
        with pytest.raises(SessionError, match="there are 4"):
            await take(session.back_to(nowhere))
    await take(session.redo())
    assert whole(session) == states[3]


async def test_undo_and_redo_outlive_the_process(sessions):
    session = sessions.open("one", FakeEngine())
    for text in ("car", "truck", "bus"):
        await take(session.say(text))
    await take(session.undo())
    await take(session.undo())
    session.close()
    session = sessions.open("one", FakeEngine())
    assert [t.text for t in session.history] == ["car"]
    await take(session.redo())
    assert [t.text for t in session.history] == ["car", "truck"] and session.can_redo


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (SetField(component="E", path="speed", value=10.0), "E: speed 36 km/h"),
        (SetField(component="O1", path="phases.0.trigger.value", value=[5, 8]), "O1: phase 1 trigger value 5 to 8"),
        (SetField(component="O1", path="type", value="fire_truck"), "O1: type fire truck"),
        (SetField(component="G", path="weather", value=["rain", "fog"]), "G: weather rain, fog"),
        (SetField(component="E", path="speed"), "E: speed left open"),
        (SetDescription(component="O1", description="A van."), "O1: “A van.”"),
        (SetCode(component="O1", code="x = 1"), "O1: code by hand"),
        (SetCode(component="O1", code=None), "O1: written from its fields again"),
        (AddObject(spec=ObjectSpec(type="van", placement=Placement(position="ahead"))), "add van"),
        (RemoveObject(component="O1"), "remove O1"),
        (Replace(structure=Structure()), "program opened"),
        (SetProgram(text=""), "code edited by hand"),
    ],
)
def test_the_history_names_edits_in_plain_words(edit, words):
    assert edit_words(edit) == words


async def test_a_turn_after_undo_begins_a_new_branch(sessions):
    session = sessions.open("one", FakeEngine())
    for text in ("car", "truck"):
        await take(session.say(text))
    await take(session.undo())
    await take(session.apply(SetField(component="O1", path="count", value=2)))
    assert [t.text for t in session.history] == ["car", "O1: count 2"] and not session.can_redo
    assert session.history[-1].summary == "changed O1"
    await take(session.apply([RemoveObject(component="O1")]))
    assert session.structure.objects == () and session.history[-1].summary == "removed O1"


async def test_regenerate_writes_what_is_asked_anew(sessions):
    session = sessions.open("one", FakeEngine())
    await take(session.say("car"))
    before = whole(session)
    await take(session.regenerate(["O1"]))
    assert whole(session) == before and session.history[-1].text == "write O1 anew"


async def test_a_cancelled_turn_leaves_everything_as_it_was(sessions):
    engine = FakeEngine()
    session = sessions.open("one", engine)
    await take(session.say("car"))
    before = whole(session)
    task = asyncio.create_task(take(session.say("wait")))
    await engine.waiting.wait()
    with pytest.raises(SessionError, match="still running"):
        await take(session.say("truck"))
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    assert engine.stopped == 1 and whole(session) == before and session.pending is None
    await take(session.say("truck"))
    assert [t.text for t in session.history] == ["car", "truck"]
    await take(session.undo())
    assert whole(session) == before


async def test_closing_the_iterator_cancels_too(sessions):
    engine = FakeEngine()
    session = sessions.open("one", engine)
    events = session.say("wait")
    assert isinstance(await anext(events), Say)
    await events.aclose()
    assert session.structure.objects == () and session.pending is None
    await take(session.say("truck"))
    assert len(session.structure.objects) == 1


async def test_a_fault_of_the_engine_ends_the_turn_only(sessions):
    session = sessions.open("one", FakeEngine())
    with pytest.raises(RuntimeError, match="out of order"):
        await take(session.say("fail"))
    await take(session.say("car"))
    assert [t.text for t in session.history] == ["car"]


async def test_a_text_that_led_to_no_turn_stays_in_its_session(sessions, tmp_path, monkeypatch):
    engine = FakeEngine()
    session = sessions.open("one", engine)
    with pytest.raises(RuntimeError, match="out of order"):
        await take(session.say("fail at “Unit 2”"))
    await take(session.say("car"))
    task = asyncio.create_task(take(session.say("wait")))
    await engine.waiting.wait()
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    await take(session.say("truck"))
    await take(session.undo())

    def texts(session):
        return [t.text for t in session.conversation], session.typed

    expected = ["fail at “Unit 2”", "car", "wait"], ["fail at “Unit 2”", "car", "wait", "truck"]
    assert texts(session) == expected and [t.text for t in session.history] == ["car"]
    assert session.conversation[0].replies == ("heard fail at “Unit 2”", "out of order")
    session.close()
    again = Sessions(tmp_path / "sessions").open("one", FakeEngine())
    assert texts(again) == expected and again.pending is None
    monkeypatch.setattr("c2s_engine.session.journal.COMPACT_AT", 1000)
    for number in range(8):
        await take(again.say(f"car {number}"))
    again.close()
    again = Sessions(tmp_path / "sessions").open("one", FakeEngine())
    assert "fail at “Unit 2”" in again.typed


async def test_one_process_at_a_time(sessions):
    session = sessions.open("one", FakeEngine())
    with pytest.raises(SessionError, match="open in another process"):
        sessions.open("one", FakeEngine())
    session.close()
    with pytest.raises(SessionError, match="is closed"):
        await take(session.say("car"))
    sessions.open("one", FakeEngine()).close()


async def test_list_rename_duplicate_delete(sessions):
    session = sessions.open("one", FakeEngine())
    await take(session.say("car"))
    await take(session.say("truck"))
    session.save_draft("chat", "and then")
    session.close()
    sessions.duplicate("one", "two")
    sessions.rename("one", "uno")
    two = sessions.open("two", FakeEngine())
    assert whole(two) == whole(session) and two.draft("chat") == ""
    await take(two.undo())
    await take(two.say("bus"))
    two.close()
    assert {(s.name, s.turns, s.last) for s in sessions.list()} == {("uno", 2, "truck"), ("two", 2, "bus")}
    with pytest.raises(SessionError, match="already a session 'two'"):
        sessions.rename("uno", "two")
    sessions.delete("uno")
    assert [s.name for s in sessions.list()] == ["two"]
    two = sessions.open("two", FakeEngine())
    assert [o.description for o in two.structure.objects] == ["car", "bus"]
    for call in (lambda: sessions.delete("uno"), lambda: sessions.open("uno", FakeEngine(), create=False)):
        with pytest.raises(SessionError, match="no session 'uno'"):
            call()
    with pytest.raises(SessionError, match="one line of 1 to 80"):
        sessions.open("a\nb", FakeEngine())


async def test_export_and_import_as_one_file(sessions, tmp_path):
    session = sessions.open("one", FakeEngine())
    states = [whole(session)]
    for text in ("car", "what is ahead?", "truck"):
        await take(session.say(text))
        states.append(whole(session))
    session.close()
    sessions.export("one", tmp_path / "one.c2s")
    elsewhere = Sessions(tmp_path / "elsewhere")
    assert elsewhere.import_file(tmp_path / "one.c2s") == "one"
    assert elsewhere.import_file(tmp_path / "one.c2s") == "one 2"
    copy = elsewhere.open("one 2", FakeEngine())
    assert copy.history == session.history and whole(copy) == states[-1]
    for k in (2, 0):  # over the question
        await take(copy.undo())
        assert whole(copy) == states[k]
    (tmp_path / "other.json").write_text('{"format": "something"}')
    with pytest.raises(SessionError, match="not an exported session"):
        elsewhere.import_file(tmp_path / "other.json")


async def test_the_database_is_bounded(sessions, tmp_path, monkeypatch):
    monkeypatch.setattr(session_store.Store.prune, "__defaults__", (5,))
    session = sessions.open("one", FakeEngine())
    for k in range(12):
        await take(session.apply(SetField(component="E", path="speed", value=1.0 + k)))
    counts = {}
    with sqlite3.connect(tmp_path / "sessions" / "sessions.sqlite") as db:
        for table in ("turns", "checkpoints", "writes"):
            counts[table] = db.execute(f"SELECT count(DISTINCT checkpoint_id) FROM {table}").fetchone()[0]
    assert counts["turns"] == counts["checkpoints"] == 6 and counts["writes"] <= 6
    for _ in range(5):
        await take(session.undo())
    assert not session.can_undo


async def test_one_checkpoint_a_turn(sessions, tmp_path):
    session = sessions.open("one", FakeEngine())
    for text in ("car", "truck", "bus"):
        await take(session.say(text))
    with sqlite3.connect(tmp_path / "sessions" / "sessions.sqlite") as db:
        assert db.execute("SELECT count(*) FROM checkpoints").fetchone()[0] == 4


async def test_a_turn_that_cannot_be_written_is_one_sentence_and_changes_nothing(sessions):
    session = sessions.open("one", FakeEngine())
    await take(session.say("car"))
    before = whole(session)
    sessions._store.connection.execute("PRAGMA query_only = ON")
    with pytest.raises(SessionError, match="cannot be written"):
        await take(session.say("truck"))
    assert whole(session) == before
    sessions._store.connection.execute("PRAGMA query_only = OFF")
    await take(session.say("bus"))
    assert [t.text for t in session.history] == ["car", "bus"]


class GraphEngine(FakeEngine):
    """An engine that works through a graph of its own."""

    def __init__(self):
        super().__init__()
        graph = StateGraph(dict)
        graph.add_node("first", lambda state: get_stream_writer()(Say(text="from within")))
        graph.add_edge(START, "first")
        self.graph = graph.compile()

    async def say(self, structure, text, **options):
        async for event in self.graph.astream({}, stream_mode="custom"):
            yield event
        async for event in super().say(structure, text, **options):
            yield event


async def test_a_graph_within_the_engine_leaves_no_checkpoints(sessions, tmp_path):
    session = sessions.open("one", GraphEngine())
    events = await take(session.say("car"))
    assert [e.text for e in events if isinstance(e, Say)] == ["from within", "heard car"]
    with sqlite3.connect(tmp_path / "sessions" / "sessions.sqlite") as db:
        assert db.execute("SELECT checkpoint_ns, count(*) FROM checkpoints GROUP BY 1").fetchall() == [("", 2)]


def test_a_file_that_is_no_database_is_one_sentence(tmp_path):
    (tmp_path / "sessions.sqlite").write_bytes(b"nonsense" * 1000)
    with pytest.raises(SessionError, match="cannot be read"):
        Sessions(tmp_path)


async def test_opening_reads_the_copy_beside_the_database_and_does_without_a_broken_one(sessions, tmp_path):
    session = sessions.open("one", FakeEngine())
    await take(session.say("car"))
    await take(session.say("truck"))
    await take(session.undo())
    state = whole(session)
    session.close()
    code = "import sys; from pathlib import Path; from c2s_engine.session.sessions import Sessions; " \
           "s = Sessions(Path(sys.argv[1])).open('one', None); " \
           "print(len(s.structure.objects), 'langgraph' in sys.modules)"  # fmt: skip
    done = subprocess.run([sys.executable, "-c", code, sessions.folder], capture_output=True, text=True)
    assert done.stdout.split() == ["1", "False"], done.stderr
    (copy,) = sessions.folder.rglob("head.json")
    for text in ('{"checkpoint": "other", "state": {}}', '{"checkpoint": "', "[]"):
        copy.write_text(text)
        again = sessions.open("one", FakeEngine())
        assert whole(again) == state
        again.close()


async def test_a_session_in_which_nothing_happened_is_exported_too(sessions, tmp_path):
    sessions.open("one", FakeEngine()).close()
    sessions.export("one", tmp_path / "one.c2s")
    assert sessions.import_file(tmp_path / "one.c2s", "two") == "two"
    assert sessions.open("two", FakeEngine()).history == []


async def test_the_answer_to_a_text_that_was_refused_is_there_again(tmp_path):
    found = Diagnostic(stage="interpret", code="text", message="A speed is at most 360 km/h.")

    class Refusing(FakeEngine):
        async def say(self, structure, text, **options):
            stages = (StageResult(name="interpret", ok=False, diagnostics=(found,)),)
            yield Finished(ok=False, structure=structure, program=assemble(structure), stages=stages)

    session = Sessions(tmp_path).open("one", Refusing())
    async for _ in session.say("Ego drives at 900 km/h."):
        pass
    session.close()
    again = Sessions(tmp_path).open("one", Refusing())
    assert [t.replies for t in again.conversation] == [("A speed is at most 360 km/h.",)]
    again.close()
