"""Every shipped snippet compiles, samples and runs in a minimal program of its own."""

import asyncio

import pytest

from c2s_bench.perf.snippet_hosts import host_program
from c2s_engine.check.client import CheckClient
from c2s_engine.check.protocol import CheckRequest
from c2s_engine.paths import shipped
from c2s_engine.retrieve.snippet_files import shipped as load

pytestmark = pytest.mark.nightly


async def test_every_snippet_runs():
    snippets = {s.id: s for s in load(shipped("snippets"))}
    failed = []
    async with CheckClient(runner="c2s_engine.dryrun.runner:run_scene") as client:
        room = asyncio.Semaphore(2)

        async def one(snippet):
            async with room:
                program = host_program(snippet, snippets)
                report = await client.check(CheckRequest(program=program, upto="run", seed=1, seconds=4))
            problems = [d for s in report.stages for d in s.diagnostics if d.severity != "info"]
            if not report.ok or problems or not report.facts:
                failed.append((snippet.id, [(d.stage, d.line, d.message) for d in problems]))

        await asyncio.gather(*(one(s) for s in snippets.values()))
    assert not failed
