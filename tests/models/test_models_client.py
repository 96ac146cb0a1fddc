"""The client against the scripted server: streams, faults and their sentences, retries, limits, cancellation."""

import asyncio
import subprocess
import sys
import threading

import pytest

from c2s_engine.models import Message, ModelSettings, OllamaClient, Question, errors, question
from c2s_engine.structure.progress import Token, Usage
from tests.models.fake_ollama import Answer, FakeOllama, endless, script

ASK = question("Be brief.", "Say hello.", purpose="test", component="E")


async def test_streams_pieces_and_enters_the_ledger(server, client_of):
    server.respond = script("Hello there, this is an answer of some length.")
    events = []
    async with client_of(server) as client:
        client.ledger.begin("scenario-1")
        reply = await client.chat(ASK, events.append)
    assert reply.text == "Hello there, this is an answer of some length."
    tokens = [e for e in events if isinstance(e, Token)]
    assert len(tokens) > 1 and "".join(t.text for t in tokens) == reply.text
    assert isinstance(events[-1], Usage) and events[-1].component == "E" and events[-1].prompt_tokens > 0
    assert client.ledger.by("scenario")["scenario-1"].calls == 1
    assert client.ledger.total().tokens == reply.prompt_tokens + reply.answer_tokens


async def test_one_context_size_for_every_call(server, client_of):
    async with client_of(server, num_ctx=4096) as client:
        await client.chat(ASK)
        await client.chat(question("a", "b", answer_tokens=50))
    assert {r["options"]["num_ctx"] for r in server.requests} == {4096}
    assert server.requests[1]["options"]["num_predict"] == 50


async def test_thinking_is_sent_only_where_it_can_be(server, client_of):
    server.respond = script(Answer("done", thinking="let me see"))
    async with client_of(server, think=True) as client:
        await client.chat(ASK)
    async with client_of(server, model="thinker") as client:
        reply = await client.chat(ASK)
    assert "think" not in server.requests[0]
    assert server.requests[1]["think"] is False
    assert reply.thinking == "let me see" and reply.text == "done"


async def test_forms_go_where_the_settings_say_and_words_to_chat(server, client_of):
    server.respond = script('{"a": 1}')
    messages = (*question("Be brief.", "Fill it in.").messages, Message(role="assistant", content='{"a": "x"}'),
                Message(role="user", content="a must be a number."))  # fmt: skip
    form = Question(messages=messages, schema_={"type": "object", "properties": {"a": {"type": "integer"}}})
    async with client_of(server, endpoint="generate") as client:
        reply = await client.chat(form)
        assert reply.text == '{"a": 1}' and reply.prompt_tokens > 0 and reply.done_reason == "stop"
        await client.chat(ASK)
    asked, words = server.requests
    assert (asked["endpoint"], words["endpoint"]) == ("generate", "chat") and asked["format"] == form.schema_
    system, prompt = (m["content"] for m in asked["messages"])
    assert system == "Be brief." and prompt == 'Fill it in.\n\nYou answered:\n{"a": "x"}\n\na must be a number.'
    assert asked["options"]["num_ctx"] == words["options"]["num_ctx"]


@pytest.mark.parametrize(
    ("answer", "error", "asked"),
    [
        (Answer("a long answer that breaks off", chunk=4, fault="cut"), errors.ModelCutOff, 3),
        (Answer("a long answer that breaks off", chunk=4, fault="error"), errors.ModelCutOff, 3),
        (Answer("a long answer that breaks off", chunk=4, fault="broken_json"), errors.ModelCutOff, 3),
        (Answer("a long answer that breaks off", chunk=4, fault="no_done"), errors.ModelCutOff, 3),
        (Answer(status=503, error="server busy"), errors.ModelBusy, 3),
        (Answer(status=500, error="out of memory"), errors.ModelFailed, 3),
        (Answer(status=400, error="bad template"), errors.ModelRefused, 1),
        (Answer("word " * 4000), errors.AnswerRepeats, 1),
        (Answer(endless("x")), errors.AnswerRepeats, 1),
        (Answer("some words", done_reason="length"), errors.AnswerTruncated, 1),
        (Answer("some words", prompt_tokens=8192), errors.ContextOverflow, 1),
    ],
)
async def test_each_fault_has_its_error_and_its_number_of_tries(server, client_of, answer, error, asked):
    server.respond = script(answer)
    async with client_of(server) as client:
        with pytest.raises(error) as caught:
            await client.chat(ASK)
    assert len(server.requests) == asked
    assert [r.outcome for r in client.ledger.rows] == [error.__name__] * asked
    sentence = str(caught.value)
    assert "\n" not in sentence and sentence.endswith(".") and "Traceback" not in sentence


async def test_an_answer_that_cannot_be_used_costs_what_the_model_counted(server, client_of):
    server.respond = script(Answer("some words " * 8, done_reason="length", prompt_tokens=77))
    events = []
    async with client_of(server) as client:
        with pytest.raises(errors.AnswerTruncated, match="cut after 22 tokens"):
            await client.chat(ASK, events.append)
    (row,) = client.ledger.rows
    assert (row.prompt_tokens, row.answer_tokens) == (77, 22)
    assert [e.answer_tokens for e in events if isinstance(e, Usage)] == [22]


async def test_a_fault_that_passes_is_not_seen(server, client_of):
    server.respond = script(Answer("a long answer", chunk=2, fault="cut"), Answer(status=503), "whole")
    events = []
    async with client_of(server) as client:
        assert (await client.chat(ASK, events.append)).text == "whole"
    assert len([e for e in events if isinstance(e, Usage)]) == 3, "failed tries cost too"
    assert [r.tries for r in client.ledger.rows] == [1, 2, 3]


async def test_missing_model_names_the_command_that_gets_it(server, client_of):
    async with client_of(server, model="absent") as client:
        with pytest.raises(errors.ModelMissing, match="c2s models pull absent"):
            await client.chat(ASK)


async def test_dead_host_is_said_at_once():
    with FakeOllama() as gone:
        host = gone.host
    async with OllamaClient(ModelSettings(model="small", host=host, retries=5, backoff=60)) as client:
        with pytest.raises(errors.ModelUnavailable, match="OLLAMA_HOST"):
            await client.chat(ASK)
        with pytest.raises(errors.ModelUnavailable):
            await client.models()


async def test_no_model_chosen():
    async with OllamaClient(ModelSettings(host="http://127.0.0.1:9")) as client:
        with pytest.raises(errors.ModelNotSet, match="reader"):
            await client.chat(ASK)


async def test_silence_is_a_timeout(server, client_of):
    hold = threading.Event()
    server.respond = script(Answer("a few words and then nothing", chunk=4, hold=hold))
    async with client_of(server, timeout=0.2) as client:
        with pytest.raises(errors.ModelTimeout):
            await client.chat(ASK)
    hold.set()
    assert len(server.requests) == 1


async def test_a_prompt_far_beyond_the_context_is_never_sent(server, client_of):
    async with client_of(server, num_ctx=1024) as client:
        with pytest.raises(errors.ContextOverflow):
            await client.chat(question("a", "word " * 4000))
    assert not server.requests


async def test_a_prompt_cut_by_the_server_is_noticed(server, client_of):
    async with client_of(server, num_ctx=1024) as client:
        with pytest.raises(errors.ContextOverflow):
            await client.chat(question("a", "words " * 800))
    assert len(server.requests) == 1


async def test_cancelling_stops_the_server(server, client_of):
    hold = threading.Event()
    server.respond = script(Answer(endless("words that vary little "), hold=hold))
    async with client_of(server) as client:
        task = asyncio.create_task(client.chat(ASK))
        assert await asyncio.to_thread(server.streaming.wait, 5)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        assert await asyncio.to_thread(server.disconnected.wait, 5)
        assert server.sent <= 4
        server.respond = script("still here")
        assert (await client.chat(ASK)).text == "still here"


async def test_record_then_replay_without_a_server(server, client_of, tmp_path):
    server.respond = script("an answer")
    async with client_of(server, record="record", record_folder=tmp_path) as client:
        first = await client.chat(ASK)
    asked = len(server.requests)
    dead = ModelSettings(model="small", host="http://127.0.0.1:9", record="replay", record_folder=tmp_path)
    async with OllamaClient(dead) as client:
        again = await client.chat(ASK)
        assert again.replayed and again.text == first.text and again.prompt_tokens == first.prompt_tokens
        with pytest.raises(errors.NotRecorded):
            await client.chat(question("a", "never asked"))
    async with OllamaClient(dead.model_copy(update={"seed": 7})) as client:
        with pytest.raises(errors.NotRecorded):
            await client.chat(ASK)
    assert len(server.requests) == asked


@pytest.mark.parametrize(
    ("answer", "error"),
    [(Answer("no end", done_reason="length"), errors.AnswerTruncated), (Answer("x " * 2000), errors.AnswerRepeats)],
)
async def test_answers_that_cannot_be_used_are_replayed_as_such(server, client_of, tmp_path, answer, error):
    server.respond = script(answer)
    for settings in ({"record": "record"}, {"record": "replay", "host": "http://127.0.0.1:9"}):
        async with client_of(server, record_folder=tmp_path, **settings) as client:
            with pytest.raises(error):
                await client.chat(ASK)
    assert len(server.requests) == 1


def test_importing_the_room_brings_no_http():
    code = "import sys, c2s_engine.models; print(sorted({'ollama', 'httpx'} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"
