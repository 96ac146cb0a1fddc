"""Code by hand outlives turns of the methods that write a program as one (nl2scenic, chatscene)."""

import json

import pytest

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import RemoveObject, SetCode, SetDescription
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Passage, Say
from c2s_engine.write.baselines.own import with_own
from tests.models.answers import asked_of
from tests.models.fake_ollama import FakeOllama, said
from tests.write_prompted.programmer import EXAMPLE, TEXT

pytestmark = pytest.mark.full  # an engine of its own for each

CHANGE = "Make the pedestrian slower."


class Author:
    """Answers a turn as a change of `component`, its form with next to nothing, and a program with `text`."""

    def __init__(self, text: str, change: dict | None = None) -> None:
        self.text = text
        self.change = change or {"do": "change", "component": "O2", "sentence": "A pedestrian walks slowly."}

    def __call__(self, request) -> str:
        if "kind" in (request.get("format") or {}).get("properties", {}) and "\nTurn: " in said(request):
            return json.dumps({"kind": "edit", "changes": [self.change]})
        if asked_of(request):
            return json.dumps(
                {"name": "walker", "type": "pedestrian", "placement": {"position": "sidewalk", "side": "right"}}
            )
        return f"```scenic\n{self.text}\n```"


async def take(events):
    return [event async for event in events]


def warnings(events):
    return [e.text for e in events if isinstance(e, Say) and e.severity == "warning"]


@pytest.fixture
def server():
    with FakeOllama(Author(EXAMPLE.text)) as running:
        yield running


@pytest.fixture
async def session(tmp_path, server):
    table = {"host": server.host, "backoff": 0.001, "probe": False, "num_ctx": 16384}
    async with Engine(Settings(model="small", method="nl2scenic:zero", ollama=table)) as engine:
        sessions = Sessions(tmp_path / "sessions")
        opened = sessions.open("one", engine)
        await take(opened.say(TEXT, run=False))
        assert opened.structure.ids == ("G", "R", "E", "O1", "O2", "T")
        yield opened
        opened.close()
        sessions.close()


async def by_hand(session, cid):
    mine = session.structure[cid].code + "# mine\n"
    done = (await take(session.apply(SetCode(component=cid, code=mine), run=False)))[-1]
    assert done.ok and session.structure[cid].conflict is None
    return mine


async def test_a_turn_keeps_it_and_offers_what_the_model_wrote_there(server, session):
    mine = await by_hand(session, "O1")
    server.respond = Author(EXAMPLE.text.replace("param timestep = 0.1", "param timestep = 0.05"))
    events = await take(session.say(CHANGE, run=False))
    assert events[-1].ok and session.structure.text == f"{TEXT}\n{CHANGE}"
    assert session.structure["O1"].code == mine and session.structure["O1"].origin == "by_hand"
    assert session.structure["O1"].conflict is None or "# mine" not in session.structure["O1"].conflict
    assert "timestep = 0.05" in session.program.text and "# mine" in session.program.text
    part = EXAMPLE.fragments[3].code
    server.respond = Author(EXAMPLE.text.replace(part, f"{part}\n# the model's"))
    events = await take(session.say(CHANGE, run=False))
    assert session.structure["O1"].code == mine and "# the model's" in session.structure["O1"].conflict
    assert any(w.startswith("O1: your code is kept") for w in warnings(events))
    asked = len(server.requests)
    await take(session.apply(SetCode(component="O1", code=None), run=False))
    assert "# the model's" in session.structure["O1"].code and session.structure["O1"].conflict is None
    await take(session.apply([], run=False))
    assert len(server.requests) == asked, "the offer itself is taken, nothing is written anew"


async def test_what_is_given_back_without_an_offer_is_written(server, session):
    await by_hand(session, "O1")
    asked = len(server.requests)
    await take(session.apply(SetCode(component="O1", code=None), run=False))
    assert len(server.requests) == asked + 1 and session.structure["O1"].origin == "generated"
    assert "# mine" not in session.program.text and session.structure["O1"].code


async def test_an_object_that_the_model_leaves_out_stays_where_it_still_runs(server, session):
    head, _, rest = EXAMPLE.text.partition("## O1")
    first, _, second = rest.partition("## O2")
    tail = second[second.index("## T") :]
    server.respond = Author(f"{head}## O1{first}{tail}")
    mine = await by_hand(session, "O2")
    events = await take(session.say(CHANGE, run=False))
    assert events[-1].ok and session.structure.ids == ("G", "R", "E", "O1", "O2", "T")
    assert session.structure["O2"].code == mine


async def test_where_it_has_no_place_the_turn_changes_nothing(server, session):
    await by_hand(session, "O1")
    before = session.structure.model_dump_json(), session.program.text
    for text in ("model scenic.simulators.carla.model\nego = new Car\n", EXAMPLE.text.split("## R")[0]):
        server.respond = Author(text)
        events = await take(session.say(CHANGE, run=False))
        assert not events[-1].ok and (session.structure.model_dump_json(), session.program.text) == before
        assert "(O1) has no place in it" in events[-1].diagnostics[0].message
        assert "S and its program stay as they were." in warnings(events)


async def test_what_the_turn_removes_goes_though_it_is_by_hand(server, session):
    await by_hand(session, "O2")
    head, _, rest = EXAMPLE.text.partition("## O2")
    server.respond = Author(head + rest[rest.index("## T") :], {"do": "remove", "component": "O2"})
    events = await take(session.say("Remove the pedestrian.", run=False))
    assert all(s.ok for s in events[-1].stages if s.name == "write")
    assert "O2" not in session.structure and "# mine" not in session.program.text


async def test_objects_that_were_counted_anew_are_known_by_their_names():
    def structure(*objects, origin="generated"):
        made = Structure(text="x").model_dump()
        rows = [
            {"id": i, "code": f"## {i}: It.\n{name} = new Car\n", "origin": origin, "spec": {"component": "O"}}
            for i, name in objects
        ]
        for part in ("settings", "ego"):
            made[part]["code"] = "model scenic.simulators.carla.model\n" if part == "settings" else "ego = new Car\n"
            made[part]["origin"] = "generated"
        return Structure.model_validate({**made, "objects": rows})

    before = structure(("O2", "van"), origin="by_hand")
    found = await with_own(before, structure(("O1", "van"), ("O2", "bus")), None)
    assert found["O1"].origin == "by_hand" and found["O1"].code.startswith("## O1: It.\nvan =")
    assert found["O2"].origin == "generated" and "bus =" in found["O2"].code


async def test_a_whole_program_by_hand_stays_and_the_new_one_is_offered():
    whole = Structure(text="x")
    mine = whole.ego.model_copy(
        update={"code": "model scenic.simulators.carla.model\nego = new Car\n", "origin": "by_hand"}
    )
    parts = {f.id: f for f in EXAMPLE.fragments}
    written = Structure(text="x")
    for cid in ("G", "R", "E"):
        written = written.with_component(written[cid].model_copy(update={"code": f"{parts[cid].code}\n"}))
    found = await with_own(whole.with_component(mine), written, None)
    assert assemble(found).text == assemble(whole.with_component(mine)).text
    assert parts["G"].code in found.ego.conflict and parts["E"].code in found.ego.conflict


async def test_chatscene_keeps_it_and_offers_the_snippet_of_a_new_description(tmp_path):
    async with Engine(Settings(method="chatscene")) as engine:

        class Shelf:
            async def ready(self, on_progress):
                pass

            async def search(self, query, *, kind, component=None, limit=3):
                code = {"R": "lane = network.lanes[0]\n", "E": "ego = new Car on lane\n"}.get(component)
                code = code or f"other = new Car on lane  # {query}\n"
                return [Passage(kind="snippet", title="A snippet", text=code, score=0.9, component=component)]

        async def retrieval():
            return Shelf()

        engine.tools.extra["retrieval"] = retrieval
        sessions = Sessions(tmp_path / "sessions")
        session = sessions.open("one", engine)
        await take(session.say("Ego drives at 40 km/h on a straight road. A car drives 25 m ahead of it.", run=False))
        mine = session.structure["O1"].code + "# mine\n"
        await take(session.apply(SetCode(component="O1", code=mine), run=False))
        assert session.structure["O1"].code == mine and session.structure["O1"].conflict is None
        await take(session.say("make the car a truck", run=False))
        mine = mine.replace("new Car", "new Truck")
        assert session.structure["O1"].code == mine, "the code follows the field"
        asked = SetDescription(component="O1", description="A truck cuts in ahead of ego.")
        events = await take(session.apply(asked, run=False))
        assert session.structure["O1"].code == mine and "cuts in" in session.structure["O1"].conflict
        assert any(w.startswith("O1: your code is kept") for w in warnings(events))
        await take(session.apply(RemoveObject(component="O1"), run=False))
        assert "O1" not in session.structure
        session.close()
        sessions.close()
