"""The facade with a model at the scripted server: turns, answers, cost, the run's differences, faults, cancelling."""

import asyncio
import json
import threading
from contextlib import aclosing

import pytest

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.structure.progress import Finished, Passage, Say, Usage
from tests.models.answers import FORMS, TEXT, asked_of, sensible
from tests.models.backends import garbage
from tests.models.fake_ollama import Answer, FakeOllama, endless, said
from tests.write_prompted.programmer import TEXT as PROGRAMMED
from tests.write_prompted.programmer import Programmer

LEAD = "A van drives 20 m ahead of ego at 40 km/h."
RULES = Passage(kind="doc", title="UN Regulation No. 157: ALKS › Test: cut-in (Annex 5, 4.4)", clause="Annex 5, 4.4",
                text="Scenario: Ego drives at 60 km/h on a motorway. A car cuts in ahead of ego.\n\nPass: no contact.",
                score=0.9)  # fmt: skip


def settings(server, **more) -> Settings:
    table = {"host": server.host, "backoff": 0.001, "probe": False, "num_ctx": 16384, **more.pop("ollama", {})}
    return Settings(model="small", method="typed", ollama=table, **more)


async def events_of(stream) -> tuple[list, Finished]:
    async with aclosing(stream) as events:
        found = [e async for e in events]
    assert isinstance(found[-1], Finished)
    return found, found[-1]


def notes(events) -> list[str]:
    return [e.text for e in events if isinstance(e, Say)]


def turns(request):
    """A good model of the typed method that also reads turns and answers questions."""
    text = said(request)
    if "Passages:" in text:
        return "A vehicle cuts into the lane on a motorway [1]."
    if "Decide what the tester's turn is" in text and not asked_of(request):
        if "R157" in text.rsplit("Turn:", 1)[1]:
            return json.dumps({"kind": "question"})
        sentence = "A truck drives 20 m ahead of ego at 40 km/h and brakes hard for the pedestrian."
        return json.dumps({"kind": "edit", "changes": [{"do": "change", "component": "O1", "sentence": sentence}]})
    if asked_of(request) == "O1" and "A truck drives 20 m ahead" in text:
        return json.dumps({**FORMS["O1"], "type": "truck", "name": "truck"})
    return sensible(request)


async def test_a_scenario_a_change_a_question_and_what_is_picked(server):
    server.respond = turns
    async with Engine(settings(server)) as engine:
        events, done = await events_of(engine.generate(TEXT, run=False))
        assert done.ok, done.diagnostics
        assert done.details["share"] == 1 and done.details["tokens"] == sum(done.details["usage"].values()) > 1000
        assert set(done.details["usage"]) == {"", "G", "R", "E", "O1", "O2", "O3"}
        assert done.details["tokens"] == sum(e.prompt_tokens + e.answer_tokens for e in events if isinstance(e, Usage))

        events, changed = await events_of(engine.say(done.structure, "the lead should be a lorry", run=False))
        assert changed.ok and changed.structure["O1"].spec.type == "truck"
        assert "O1" in changed.details["rewritten"] and "R" not in changed.details["rewritten"]
        assert any("O1: A truck" in n for n in notes(events)), "what changed"
        assert any(n.startswith("Rewritten: ") and "O1" in n and "stayed" in n for n in notes(events))
        assert changed.structure["O2"] == done.structure["O2"] and changed.details["tokens"] > 0

        async def search(query, **options):
            return [RULES]

        engine.search = search
        asked = "what does R157 ask for a cut-in?"
        events, answered = await events_of(engine.say(changed.structure, asked))
        assert "A vehicle cuts into the lane on a motorway [1]." in notes(events) and RULES in events
        assert answered.structure == changed.structure and answered.details["unchanged"]
        assert not {"write", "run"} & {s.name for s in answered.stages}
        kept = answered.details["passages"]
        server.respond = garbage(0)
        _, picked = await events_of(engine.say(changed.structure, "use 1", passages=kept, method="reader", run=False))
        assert picked.ok and picked.structure.text.startswith("[UN R157, Annex 5, 4.4] Ego drives")
        assert all(c.links[-1].label == "UN R157, Annex 5, 4.4" for c in picked.structure.components)
        spans = [picked.structure.text[slice(*k.span)] for k in picked.structure["O1"].links if k.span]
        assert "cuts" in spans, "spans are offsets of the text with its source"
        server.respond = lambda request: "No passage is cited here."
        events, _ = await events_of(engine.say(changed.structure, asked))
        assert any("cites no passage" in n for n in notes(events)) and RULES in events


@pytest.mark.full
async def test_without_ollama_there_is_a_program_or_one_sentence():
    with FakeOllama() as gone:
        pass
    async with Engine(settings(gone)) as engine:
        events, done = await events_of(engine.generate(LEAD, run=False))
        assert done.ok and done.details["share"] == 0
        assert any("Ollama does not answer" in n for n in notes(events))
        events, changed = await events_of(engine.say(done.structure, "make the lead a truck", run=False))
        assert changed.ok and changed.structure["O1"].spec.type == "truck"
        _, failed = await events_of(engine.generate(LEAD, method="prompted", run=False))
        assert not failed.ok and [d.code for d in failed.diagnostics] == ["model-service"]
        engine.settings.model = None
        _, failed = await events_of(engine.generate(LEAD, run=False))
        assert "--model NAME" in failed.diagnostics[0].message
        engine.settings.ollama = {"num_ctx": 12}
        engine.settings.model = "small"
        _, failed = await events_of(engine.generate(LEAD, run=False))
        assert "[ollama] num_ctx" in failed.diagnostics[0].message


@pytest.mark.full
@pytest.mark.parametrize("method", ["typed", "prompted"])
async def test_cancelling_in_mid_stream_stops_the_model_and_leaves_s(server, method):
    """The bound is generous: the figure is `python -m tests.models.measure_cancel`'s."""
    hold = threading.Event()
    server.respond = lambda request: Answer(endless('{"objects": ['), hold=hold)
    async with Engine(settings(server)) as engine:
        _, done = await events_of(engine.generate(LEAD, method="reader", run=False))
        before = done.structure.model_dump_json()
        events = engine.say(done.structure, "make it rain", method=method, run=False)
        waiting = asyncio.create_task(anext(events))
        assert await asyncio.to_thread(server.streaming.wait, 10)
        await waiting
        began = asyncio.get_running_loop().time()
        await events.aclose()
        assert asyncio.get_running_loop().time() - began < 2
        assert await asyncio.to_thread(server.disconnected.wait, 5)
        assert len(server.requests) == 1 and done.structure.model_dump_json() == before


@pytest.mark.full
async def test_a_model_that_keeps_to_no_form_is_told_the_schema(server, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))

    def respond(request):
        return "Red." if "Which colour" in said(request) else sensible(request)

    server.respond = respond
    async with Engine(settings(server, ollama={"probe": True})) as engine:
        _, done = await events_of(engine.generate(TEXT, run=False))
        assert done.ok and done.details["share"] == 1
    probes = [r for r in server.requests if "Which colour" in said(r)]
    assert [r["endpoint"] for r in probes] == ["chat", "generate"], "tried once in each way"
    assert all("JSON schema" in r["messages"][0]["content"] for r in server.requests if r not in probes)


@pytest.mark.full
async def test_a_silent_model_gets_its_sentence(server):
    server.respond = lambda request: Answer("{}", after=0, hold=threading.Event())
    async with Engine(settings(server, ollama={"timeout": 0.5})) as engine:
        events, done = await events_of(engine.generate(LEAD, run=False))
        assert done.ok and any("sent nothing for 0.5 s" in n for n in notes(events))
        _, failed = await events_of(engine.generate(LEAD, method="chat2scenic:C1", run=False))
        assert failed.diagnostics[0].code == "model-service"


@pytest.mark.full
async def test_what_the_run_does_not_show_goes_back_and_is_kept_where_it_helps(server):
    text = "A car drives 25 m ahead of ego at 40 km/h on a straight road and brakes hard after 100 seconds; ego brakes."
    late = {"name": "lead", "type": "car", "speed": 11, "placement": {"position": "ahead", "gap": 25},
            "phases": [{"action": "brake", "rate": 6, "trigger": {"kind": "time", "value": 100}}]}  # fmt: skip
    soon = {**late, "phases": [{**late["phases"][0], "trigger": {"kind": "time", "value": 3}}]}
    ego = {"speed": 11, "reaction": "brake", "react_to": "O1", "hard": True}
    sentence = "A car drives 25 m ahead of ego at 40 km/h and brakes hard after 100 seconds."
    components = {"place": "A straight road.", "ego": "Ego brakes hard for the car.",
                  "objects": [{"type": "car", "sentence": sentence}]}  # fmt: skip

    def respond(request):
        if "Said, but not seen" in said(request):
            change = {"do": "change", "component": "O1", "sentence": "A car 25 m ahead brakes hard after 3 s."}
            return json.dumps({"kind": "edit", "changes": [change]})
        if asked_of(request) == "O1":
            return json.dumps(soon if "after 3 s" in said(request) else late)
        if asked_of(request) == "E":
            return json.dumps(ego)
        return json.dumps({} if asked_of(request) == "G" else {"kind": "road"} if asked_of(request) else components)

    server.respond = respond
    async with Engine(settings(server, seconds=12.0)) as engine:
        _, plain = await events_of(engine.generate(text))
        assert plain.ok and not any("Said, but not seen" in said(r) for r in server.requests)
        events, done = await events_of(engine.generate(text, improve=True))
        assert done.ok and done.structure["O1"].spec.phases[0].trigger.value == 3
        assert any(o.shows("brake_hard") for f in done.facts for o in f.objects)
        assert any("it now shows 100% of what is said" in n for n in notes(events))
        assert done.details["tokens"] > plain.details["tokens"]
        late = soon = {**soon, "phases": [{"action": "swerve"}]}  # now nothing that it changes can help
        server.requests.clear()
        events, kept = await events_of(engine.generate(text, improve=True))
        assert kept.ok and "100 seconds" in [u.text for u in kept.structure["O1"].unmet], "the first answer is kept"
        assert sum("Said, but not seen" in said(r) for r in server.requests) <= 2


@pytest.mark.full
async def test_prompted_ends_in_a_program_where_the_model_writes_nonsense(server):
    server.respond = Programmer(slips={"E": "ego = new Car at nowhere"}, repairs=False)
    async with Engine(settings(server)) as engine:
        events, done = await events_of(engine.generate(PROGRAMMED, method="prompted", run=False))
    assert done.ok, done.diagnostics
    assert any("rendered from the fields of S instead" in n for n in notes(events))
    assert done.details["share"] == 0 and {c.origin for c in done.structure.components} == {"rendered"}
