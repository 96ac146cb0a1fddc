"""`c2s mcp` over standard input and output, asked by the official package's own client as an editor asks it."""

import asyncio
import json
import os
import sys
import threading

import psutil
import pytest
from mcp import Client
from mcp.client.stdio import StdioServerParameters
from typer.testing import CliRunner

from tests.models.fake_ollama import Answer, FakeOllama, endless

LEAD = "A van drives 20 m ahead of ego at 40 km/h on a straight road and brakes hard after 3 seconds."


@pytest.fixture
def serving(tmp_path):
    """How the server is started, in a folder of its own; `options` are config.toml's [ollama]."""

    def make(**options: object) -> StdioServerParameters:
        folder = tmp_path / "config" / "c2s"
        folder.mkdir(parents=True)
        lines = [f"{name} = {json.dumps(value)}" for name, value in options.items()]
        folder.joinpath("config.toml").write_text("\n".join(["[ollama]", *lines]))
        env = {"XDG_DATA_HOME": str(tmp_path / "data"), "XDG_CONFIG_HOME": str(tmp_path / "config")}
        env |= {"XDG_CACHE_HOME": os.environ["XDG_CACHE_HOME"]} if "XDG_CACHE_HOME" in os.environ else {}
        command = ["-m", "c2s_engine.cli", "mcp", "--model", "small"]
        return StdioServerParameters(command=sys.executable, args=command, env=env, cwd=tmp_path)

    return make


async def answer(client: Client, tool: str, **arguments) -> dict:
    told = await client.call_tool(tool, arguments)
    assert not told.is_error, told.content
    assert json.loads(told.content[0].text) == told.structured_content
    return told.structured_content


async def refusal(client: Client, tool: str, **arguments) -> str:
    told = await client.call_tool(tool, arguments)
    assert told.is_error
    return told.content[0].text


@pytest.mark.full
async def test_an_assistant_makes_checks_runs_and_edits_a_scenario(serving, tmp_path):
    before = psutil.Process().children(recursive=True)
    async with Client(serving()) as client:
        tools = (await client.list_tools()).tools
        assert [t.name for t in tools] == ["generate", "interpret", "check", "run", "edit", "report", "search"]
        assert all(t.description and all("description" in p for p in t.input_schema["properties"].values())
                   for t in tools)  # fmt: skip

        stages = []

        async def progress(at: float, total: float | None, message: str | None) -> None:
            stages.append((at, message))

        made = await client.call_tool("generate", {"text": LEAD, "output": "lead.scenic"}, progress_callback=progress)
        made = made.structured_content
        assert made["ok"] and made["required"]["seen"] > 5 and "brake_hard" in {e["event"] for e in made["events"]}
        assert [c["id"] for c in made["structure"]] == ["G", "R", "E", "O1", "T"]
        assert {"interpret", "write", "compile"} <= {m for _, m in stages} and [a for a, _ in stages] == sorted(
            a for a, _ in stages
        )
        assert (tmp_path / "lead.scenic").read_text() == made["program"] and "lead.scenic" in made["saved"]

        read = await answer(client, "interpret", text=LEAD)
        assert {c["status"] for c in read["account"]} == {"understood"} and "program" not in read
        assert (await answer(client, "check", file="lead.scenic"))["ok"]
        ran = await answer(client, "run", program=made["program"], runs=2)
        assert ran["ok"] and {e["seed"] for e in ran["events"]} == {0, 1}
        broken = made["program"].replace("ego = new Car", "ego = Car")
        told = await answer(client, "check", program=broken, fix=True)
        assert not told["ok"] and told["problems"][0]["line"] == 1 + broken[: broken.index("ego = Car")].count("\n")
        assert told["fixed_program"] == made["program"]

        said = await answer(client, "edit", session="mine", new=True, say=LEAD)
        changed = await answer(client, "edit", session="mine", set={"O1.speed": 9.0})
        assert next(c for c in changed["structure"] if c["id"] == "O1")["spec"]["speed"] == 9
        assert (await answer(client, "edit", session="mine", undo=True))["program"] == said["program"]
        (written,) = (await answer(client, "report", what="mine", output="dossier"))["written"]
        assert not written["problem"] and (tmp_path / written["file"]).is_file()

        for sentence, tool, arguments in (
            ("The description is empty", "generate", {"text": " "}),
            ("There is no method bogus", "generate", {"text": LEAD, "method": "bogus"}),
            ("There is no folder nowhere", "generate", {"text": LEAD, "output": "nowhere/x.scenic"}),
            ("There is no file absent.scenic", "check", {"file": "absent.scenic"}),
            ("Give either `program`", "run", {}),
            ("There is no session 'other'", "edit", {"session": "other", "say": "faster"}),
            ("there is no field sped", "edit", {"session": "mine", "set": {"O1.sped": 9}}),
            ("The query is empty", "search", {"query": ""}),
        ):
            told = await refusal(client, tool, **arguments)
            assert sentence in told and "\n" not in told and "Traceback" not in told
        started = [p for p in psutil.Process().children(recursive=True) if p not in before]
        assert any("c2s_engine.check.server" in p.cmdline() for p in started)
    assert not psutil.wait_procs(started, timeout=10)[1], "nothing is left running"


@pytest.mark.full
async def test_who_names_no_session_is_told_what_makes_one(serving):
    async with Client(serving()) as client:
        said = await refusal(client, "edit", session="mine", say="make the van a truck")
    assert said.endswith("There is no session 'mine': there are none yet. `new`: true makes it.")


@pytest.mark.full
async def test_a_cancelled_call_stops_the_model_and_the_next_is_answered(serving):
    with FakeOllama(lambda request: Answer(endless('{"objects": ['), hold=threading.Event())) as ollama:
        async with Client(serving(host=ollama.host, probe=False), mode="legacy") as client:  # as most editors speak
            call = asyncio.create_task(client.call_tool("generate", {"text": LEAD, "method": "typed"}))
            assert await asyncio.to_thread(ollama.streaming.wait, 30)
            call.cancel()
            with pytest.raises(asyncio.CancelledError):
                await call
            assert await asyncio.to_thread(ollama.disconnected.wait, 10)
            assert (await answer(client, "generate", text=LEAD, method="reader"))["ok"]
        assert len(ollama.requests) == 1


@pytest.mark.full
async def test_what_the_model_cannot_do_is_told_beside_the_answer(serving):
    with FakeOllama() as gone:
        host = gone.host
    async with Client(serving(host=host)) as client:
        made = await answer(client, "generate", text=LEAD, method="typed")
    assert made["ok"] and any("Ollama does not answer" in note for note in made["notes"])


@pytest.mark.full
async def test_search_shows_that_the_index_is_loaded(serving):
    steps = []

    async def progress(at: float, total: float | None, message: str | None) -> None:
        steps.append(message)

    async with Client(serving()) as client:
        found = await client.call_tool("search", {"query": "cut-in under R157", "limit": 2}, progress_callback=progress)
        first, *_ = found.structured_content["passages"]
        assert "157" in first["title"] and first["text"] and steps[0] == "loading the index"
        code = await answer(client, "search", query="a pedestrian crosses", component="O", limit=1)
        assert code["passages"][0]["kind"] == "snippet"


def test_without_the_package_it_is_one_sentence(monkeypatch):
    import typer

    from c2s_engine.commands.mcp import mcp

    monkeypatch.setitem(sys.modules, "mcp", None)
    app = typer.Typer()
    app.command()(mcp)
    told = CliRunner().invoke(app, [])
    assert told.exit_code == 3 and "pip install 'c2s[mcp]'" in told.output.replace("\n", " ")
