"""A turn whose writing fails: S with its program stays as it was, or what is not written is marked, kept and said."""

import asyncio
import errno
import threading

import pytest

from c2s_engine.api import Engine
from c2s_engine.check.client import CheckError
from c2s_engine.config import Settings
from c2s_engine.session.sessions import SessionError, Sessions
from c2s_engine.structure.edits import SetCode, SetDescription, SetField
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import ComponentState, Say
from tests.models.fake_ollama import Answer, FakeOllama, endless
from tests.write_prompted.programmer import EXAMPLE, TEXT, Programmer, asked_for

pytestmark = pytest.mark.full  # an engine of its own for each

VAN = SetDescription(component="O1", description="A white van is parked at the right edge of the road, 30 m ahead.")
METHOD = "chat2scenic:C1"


@pytest.fixture
def server():
    with FakeOllama(Programmer()) as running:
        yield running


@pytest.fixture
async def engine(server):
    table = {"host": server.host, "backoff": 0.001, "probe": False, "num_ctx": 16384}
    async with Engine(Settings(model="small", method=METHOD, ollama=table)) as running:
        yield running


@pytest.fixture
async def session(tmp_path, engine):
    sessions = Sessions(tmp_path / "sessions")
    opened = sessions.open("one", engine)
    await take(opened.say(TEXT, run=False))
    assert opened.program.text
    yield opened
    opened.close()
    sessions.close()


async def take(events):
    return [event async for event in events]


def whole(session):
    return session.structure.model_dump_json(), session.program.model_dump_json()


def warnings(events):
    return [e.text for e in events if isinstance(e, Say) and e.severity == "warning"]


def marked(events):
    return [e.component.id for e in events if isinstance(e, ComponentState) and e.state == "dirty"]


async def test_a_model_that_dies_leaves_the_program_and_marks_what_is_to_be_written(server, session):
    before = session.program.text
    server.respond = lambda request: Answer(status=400, error="gone")
    events = await take(session.apply(VAN, run=False))
    assert session.program.text == before == assemble(session.structure).text
    assert not events[-1].ok and marked(events) == ["O1"]
    assert session.structure["O1"].description == VAN.description and session.structure["O1"].key == ""
    assert warnings(events) == [
        "S was changed, but its program not updated yet (O1). The next turn tries again; undo reverts it."
    ]
    server.respond, first = Programmer(), len(server.requests)
    await take(session.apply(SetDescription(component="T", description="The run ends after 9 s."), run=False))
    assert [asked_for(r) for r in server.requests[first:]] == ["O1", "T"]
    assert all(c.key for c in session.structure.components) and "## O1: A white van" in session.program.text


async def test_an_answer_without_code_keeps_the_fragment_and_marks_it(server, session):
    before = session.structure["O1"].code
    server.respond = lambda request: "I cannot write that."
    events = await take(session.apply(VAN, run=False))
    assert session.structure["O1"].code == before and session.structure["O1"].key == ""
    assert any("O1 keeps its code of before, and stays to be written." in w for w in warnings(events))
    server.respond = Programmer()
    await take(session.apply([], run=False))
    assert session.structure["O1"].key and "A white van" in session.structure["O1"].code


async def test_a_turn_cancelled_while_it_is_written_changes_nothing(server, session):
    before = whole(session)
    server.respond = lambda request: Answer(endless("x = 1\n"), hold=threading.Event())
    task = asyncio.create_task(take(session.apply(VAN, run=False)))
    assert await asyncio.to_thread(server.streaming.wait, 10)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    assert whole(session) == before and session.pending is None


async def test_a_full_disk_is_one_sentence_and_changes_nothing(engine, session, monkeypatch):
    before = whole(session)

    def full(map_file):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(engine.library, "working_copy", full)
    with pytest.raises(SessionError, match=r"No space left on device.*S is unchanged"):
        await take(session.apply(SetField(component="G", path="weather", value=["rain"]), method="reader", run=False))
    assert whole(session) == before and session.pending is None


async def test_a_scenario_that_cannot_be_read_leaves_the_one_at_hand(server, session):
    before = whole(session)
    server.respond = lambda request: Answer(status=400, error="gone")
    other = "A cyclist crosses at an intersection in front of ego, which turns right at 20 km/h. It is night."
    events = await take(session.say(other, run=False))
    assert not events[-1].ok and whole(session) == before
    assert "S and its program stay as they were." in warnings(events)


async def test_a_dead_check_server_in_a_repair_is_a_finding(server, engine, session, monkeypatch):
    async def dead(request):
        raise CheckError("the check server does not answer")

    before = session.program.text
    monkeypatch.setattr(engine.check_client, "check", dead)
    events = await take(session.apply(VAN, method=f"{METHOD}+repair", run=False))
    assert [d.code for d in events[-1].diagnostics] == ["check-server"] and session.program.text == before
    assert any("its program not updated yet" in w for w in warnings(events))


async def test_maps_that_cannot_be_searched_are_not_said_to_lack_the_place(engine, session, monkeypatch):
    async def broken(request):
        raise CheckError("The driving library is broken: c2s_driving.scenic, line 7: invalid syntax.")

    monkeypatch.setattr(engine.check_client, "places", broken)
    events = await take(session.apply(VAN, method="reader", run=False))
    (found,) = events[-1].diagnostics
    assert found.code == "lookup" and "c2s_driving.scenic, line 7" in found.message
    assert "no map" not in found.message


async def test_fields_that_contradict_are_kept_marked_and_said(session):
    await take(session.say("A car drives 20 m ahead of ego in its lane at 40 km/h.", method="reader", run=False))
    before = session.program.text
    edits = [SetField(component="R", path="ego_lane", value="rightmost"),
             SetField(component="O1", path="placement.position", value="right_lane")]  # fmt: skip
    events = await take(session.apply(edits, method="reader", run=False))
    assert not events[-1].ok and session.program.text == before
    assert set(marked(events)) == {"R", "O1"} and "its program not updated yet (R, O1)" in warnings(events)[-1]
    events = await take(session.apply(edits[1].model_copy(update={"value": "ahead"}), method="reader", run=False))
    assert events[-1].ok and all(c.key for c in session.structure.components)


@pytest.mark.parametrize("method", ["reader", METHOD])
async def test_code_by_hand_is_kept_and_a_conflict_is_said(server, session, method):
    if method == "reader":
        told = "New scenario: a car drives 20 m ahead of ego in its lane at 40 km/h."
        await take(session.say(told, method=method, run=False))
    mine = session.structure["O1"].code.replace("new Car", "new Van") + "# mine\n"  # what another type writes anew, too
    await take(session.apply(SetCode(component="O1", code=mine), method=method, run=False))
    assert session.structure["O1"].conflict is None and "# mine" in session.program.text
    if method != "reader":
        part = EXAMPLE.fragments[3]
        other = part.model_copy(update={"code": part.code.replace("Van right", "Truck right")})
        server.respond = Programmer()
        server.respond.parts["O1"] = other
    edit = SetField(component="O1", path="type", value="truck")
    events = await take(session.apply(edit, method=method, run=False))
    assert "Truck" in session.structure["O1"].conflict and "# mine" in session.program.text
    assert any(w.startswith("O1: your code is kept") for w in warnings(events))
    events = await take(session.apply([], method=method, run=False))
    assert not any("by hand" in w for w in warnings(events)), "said once"
    offered = session.structure["O1"].conflict
    await take(session.apply(SetCode(component="O1", code=None), method=method, run=False))
    assert session.structure["O1"].code == offered and session.structure["O1"].conflict is None
    assert all(c.key and c.key != "taken" for c in session.structure.components)
