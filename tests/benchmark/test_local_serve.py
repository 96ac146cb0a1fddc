"""The stand-in server speaks Ollama's protocol: c2s's own client talks to it. The model behind it is scripted here."""

import asyncio
import json
import threading
import time
import urllib.error
import urllib.request

import pytest

from c2s_bench.local.llama import Refused
from c2s_bench.local.serve import Service, server
from c2s_engine.models import ModelSettings, OllamaClient, errors
from c2s_engine.models.messages import question
from c2s_engine.models.probe import probe


class Words:
    """A model whose tokens are words: it says its lines, and notes the options and grammars that it was given."""

    context, parameters, size, quantization, digest = 64, 135_000_000, 1000, "Q4_1", "abc"

    def __init__(self) -> None:
        self.says = ["One ", "two."]
        self.asked: list[tuple[list[int], dict]] = []
        self.told: list[list[dict]] = []
        self.left = threading.Event()

    def tokens(self, messages):
        self.told.append(messages)
        return list(range(sum(len(m["content"].split()) for m in messages)))

    def grammar(self, schema):
        if schema == {"type": "nonsense"}:
            raise Refused(500, "invalid JSON schema in format: nonsense")
        return f"grammar of {json.dumps(schema)}"

    def complete(self, tokens, options, gone):
        self.asked.append((tokens, options))
        for word in self.says:
            if gone():
                self.left.set()
                return
            yield {"content": word, "stop": False}
        limit = options["n_predict"] <= len(self.says)
        counts = {"tokens_evaluated": len(tokens), "tokens_predicted": len(self.says)}
        yield {"content": "", "stop": True, "stop_type": "limit" if limit else "eos", **counts, "timings": {}}


class Endless(list):
    def __iter__(self):
        while True:
            time.sleep(0.01)
            yield "word "


@pytest.fixture
def served():
    words = Words()
    with server(Service(words, "tiny"), 0) as listening:
        thread = threading.Thread(target=listening.serve_forever, args=(0.02,), daemon=True)
        thread.start()
        yield words, f"http://127.0.0.1:{listening.server_address[1]}"
        listening.shutdown()
        thread.join(5)


def client_of(host, **more):
    return OllamaClient(ModelSettings(**{"model": "tiny", "host": host, "probe": False, "backoff": 0, **more}))


def post(host, path, body):
    request = urllib.request.Request(host + path, json.dumps(body).encode())
    try:
        with urllib.request.urlopen(request) as answer:
            return answer.status, json.loads(answer.read())
    except urllib.error.HTTPError as error:
        return error.code, json.loads(error.read())


ASK = question("You are brief.", "Say two words.")


async def test_c2s_talks_to_it(served, tmp_path):
    words, host = served
    async with client_of(host) as client:
        reply = await client.chat(ASK)
        assert reply.text == "One two." and (reply.prompt_tokens, reply.answer_tokens) == (6, 2)
        (model,) = await client.models()
        assert (model["name"], model["parameters"], model["quantization"]) == ("tiny:latest", "135M", "Q4_1")
        found = await probe(client, tmp_path)
        assert not found.honours_format and not found.thinks
        words.says = ['{"colour": "red", ', '"wheels": 4}']
        assert (await probe(client, tmp_path, again=True)).honours_format
    _, options = words.asked[-1]
    assert options["grammar"].startswith("grammar of {") and options["temperature"] == 0
    assert options["repeat_penalty"] == 1.1, "Ollama's own default, where a request names none"


async def test_faults_are_those_that_ollama_tells(served):
    words, host = served
    async with client_of(host, model="other") as client:
        with pytest.raises(errors.ModelMissing):
            await client.chat(ASK)
    async with client_of(host) as client:
        with pytest.raises(errors.AnswerTruncated):
            await client.chat(ASK.model_copy(update={"answer_tokens": 1}))
        with pytest.raises(errors.ContextOverflow, match="the model's largest context of 64 tokens: take a model"):
            await client.chat(question("Be brief.", "word " * 70))
    asked = {"model": "tiny", "messages": [{"role": "user", "content": "x"}]}
    assert post(host, "/api/chat", {**asked, "think": True}) == (400, {"error": '"tiny" does not support thinking'})
    assert post(host, "/api/chat", {**asked, "format": {"type": "nonsense"}})[0] == 500
    assert post(host, "/api/chat", {**asked, "keep_alive": "soon"})[0] == 400
    assert post(host, "/api/pull", {"model": "tiny"})[0] == 404


def test_what_is_not_streamed_comes_as_one(served):
    words, host = served
    status, answer = post(host, "/api/chat", {"model": "tiny", "stream": False, "messages": [
        {"role": "user", "content": "x"}], "options": {"num_ctx": 32, "stop": ["."]}, "keep_alive": 60})  # fmt: skip
    assert status == 200 and answer["message"]["content"] == "One two." and answer["done_reason"] == "stop"
    assert words.asked[-1][1]["stop"] == ["."] and words.asked[-1][1]["n_predict"] == 31
    with urllib.request.urlopen(f"{host}/api/ps") as loaded:
        assert json.loads(loaded.read())["models"][0]["context_length"] == 32
    assert post(host, "/api/chat", {"model": "tiny", "messages": []})[1]["done_reason"] == "load"


def test_a_long_prompt_loses_its_middle_not_its_end(served):
    words, host = served
    told = [("system", "s " * 10), ("user", "old " * 50), ("assistant", "a"), ("user", "new " * 10)]
    messages = [{"role": role, "content": content} for role, content in told]
    assert post(host, "/api/chat", {"model": "tiny", "stream": False, "messages": messages})[0] == 200
    assert [m["role"] for m in words.told[-1]] == ["system", "assistant", "user"] and len(words.asked[-1][0]) == 21


async def test_who_leaves_stops_the_model(served):
    words, host = served
    words.says = Endless()
    async with client_of(host) as client:
        task = asyncio.create_task(client.chat(ASK))
        while not words.asked:
            await asyncio.sleep(0.01)
        await asyncio.sleep(0.1)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
    assert await asyncio.to_thread(words.left.wait, 5)
