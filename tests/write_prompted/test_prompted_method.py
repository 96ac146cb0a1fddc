"""The paper's way end to end: interpreter, header, components with the code so far, twelve configurations, repair."""

import asyncio
import threading

import pytest

from c2s_engine.models import errors
from c2s_engine.structure import edits
from c2s_engine.structure.components import Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import ComponentState, Passage, Token, Usage
from c2s_engine.structure.regenerate import dirty
from c2s_engine.write.prompted import PromptedMethod
from c2s_engine.write.prompted.configuration import configuration, names
from tests.models.backends import BAD, BAD_NAMES
from tests.models.fake_ollama import Answer, FakeOllama, endless, said
from tests.write_prompted.programmer import EXAMPLE, TEXT, Library, Programmer, asked_for

IDS = ["G", "R", "E", "O1", "O2", "T"]


def code(structure: Structure) -> dict[str, str]:
    return {c.id: c.code.split("\n", 1)[1].strip() for c in structure.components if c.code}


@pytest.mark.parametrize("name", names())
async def test_each_configuration_writes_a_program_that_samples(server, client_of, checker, name):
    server.respond = Programmer()
    library, config = Library(), configuration(name)
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod(name, client, library)
        structure = await method.generate(TEXT)
    assert code(structure) == {f.id: f.code for f in EXAMPLE.fragments}
    if name in ("C1", "C12"):  # the others write the same program
        program = assemble(structure)
        assert (await checker(program.text, program.spans)).ok
    assert [c.origin for c in structure.components] == ["generated"] * 6
    asked = [asked_for(r) for r in server.requests]
    assert asked == ["", "", *IDS], "interpreter, settings detector, header generator, R, E, O1..N, T"
    system = {asked_for(r): r["messages"][0]["content"] for r in server.requests}
    for cid in IDS:
        assert ("What to keep to:" in system[cid]) == config.has("CP")
        assert ("Steps:" in system[cid]) == config.has("CoT")
        assert ("Mistakes and their corrections:" in system[cid]) == config.has("ICL")
    kinds = {(kind, component) for _, kind, component, _ in library.asked}
    snippets, chunks = config.has("CodeICL"), config.has("DocICL")
    assert kinds == {("snippet", k) for k in "REOT" if snippets} | {("doc", None) for _ in "x" if chunks}
    assert {(kind, limit) for _, kind, _, limit in library.asked} <= {("snippet", 12), ("doc", 3)}, "those that fit"
    assert ("Code of similar components" in said(server.requests[5])) == snippets, "O1 may use ego"
    assert "Code of similar components" not in said(server.requests[4]), "which E may not: it is not there yet"
    assert ("From the documentation:" in said(server.requests[4])) == chunks


def test_the_matrix_is_the_papers():
    blocks = ["CP", "CoT", "ICL", "CodeICL", "DocICL"]
    rows = ["".join("x" if configuration(n).has(b) else "-" for b in blocks) for n in names()]
    assert rows == [
        "-----", "--x--", "---x-", "x----", "x-x--", "x--x-", "x-xx-", "xx---", "xxx--", "xx-x-", "xxxx-", "xxxxx",
    ]  # fmt: skip
    with pytest.raises(ValueError, match="C1, C2"):
        configuration("C13")


async def test_each_component_sees_the_code_so_far_and_the_others_sentences(server, client_of):
    server.respond = Programmer()
    async with client_of(server, num_ctx=16384) as client:
        await PromptedMethod("C1", client).generate(TEXT)
    parts = {f.id: f for f in EXAMPLE.fragments}
    for i, cid in enumerate(IDS[1:], 1):
        prompt = next(said(r) for r in server.requests if asked_for(r) == cid)
        for j, other in enumerate(IDS):
            assert (parts[other].code in prompt) == (j < i), (cid, other)
            assert (parts[other].sentence in prompt) == (other != "G"), (cid, other)


async def test_events_tell_what_happens(server, client_of):
    server.respond = Programmer()
    events = []
    async with client_of(server, num_ctx=16384) as client:
        client.ledger.begin("one")
        await PromptedMethod("C11", client, Library()).generate(TEXT, on_event=events.append)
        assert set(client.ledger.by("component")) == {"", *IDS}
        assert client.ledger.total("one").calls == 8
    states = [(e.component.id, e.state) for e in events if isinstance(e, ComponentState)]
    assert states == [(cid, s) for cid in IDS for s in ("writing", "clean")]
    assert {e.component for e in events if isinstance(e, Token)} == {None, *IDS}
    assert len([e for e in events if isinstance(e, Usage)]) == 8
    assert any(isinstance(e, Passage) for e in events)


SLIPS = {
    "parse": ("E", "ego = new Car at start facing north"),
    "name": ("E", "ego = new Car at start, with behavior DriveNicely()"),
    "sample": ("O1", "car = new Car at start, with name 'car'"),
}


@pytest.mark.parametrize("slip", ["name", *(pytest.param(s, marks=pytest.mark.full) for s in ("parse", "sample"))])
async def test_a_fragment_that_fails_goes_back_with_its_finding(server, client_of, checker, slip):
    cid, wrong = SLIPS[slip]
    server.respond = Programmer(slips={cid: wrong})
    library = Library()
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C11", client, library, checker)
        structure = await method.generate(TEXT)
    asked = [asked_for(r) for r in server.requests]
    assert asked.count(f"repair {cid}") == 1 and not any(a.startswith("repair") and a[7:] != cid for a in asked)
    assert code(structure) == {f.id: f.code for f in EXAMPLE.fragments}
    prompt = said(next(r for r in server.requests if asked_for(r) == f"repair {cid}"))
    assert f"  1 {wrong.splitlines()[0]}" in prompt and "A specifier sets a property" in prompt
    assert "Finding (" in prompt and all(v.ok for v in method.verdicts.values())


async def test_what_is_certain_is_corrected_without_asking(server, client_of, checker):
    server.respond = Programmer(slips={"E": "ego = Car at start"})
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C1", client, None, checker)
        structure = await method.generate(TEXT)
    assert "repair E" not in [asked_for(r) for r in server.requests]
    assert "ego = new Car at start" in structure.ego.code and method.verdicts["E"].fixed == 1


async def test_repair_ends_after_three_rounds_and_says_so(server, client_of, checker):
    programmer = Programmer(slips={"O1": "van = new Van at nowhere"}, repairs=False)
    versions = iter(f"van{i} = new Van at nowhere" for i in range(99))

    def respond(request):
        return programmer.wrap(next(versions)) if "O1" in asked_for(request) else programmer(request)

    server.respond = respond
    events = []
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C11", client, Library(), checker)
        structure = await method.generate(TEXT, on_event=events.append)
    assert [asked_for(r) for r in server.requests].count("repair O1") == 3
    assert not method.verdicts["O1"].ok and "van" in structure["O1"].code
    assert any(isinstance(e, ComponentState) and e.component.id == "O1" and e.state == "failed" for e in events)


async def test_the_same_answer_again_is_not_asked_for_a_third_time(server, client_of, checker):
    server.respond = Programmer(slips={"O1": "van = new Van at nowhere"}, repairs=False)
    async with client_of(server, num_ctx=16384) as client:
        await PromptedMethod("C1", client, None, checker).generate(TEXT)
    assert [asked_for(r) for r in server.requests].count("repair O1") == 1


async def test_an_edit_rewrites_the_component_and_those_that_use_its_names(server, client_of):
    server.respond = Programmer()
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C1", client)
        first = await method.generate(TEXT)
        assert dirty(first, method.keys) == []
        server.requests.clear()
        changed = edits.apply(first, edits.SetDescription(component="T", description="The run ends after 10 seconds."))
        await method.write(changed)
        assert [asked_for(r) for r in server.requests] == ["T"]
        server.requests.clear()
        programmer = Programmer()
        part = programmer.parts["O1"]
        programmer.parts["O1"] = part.model_copy(update={"code": part.code + "\nEXTRA = 1"})
        server.respond = programmer
        changed = edits.apply(first, edits.SetDescription(component="O1", description="A white van is parked there."))
        await method.write(changed)
        assert [asked_for(r) for r in server.requests] == ["O1", "O2"], "O2 uses vanSpot, whose interface changed"


@pytest.mark.parametrize("name", BAD_NAMES)
async def test_bad_models_end_in_a_model_error_or_an_incomplete_program(server, client_of, name):
    bad = BAD[name](0)
    good = Programmer()
    server.respond = lambda request: bad(request) if asked_for(request) else good(request)
    async with client_of(server, answer_tokens=200, num_ctx=16384) as client:
        try:
            structure = await PromptedMethod("C1", client).generate(TEXT)
        except errors.ModelError as error:
            assert name == "refused" and "\n" not in str(error)
        else:
            assert not any(c.code for c in structure.components) or name in ("wrong form", "garbage")


async def test_cancelling_leaves_the_given_structure_and_stops_the_model(server, client_of):
    hold = threading.Event()
    good = Programmer()
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C1", client)
        server.respond = good
        first = await method.generate(TEXT)
        before = first.model_dump_json()
        server.requests.clear()
        server.respond = lambda request: Answer(endless("x = 1\n"), hold=hold)
        changed = edits.apply(first, edits.SetDescription(component="O1", description="A truck is parked there."))
        task = asyncio.create_task(method.write(changed))
        assert await asyncio.to_thread(server.streaming.wait, 5)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert await asyncio.to_thread(server.disconnected.wait, 5)
    assert first.model_dump_json() == before and "truck" not in assemble(first).text
    assert len(server.requests) == 1


async def test_a_dead_server_is_said(client_of):
    with FakeOllama() as gone:
        pass
    async with client_of(gone) as client:
        with pytest.raises(errors.ModelUnavailable):
            await PromptedMethod("C11", client).generate(TEXT)


@pytest.mark.nightly
async def test_a_stop_takes_less_than_200_ms(server, client_of):
    hold = threading.Event()
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C1", client)
        server.respond = Programmer()
        structure = await method.interpret(TEXT)
        server.respond = lambda request: Answer(endless("x = 1\n"), hold=hold)
        task = asyncio.create_task(method.write(structure))
        assert await asyncio.to_thread(server.streaming.wait, 5)
        began = asyncio.get_running_loop().time()
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert asyncio.get_running_loop().time() - began < 0.2


async def test_without_retrieval_the_program_is_written_and_that_is_said(server, client_of):
    async def broken(query, **options):
        raise RuntimeError("The index is damaged.")

    server.respond = Programmer()
    events = []
    async with client_of(server, num_ctx=16384) as client:
        structure = await PromptedMethod("C11", client, broken).generate(TEXT, on_event=events.append)
    assert code(structure) == {f.id: f.code for f in EXAMPLE.fragments}
    assert len([e for e in events if e.type == "say" and "The index is damaged" in e.text]) == 5
