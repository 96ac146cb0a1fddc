"""`c2s models` and the probe."""

import asyncio
import json

import pytest
from typer.testing import CliRunner

from c2s_engine.config import Settings
from c2s_engine.doctor import examine
from c2s_engine.models.commands import app
from c2s_engine.models.probe import known, probe
from c2s_engine.models.ways import Way
from tests.models.fake_ollama import Answer, FakeOllama, endless, script

RIGHT = json.dumps({"colour": "red", "wheels": 4})


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
    *_, sentence = result.output.splitlines()
    assert result.exit_code == 3 and "cannot fetch nonsense (pull model manifest: file does not exist)" in sentence
    assert "c2s models suggest" in sentence and "Traceback" not in result.output


def test_a_dead_host_is_one_sentence():
    with FakeOllama() as gone:
        host = gone.host
    result = run("list", "--host", host)
    assert result.exit_code == 3 and "does not answer" in result.output and len(result.output.splitlines()) == 1


@pytest.mark.parametrize(
    ("answer", "honours"),
    [
        (RIGHT, True),
        (json.dumps({"colour": "blue", "wheels": 4}), False),
        ("Red.", False),
        ("", False),
        (Answer(endless("\n")), False),
    ],
)
def test_probe_tells_whether_the_schema_is_held_to(server, answer, honours):
    server.respond = script(answer)
    said = run("probe", "small", "--host", server.host)
    assert said.exit_code == 0, said.output
    assert ("keeps to a JSON schema" in said.output) is honours


async def test_probe_is_made_once_per_digest_and_server_version(server, client_of, tmp_path):
    server.respond = script(RIGHT)
    async with client_of(server, model="thinker") as client:
        first = await probe(client, tmp_path)
        asked = len(server.requests)
        assert first.thinks and first.honours_format and first.context_length == client.settings.num_ctx
        assert await probe(client, tmp_path) == first and len(server.requests) == asked
        for change in (lambda: setattr(server, "version", "0.31.0"), lambda: setattr(server.models[1], "digest", "x")):
            change()
            assert await known(client, tmp_path) is None
            asked += 1
            assert (await probe(client, tmp_path)).server == "0.31.0" and len(server.requests) == asked
        server.version, server.models[1].digest = first.server, first.digest
        assert await known(client, tmp_path) == first, "what an earlier version did is still known"
        server.version = None
        assert (await probe(client, tmp_path)).server == ""


async def test_the_way_with_a_true_answer_and_then_the_fewest_tokens_is_taken(server, client_of, tmp_path):
    def respond(request):
        thinks = {False: "", "low": "Hm. ", True: "Let me think about it, slowly. "}[request["think"]]
        answer = RIGHT if thinks else json.dumps({"colour": "green", "wheels": 0})
        return Answer(answer, thinking=thinks) if request["endpoint"] == "chat" else "Red, four."

    server.respond = respond
    async with client_of(server, model="thinker") as client:
        found = await probe(client, tmp_path, every=True)
    assert [(t.holds, t.right) for t in found.tried] == [(True, False), (False, False), (True, True), (True, True)]
    assert found.best() == Way(think="low")
    assert found.best([Way(), Way(endpoint="generate")]) == Way()
    by_way = {(r["endpoint"], r["think"]): r["options"]["num_predict"] for r in server.requests}
    assert by_way["chat", True] == by_way["chat", "low"] == by_way["chat", False] + 2048, "room for thoughts"


async def test_the_settings_way_is_the_only_one(server, client_of, tmp_path):
    server.respond = script(RIGHT)
    async with client_of(server, model="thinker", endpoint="generate", think="low") as client:
        assert [t.way for t in (await probe(client, tmp_path, every=True)).tried] == [client.settings.way]
    assert [(r["endpoint"], r["think"]) for r in server.requests] == [("generate", "low")]


def test_probe_shows_each_way_and_doctor_remembers(server, monkeypatch):
    monkeypatch.setenv("OLLAMA_HOST", server.host)
    server.respond = lambda r: RIGHT if r["endpoint"] == "generate" else "Red and four."

    async def model() -> str:
        return next(f["found"] for f in await examine(Settings(model="thinker")) if f["name"] == "model")

    assert "not tried with this server; `c2s models probe thinker`" in asyncio.run(model())
    said = run("probe", "thinker").output.splitlines()
    assert [line.split()[0:2] for line in said[:4]] == [["/api/chat", "with"], ["/api/generate", "with"]] + [
        ["/api/chat", "with"]] * 2  # fmt: skip
    assert [" yes: " in line for line in said[:4]] == [False, True, False, False]
    assert "the form is ignored: 'Red and four.'" in said[0] and "0.30.7" in said[-2]
    asked = len(server.requests)
    assert "forms by /api/generate with think=false" in asyncio.run(model())
    assert run("probe", "thinker").output.splitlines()[:5] == said[:5] and len(server.requests) == asked
    assert run("probe", "thinker", "--again").exit_code == 0 and len(server.requests) == 2 * asked


def test_probe_takes_the_model_that_is_set(server, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.delenv("C2S_MODEL", raising=False)
    server.respond = lambda request: RIGHT
    none = run("probe", "--host", server.host)
    assert none.exit_code == 2 and none.output.startswith("Name the model to be tried: `c2s models list`")
    monkeypatch.setenv("C2S_MODEL", "small")
    assert run("probe", "--host", server.host).output.rstrip().splitlines()[-1].startswith("small:")


def test_models_worth_trying_by_memory():
    every, some = run("suggest").output.splitlines(), run("suggest", "--memory", "8").output.splitlines()
    assert 3 < len(some) < len(every) and some == every[: len(some)], "the smallest come first"
    assert all("not tried" in line or "/api/" in line for line in every[1:])
