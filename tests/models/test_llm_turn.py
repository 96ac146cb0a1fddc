"""Turns with a model: questions, edits, new scenarios; with a bad model, the routing without a model."""

import json

import pytest

from c2s_engine.interpret import turn as plain_turn
from c2s_engine.interpret.learned import learned
from c2s_engine.interpret.llm.schema import accepts
from c2s_engine.interpret.llm.turn import route, turn_schema
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, RemoveObject, SetSpec, apply
from c2s_engine.structure.specs import ObjectSpec, Placement, RestrictionsSpec, SettingsSpec
from tests.models.answers import asked_of
from tests.models.backends import BAD, BAD_NAMES, random_json
from tests.models.fake_ollama import FakeOllama

S = Structure(
    text="A car brakes ahead of ego in the rain; a pedestrian hidden by a van crosses.",
    settings=Component(id="G", description="It rains.", spec=SettingsSpec(weather=("rain",))),
    objects=(
        Component(
            id="O1", description="A car 20 m ahead brakes.", code="lead = 1\n", spec=ObjectSpec(name="lead", type="car")
        ),
        Component(id="O4", description="A van is parked.", spec=ObjectSpec(name="van", type="van")),
        Component(
            id="O3",
            description="A pedestrian hidden by the van crosses.",
            spec=ObjectSpec(name="walker", type="pedestrian", placement=Placement(hidden_by="O4")),
        ),
    ),
)


def model(turn: dict, **forms: dict):
    """Answers the turn, then the forms by the number that they are asked under."""

    def respond(request):
        cid = asked_of(request)
        return json.dumps(forms[cid] if cid else turn)

    return respond


async def ask(server, client_of, text, structure=S, events=None):
    async with client_of(server) as client:
        on_event = events.append if events is not None else None
        return await route(text, structure, client=client, reader=learned, on_event=on_event)


def after(turn) -> Structure:
    s = S
    for edit in turn.edits:
        s = apply(s, edit)
    return s


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ({"do": "change", "component": "O1"}, "changes[0] lacks sentence"),
        ({"do": "add", "sentence": "A van."}, "changes[0] lacks type"),
        ({"do": "remove"}, "changes[0] lacks component"),
        ({"do": "remove", "component": "O4", "sentence": "It goes."}, ""),
    ],
)
def test_the_schema_itself_asks_for_what_a_change_needs(change, fault):
    assert accepts(turn_schema(S), {"kind": "edit", "changes": [change]}) == fault


async def test_a_change_is_one_component_by_its_form(server, client_of):
    changes = [{"do": "change", "component": "O1", "sentence": "A truck 20 m ahead brakes."}]
    truck = {
        "name": "truck",
        "type": "truck",
        "placement": {"position": "ahead", "gap": 20},
        "phases": [{"action": "brake"}],
    }
    server.respond = model({"kind": "edit", "changes": changes}, O1=truck)
    found = await ask(server, client_of, "make the lead a truck")
    assert found.kind == "edit" and [type(e) for e in found.edits] == [SetSpec]
    s = after(found)
    assert s["O1"].spec.type == "truck" and s["O1"].spec.name == "lead", "others may use its name"
    assert s["O1"].description == "A truck ahead of ego in the same lane, 20 m away; it brakes.", "made from its fields"
    assert s["O1"].unmet == () and "truck" in found.reply
    assert s["O3"] == S["O3"] and s.settings == S.settings


async def test_numbers_with_gaps_are_kept(server, client_of):
    """The model sees O1, O2, O3; the structure has O1, O4, O3."""
    changes = [{"do": "change", "component": "O3", "sentence": "A child hidden by the van crosses."}]
    child = {"name": "c", "type": "child", "placement": {"position": "sidewalk", "side": "right", "hidden_by": "O2"}}
    server.respond = model({"kind": "edit", "changes": changes}, O3=child)
    s = after(await ask(server, client_of, "make it a child"))
    assert s["O3"].spec.type == "child" and s["O3"].spec.placement.hidden_by == "O4"


async def test_add_remove_and_settings(server, client_of):
    changes = [
        {"do": "remove", "component": "O3"},
        {"do": "change", "component": "G", "sentence": "It is foggy."},
        {"do": "add", "type": "bicycle", "sentence": "A cyclist rides behind ego."},
        {"do": "remove", "component": "T"},
    ]
    bike = {"name": "cyclist", "type": "bicycle", "placement": {"position": "behind", "gap": 10}}
    server.respond = model(
        {"kind": "edit", "changes": changes}, G={"weather": {"value": ["fog"], "confidence": 1}}, O3=bike
    )
    found = await ask(server, client_of, "no pedestrian, but fog and a cyclist behind us")
    assert [type(e) for e in found.edits] == [RemoveObject, SetSpec, AddObject, SetSpec]
    s = after(found)
    assert s.ids == ("G", "R", "E", "O1", "O4", "O5", "T")
    assert s.settings.spec.weather == ("fog",) and s["O5"].spec.type == "bicycle"
    assert s.restrictions.spec == RestrictionsSpec()


@pytest.mark.parametrize(("said", "kind"), [("question", "question"), ("new", "scenario"), ("undo", "undo")])
async def test_kinds(server, client_of, said, kind):
    server.respond = model({"kind": said})
    found = await ask(server, client_of, "hm, what about that thing there")
    assert found.kind == kind and found.edits == []


async def test_what_needs_no_model_asks_none(server, client_of):
    assert (await ask(server, client_of, "undo that")).kind == "undo"
    assert (await ask(server, client_of, "A car brakes ahead of ego.", structure=None)).kind == "scenario"
    assert server.requests == []


@pytest.mark.parametrize("name", BAD_NAMES)
async def test_a_bad_model_leaves_the_routing_without_a_model(server, client_of, name):
    server.respond = BAD[name](0)
    events = []
    found = await ask(server, client_of, "make the lead a truck", events=events)
    plain = plain_turn.route("make the lead a truck", S)
    assert (found.kind, found.edits) == (plain.kind, plain.edits)
    assert "without the model" in [e.text for e in events if e.type == "say"][0]


async def test_a_dead_server_leaves_the_routing_without_a_model(client_of):
    with FakeOllama() as gone:
        pass
    found = await ask(gone, client_of, "make the lead a truck")
    assert found.kind == "edit" and after(found)["O1"].spec.type == "truck"


async def test_removing_what_others_refer_to_is_left_to_the_routing_without_a_model(server, client_of):
    server.respond = model({"kind": "edit", "changes": [{"do": "remove", "component": "O4"}]})
    events = []
    await ask(server, client_of, "remove the van", events=events)
    assert any("O4 is referred to by O3" in e.text for e in events if e.type == "say")


@pytest.mark.parametrize("seed", [*range(3), *(pytest.param(i, marks=pytest.mark.full) for i in range(3, 30))])
async def test_random_turns_give_edits_that_can_be_made(server, client_of, seed):
    server.respond = random_json(seed)
    found = await ask(server, client_of, "make the lead a truck and let it rain")
    Structure.model_validate_json(after(found).model_dump_json())
