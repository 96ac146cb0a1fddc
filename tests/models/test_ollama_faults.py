"""What Ollama and its models are known to do to a form, each over HTTP: it ends in a valid form, or in one sentence.

The numbers are those of issues in Ollama's tracker.
"""

import json
import threading
from collections.abc import Callable
from typing import Any, NamedTuple

import pytest

from c2s_engine.interpret.llm import interpret
from c2s_engine.models.ways import CHAT, GENERATE, Way
from tests.models.answers import TEXT, sensible
from tests.models.fake_ollama import Answer, FakeOllama, Respond, said
from tests.models.test_llm_typed import plain

LOW, ON = Way(think="low"), Way(think=True)


def good(request: dict[str, Any]) -> str:
    """What a good model answers, the probe's question included."""
    return json.dumps({"colour": "red", "wheels": 4}) if "Which colour" in said(request) else sensible(request)


def way_of(request: dict[str, Any]) -> Way:
    return Way(endpoint=request["endpoint"], think=request.get("think", False))


def only(*ways: Way, otherwise: Callable[[dict[str, Any]], Answer | str]) -> Respond:
    """A good model in these ways, something else in the others."""
    return lambda request: good(request) if way_of(request) in ways else otherwise(request)


def wordy(request: dict[str, Any]) -> str:
    return "Drivers stop at red, and a car has four wheels."


def at_first_wrong(request: dict[str, Any]) -> str:
    """Fields and values that no schema allows, until told so."""
    if len(request["messages"]) > 2 or "Which colour" in said(request):
        return good(request)
    return json.dumps({"colour": "mauve", "kind": "place of no kind", "speed": 900})


class Case(NamedTuple):
    """How a model answers; the way in which forms are then asked for, or the sentence that is told instead."""

    respond: Respond
    way: Way | None = None
    sentence: str = ""
    settings: dict[str, Any] = {}  # noqa: RUF012


CASES = {
    "format is ignored with think=false (14645)": Case(only(GENERATE, LOW, ON, otherwise=wordy), GENERATE),
    "the form stands in thinking (12831)": Case(lambda r: Answer(thinking=good(r)), CHAT),
    "the form is wrapped in thoughts and a fence (15416)": Case(
        lambda r: f"<think>{{Hm}}</think>\n```json\n{good(r)}\n```", CHAT
    ),
    "values are outside the schema (8063)": Case(at_first_wrong, CHAT),
    "only think=low gives an answer": Case(only(LOW, otherwise=lambda r: Answer(thinking="Hm. " * 9)), LOW),
    "only thinking brings the form": Case(only(ON, otherwise=wordy), ON),
    "chat is refused": Case(only(GENERATE, otherwise=lambda r: Answer(status=400, error="no chat template")), GENERATE),
    "every request is refused": Case(
        lambda r: Answer(status=400, error="bad template"), sentence="Ollama refused the request for thinker (400): bad"
    ),
    "it breaks off in the middle": Case(
        lambda r: Answer(good(r), chunk=4, fault="cut"), sentence="broke off before its end"
    ),
    "it is cut by its length": Case(
        lambda r: Answer("lorem ipsum dolor", done_reason="length"), sentence="was cut after"
    ),
    "it is silent": Case(
        lambda r: Answer(good(r), after=0, hold=threading.Event()), sentence="sent nothing for 0.2 s",
        settings={"timeout": 0.2},
    ),
}  # fmt: skip


@pytest.fixture(autouse=True)
def _folders(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


@pytest.mark.parametrize("name", CASES)
async def test_a_fault_ends_in_a_valid_form_or_in_one_sentence(server, client_of, name):
    case = CASES[name]
    server.respond = case.respond
    async with client_of(server, model="thinker", probe=True, **case.settings) as client:
        reading = await interpret(TEXT, client=client, reader=plain)
        way = client.way
    assert reading.structure.objects, "there is always something to write"
    if case.way:
        assert way == case.way and reading.share == 1 and not reading.notes, reading.notes
        assert [o.spec.type for o in reading.structure.objects] == ["van", "truck", "pedestrian"]
        forms = [way_of(r) for r in server.requests if "Which colour" not in said(r)]
        assert set(forms) == {case.way}
    else:
        assert reading.share == 0 and len(reading.notes) == 1 and case.sentence in reading.notes[0], reading.notes
        assert "\n" not in reading.notes[0]


async def test_nobody_there_and_no_such_model_are_one_sentence(server, client_of):
    with FakeOllama() as gone:
        pass
    for client, sentence in (
        (client_of(gone, probe=True), "Ollama does not answer"),
        (client_of(server, model="absent", probe=True), "c2s models pull absent"),
    ):
        async with client:
            reading = await interpret(TEXT, client=client, reader=plain)
        assert reading.share == 0 and len(reading.notes) == 1 and sentence in reading.notes[0]
    assert not server.requests
