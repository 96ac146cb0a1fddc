"""`c2s models` and the probe."""

import json

import pytest
from typer.testing import CliRunner

from c2s_engine.models.commands import app
from c2s_engine.models.probe import probe
from tests.models.fake_ollama import Answer, FakeOllama, endless, script


@pytest.fixture(autouse=True)
def _folders(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def run(*arguments: str):
    return CliRunner().invoke(app, list(arguments))


def test_list_and_pull(server):
    assert "small" in run("list", "--host", server.host).output
    pulled = run("pull", "fresh", "--host", server.host)
    assert pulled.exit_code == 0 and "50%" in pulled.output and "fresh is there" in pulled.output
    assert "fresh" in run("list", "--host", server.host).output


def test_pulling_what_is_not_there_is_one_sentence(server):
    result = run("pull", "nonsense", "--host", server.host)
    assert result.exit_code == 1 and "file does not exist" in result.output and "Traceback" not in result.output


def test_a_dead_host_is_one_sentence():
    with FakeOllama() as gone:
        host = gone.host
    result = run("list", "--host", host)
    assert result.exit_code == 3 and "does not answer" in result.output and len(result.output.splitlines()) == 1


@pytest.mark.parametrize(
    ("answer", "honours"),
    [(json.dumps({"colour": "red", "count": 1}), True), ("Red.", False), ("", False), (Answer(endless("\n")), False)],
)
def test_probe_tells_whether_the_schema_is_held_to(server, answer, honours):
    server.respond = script(answer)
    said = run("probe", "small", "--host", server.host)
    assert said.exit_code == 0, said.output
    assert ("keeps to a JSON schema" in said.output) is honours


async def test_probe_is_made_once_per_model(server, client_of, tmp_path):
    server.respond = script(json.dumps({"colour": "green", "count": 2}))
    async with client_of(server, model="thinker") as client:
        first = await probe(client, tmp_path)
        asked = len(server.requests)
        assert first.thinks and first.honours_format and first.context_length == client.settings.num_ctx
        assert await probe(client, tmp_path) == first and len(server.requests) == asked
        next(m for m in server.models if m.name == "thinker").digest = "other"
        await probe(client, tmp_path)
        assert len(server.requests) == asked + 1
