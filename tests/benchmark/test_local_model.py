"""A real model all the way: GGUF, tokenizer, grammar, streaming, cancelling, timeouts, texts to programs that run.

SmolLM2 of 135 million parameters in llama.cpp, served by benchmark/local; without the learned reader's packages
these tests are skipped. What such a small model answers is not judged here, only that whatever it answers ends well.
"""

import asyncio
import contextlib
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from c2s_bench.local.selection import every
from c2s_bench.records import load
from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.interpret.learned import installed
from c2s_engine.interpret.llm.answers import json_object
from c2s_engine.interpret.llm.mend import mend
from c2s_engine.interpret.llm.schema import accepts, spec_schema
from c2s_engine.models import ModelSettings, OllamaClient, errors, question
from c2s_engine.models.probe import probe
from c2s_engine.structure.progress import Finished, Usage

ROOT = Path(__file__).parents[2]
pytestmark = [pytest.mark.nightly, pytest.mark.skipif(not installed(), reason="the reader's packages are missing")]

TEXT = "A van drives 20 m ahead of ego at 40 km/h in heavy rain and brakes hard. A pedestrian crosses from the right."


@pytest.fixture(scope="module")
def host() -> Iterator[str]:
    """Where the model is served, with one thread and low priority."""
    command = [sys.executable, "-m", "benchmark.local.serve", "--name", "smollm2", "--port", "0", "--threads", "1"]
    serving = subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=lambda: os.nice(15)
    )
    assert serving.stdout is not None
    yield re.search(r"OLLAMA_HOST=(\S+)", serving.stdout.readline())[1]
    serving.kill()
    serving.wait()


@pytest.fixture
def client_of(host):
    return lambda **settings: OllamaClient(ModelSettings(model="smollm2", host=host, probe=False, **settings))


async def test_tokens_are_counted_and_the_answer_streams(client_of):
    asked = question("You are brief.", "Name ten animals.", answer_tokens=60)
    async with client_of() as client:
        pieces = []
        with contextlib.suppress(errors.AnswerTruncated):
            await client.chat(asked, lambda event: pieces.append(getattr(event, "text", "")))
        (row,) = client.ledger.rows
    assert len([p for p in pieces if p]) > 10, "it comes in pieces"
    assert asked.tokens * 0.5 < row.prompt_tokens < asked.tokens * 3 and 10 < row.answer_tokens <= 60


async def test_the_probe_finds_that_a_grammar_is_held_to(client_of, tmp_path):
    async with client_of() as client:
        found = await probe(client, tmp_path, every=True)
    assert [(t.way.endpoint, t.holds) for t in found.tried] == [("chat", True), ("generate", True)]
    assert found.server and len(found.digest) == 64 and not found.thinks


@pytest.mark.parametrize("kind", ["G", "R", "E", "O", "T"])
@pytest.mark.parametrize("endpoint", ["chat", "generate"])
async def test_every_form_is_filled_in_or_cut(client_of, kind, endpoint):
    schema = spec_schema(kind, ("ego", "O1", "O2"))
    async with client_of(endpoint=endpoint, answer_tokens=400) as client:
        try:
            reply = await client.chat(question("Fill in the form.", TEXT, schema=schema))
        except (errors.AnswerTruncated, errors.AnswerRepeats):
            return
    fault = accepts(schema, mend(schema, json_object(reply.text)))
    assert not fault or "must lie between" in fault, "a grammar does not hold decimals to their bounds"


async def test_cancelling_frees_the_model_and_silence_is_a_timeout(client_of):
    long = question("Count.", "Count from one to a thousand in words.", answer_tokens=4000)
    async with client_of() as client:
        call = asyncio.create_task(client.chat(long))
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(asyncio.shield(call), 1)
        call.cancel()
        with pytest.raises(asyncio.CancelledError):
            await call
        async with asyncio.timeout(20):  # it would answer the first for far longer
            with contextlib.suppress(errors.AnswerTruncated):
                await client.chat(question("You are brief.", "Say yes.", answer_tokens=10))
    words = " ".join(load()[n].text for n in range(30))
    async with client_of(timeout=0.05) as client:
        with pytest.raises(errors.ModelTimeout):
            await client.chat(question("Sum this up.", words))
    async with client_of(num_ctx=1024) as client:
        with pytest.raises(errors.ContextOverflow):
            await client.chat(question("Sum this up.", words))


async def test_texts_of_the_benchmark_end_in_programs_that_run(host, tmp_path, monkeypatch):
    """Each twelfth of the 123; all of them: benchmark/local/README.md."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    chosen, failed, shares = [r for r in load() if r.id in every(12)], {}, []
    async with Engine(Settings(model="smollm2", method="typed", ollama={"host": host})) as engine:
        for record in chosen:
            events = [e async for e in engine.generate(record.text)]
            done = events[-1]
            assert isinstance(done, Finished) and any(isinstance(e, Usage) for e in events)
            shares.append(done.details["share"])
            if not done.ok:
                failed[record.id] = [d.message for d in done.diagnostics]
    assert not failed and len(chosen) == 11
    assert max(shares) > 0, "the model fills some forms by itself"
