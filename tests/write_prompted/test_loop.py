"""Simulation in the loop: at most two rounds, and never worse than before."""

import json

import pytest

from c2s_engine.interpret.learned import learned
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.loop import Outcome, improve
from tests.models.answers import asked_of
from tests.models.backends import BAD
from tests.models.fake_ollama import said

S = Structure(
    text="A car ahead brakes hard.",
    objects=(Component(id="O1", description="A car ahead brakes hard after 30 s.", spec=ObjectSpec(name="lead")),),
)


def runs(*scores: float):
    """An evaluation with those scores in turn; what was evaluated is kept."""
    seen: list[Structure] = []

    async def evaluate(structure: Structure) -> Outcome:
        score = scores[len(seen)]
        seen.append(structure)
        return Outcome(structure, score, ["O1: said brake_hard, not seen"] if score < 1 else [])

    return evaluate, seen


def editor(request):
    if asked_of(request):
        trigger = {"kind": "time", "value": 3}
        return json.dumps({"name": "lead", "type": "car", "placement": {"position": "ahead"},
                           "phases": [{"action": "brake", "rate": 6, "trigger": trigger}]})  # fmt: skip
    assert "O1: said brake_hard, not seen" in said(request)
    change = {"do": "change", "component": "O1", "sentence": "A car ahead brakes hard after 3 s."}
    return json.dumps({"kind": "edit", "changes": [change]})


async def improved(server, client_of, evaluate):
    events: list = []
    async with client_of(server) as client:
        found = await improve(S, evaluate, client=client, reader=learned, on_event=events.append)
    return found, [e.text for e in events if e.type == "say"]


async def test_a_change_that_helps_is_kept(server, client_of):
    server.respond = editor
    evaluate, seen = runs(0.5, 1.0)
    found, notes = await improved(server, client_of, evaluate)
    assert found.score == 1 and found.structure["O1"].description.endswith("it brakes hard after 3 s.")
    assert len(seen) == 2 and found.structure["O1"].spec.phases[0].trigger.value == 3
    assert any("100%" in n for n in notes)


@pytest.mark.parametrize("second", [0.5, 0.2])
async def test_a_change_that_does_not_help_is_dropped(server, client_of, second):
    server.respond = editor
    evaluate, seen = runs(0.5, second)
    found, notes = await improved(server, client_of, evaluate)
    assert found.structure == S and found.score == 0.5 and len(seen) == 2
    assert any("dropped" in n for n in notes)


async def test_there_are_at_most_two_rounds(server, client_of):
    server.respond = editor
    evaluate, seen = runs(0.1, 0.2, 0.3, 0.4)
    found, _ = await improved(server, client_of, evaluate)
    assert len(seen) == 3 and found.score == 0.3


async def test_nothing_is_asked_where_nothing_is_missing(server, client_of):
    evaluate, _ = runs(1.0)
    assert (await improved(server, client_of, evaluate))[0].score == 1
    assert server.requests == []


@pytest.mark.parametrize("name", ["garbage", "empty", "busy", "refused"])
async def test_a_bad_model_changes_nothing(server, client_of, name):
    server.respond = BAD[name](0)
    evaluate, seen = runs(0.5, 0.9)
    found, notes = await improved(server, client_of, evaluate)
    assert found.structure == S and len(seen) == 1 and notes
