"""From text to a program that samples, whatever the model answers: random forms, garbage, nothing, endless."""

import pytest

from c2s_engine.check.client import CheckClient
from c2s_engine.check.protocol import CheckRequest
from c2s_engine.interpret.embedded import EmbeddedInterpreter
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import resolve
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.program import assemble
from c2s_engine.write.methods import MethodTools, method
from tests.models.answers import TEXT
from tests.models.backends import BAD, random_json

TEXTS = [
    TEXT,
    "A truck ahead of ego on the motorway brakes hard, and a car on the left lane overtakes both of them.",
    "Ego turns left at a signalized intersection while an oncoming motorcycle goes straight over it.",
    "A cyclist rides on the right; a child runs onto the road from behind a parked bus.",
    "In fog, ego approaches cones that close its lane, and a police car stands beside them.",
]


class Pipeline:
    """What the facade does with a method: interpret, resolve, write, check."""

    def __init__(self, client: CheckClient) -> None:
        self.check_client = client
        self.library = MapLibrary()
        self.folder = ""

    async def resolve(self, structure: Structure) -> Diagnostic | None:
        return (await resolve(structure, self.library, self.check_client)).diagnostic

    async def run(self, name: str, text: str, client):
        tools = {"embedded": EmbeddedInterpreter(), "client": client, "resolve": self.resolve}
        reading = await method(name, MethodTools(**tools)).interpret(text)
        found = await resolve(reading.structure, self.library, self.check_client)
        assert found.writer is not None, found.diagnostic
        structure = await method(name, MethodTools(**tools, writer=found.writer)).write(reading.structure)
        program = assemble(structure)
        folder = str(found.writer.map.path.parent)
        request = CheckRequest(program=program.text, spans=program.spans, folder=folder, upto="sample")
        return reading, program, await self.check_client.check(request)


async def sampled(server, client_of, count: int, first: int = 0) -> tuple[list[str], list[float], int]:
    failures, shares, components = [], [], 0
    async with CheckClient() as check:
        pipeline = Pipeline(check)
        for seed in range(first, first + count):
            server.respond = random_json(seed)
            async with client_of(server) as client:
                reading, program, report = await pipeline.run("typed", TEXTS[seed % len(TEXTS)], client)
            shares.append(reading.share)
            components += len(reading.structure.components)
            if not report.ok:
                found = [d.message for s in report.stages for d in s.diagnostics]
                failures.append(f"seed {seed}: {found[:1]}\n{program.text}")
    return failures, shares, components


async def test_random_forms_give_programs_that_sample(server, client_of):
    failures, shares, _ = await sampled(server, client_of, 3)
    assert not failures, failures[0]
    assert sum(shares) / len(shares) >= 0.6


@pytest.mark.full
async def test_thirty_random_scenarios(server, client_of):
    failures, shares, components = await sampled(server, client_of, 30)
    assert not failures, f"{len(failures)} of 30\n" + failures[0]
    assert sum(shares) / len(shares) >= 0.6
    assert components > 150


@pytest.mark.nightly
async def test_three_hundred_random_scenarios(server, client_of):
    failures, shares, _ = await sampled(server, client_of, 300)
    assert not failures, f"{len(failures)} of 300\n" + failures[0]
    assert sum(shares) / len(shares) >= 0.6


@pytest.mark.parametrize("name", ["garbage", pytest.param("half_json", marks=pytest.mark.full), "empty", "endless"])
async def test_bad_models_end_in_a_program_and_an_honest_note(server, client_of, name):
    server.respond = BAD[name](1)
    async with CheckClient() as check, client_of(server, answer_tokens=200) as client:
        reading, program, report = await Pipeline(check).run("typed", TEXT, client)
    assert report.ok, [d.message for s in report.stages for d in s.diagnostics]
    assert "ego" in program.text
    assert reading.notes and "embedded interpreter instead of the model" in reading.notes[0]
    assert reading.fallbacks and reading.share < 0.5
