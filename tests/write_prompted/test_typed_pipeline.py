"""From text to a program that samples, whatever the model answers: random forms, garbage, nothing, endless."""

import pytest

from c2s_engine.interpret.learned import learned
from c2s_engine.interpret.llm.typed import share_without_fallback
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import resolve
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Say
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

    def __init__(self, checker) -> None:
        self.checker = checker
        self.library = MapLibrary()

    async def resolve(self, structure: Structure) -> Diagnostic | None:
        return (await resolve(structure, self.library, self.checker)).diagnostic

    async def run(self, name: str, text: str, client, events: list):
        tools = {"reader": learned, "client": client, "resolve": self.resolve, "check": self.checker}
        reading = await method(name, MethodTools(**tools)).interpret(text, events.append)
        found = await resolve(reading.structure, self.library, self.checker)
        assert found.writer is not None, found.diagnostic
        structure = await method(name, MethodTools(**tools, writer=found.writer)).write(
            reading.structure, events.append
        )
        program = assemble(structure)
        return structure, program, await self.checker(program.text, program.spans)


async def sampled(server, client_of, checker, count: int) -> tuple[list[str], list[float], int]:
    failures, shares, components = [], [], 0
    pipeline = Pipeline(checker)
    for seed in range(count):
        server.respond = random_json(seed)
        async with client_of(server) as client:
            structure, program, report = await pipeline.run("typed", TEXTS[seed % len(TEXTS)], client, [])
        shares.append(share_without_fallback(structure))
        components += len(structure.components)
        if not report.ok:
            found = [d.message for s in report.stages for d in s.diagnostics]
            failures.append(f"seed {seed}: {found[:1]}\n{program.text}")
    return failures, shares, components


async def test_random_forms_give_programs_that_sample(server, client_of, checker):
    failures, shares, _ = await sampled(server, client_of, checker, 2)
    assert not failures, failures[0]
    assert sum(shares) > 0


@pytest.mark.nightly
async def test_thirty_random_scenarios(server, client_of, checker):
    failures, shares, components = await sampled(server, client_of, checker, 30)
    assert not failures, f"{len(failures)} of 30\n" + failures[0]
    assert sum(shares) / len(shares) >= 0.6
    assert components > 150


@pytest.mark.nightly
async def test_three_hundred_random_scenarios(server, client_of, checker):
    failures, shares, _ = await sampled(server, client_of, checker, 300)
    assert not failures, f"{len(failures)} of 300\n" + failures[0]
    assert sum(shares) / len(shares) >= 0.6


@pytest.mark.parametrize(
    "name", ["garbage", *(pytest.param(n, marks=pytest.mark.full) for n in ("half_json", "empty", "endless"))]
)
async def test_bad_models_end_in_a_program_and_an_honest_note(server, client_of, checker, name):
    server.respond = BAD[name](1)
    events: list = []
    async with client_of(server, answer_tokens=200) as client:
        structure, program, report = await Pipeline(checker).run("typed", TEXT, client, events)
    notes = [e.text for e in events if isinstance(e, Say)]
    assert report.ok, [d.message for s in report.stages for d in s.diagnostics]
    assert "ego" in program.text
    assert notes and "learned reader instead of the model" in notes[0]
    assert share_without_fallback(structure) < 0.5
