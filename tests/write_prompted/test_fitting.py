"""What a generator is shown: retrieved code in the names at hand, what is written later, what was tried."""

import json
from types import SimpleNamespace

import pytest

from c2s_engine import paths
from c2s_engine.interpret.learned import learned
from c2s_engine.retrieve.terms import terms_of
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.progress import Passage
from c2s_engine.structure.specs import ObjectSpec, Phase, SettingsSpec, Trigger
from c2s_engine.write.prompted import PromptedMethod, header
from c2s_engine.write.prompted.checking import Verdict, with_code
from c2s_engine.write.prompted.configuration import configuration
from c2s_engine.write.prompted.examples import examples
from c2s_engine.write.prompted.fitting import fitted
from c2s_engine.write.prompted.header import Ground, settings_text
from c2s_engine.write.prompted.method import USUAL_END
from c2s_engine.write.prompted.prompt import generator_question, repair_question
from tests.write_prompted.programmer import EXAMPLE, TEXT, Library, Programmer, asked_for


def snippets(kind: str) -> list[Passage]:
    rows = sorted(paths.shipped("snippets", kind).glob("*.scenic"))
    code = [(f.stem, f.read_text(encoding="utf-8").partition("# ---\n")[2]) for f in rows]
    return [Passage(kind="snippet", title=t, text=c, score=1, component=kind) for t, c in code]


@pytest.mark.parametrize(
    ("before", "code", "shown"),
    [
        ("start = new OrientedPoint on lane.centerline", "ego = new Car at egoSpot", "ego = new Car at start"),
        ("lane = network.lanes[0]", "x = new Car on egoLane.centerline", "x = new Car on lane.centerline"),
        ("lane = network.lanes[0]", "x = new Car on oncomingLane.centerline", None),
        ("a, egoLane = pair[0], pair[1]", "x = new Car on egoLane", "x = new Car on egoLane"),
        ("p = new OrientedPoint on l\nq = new OrientedPoint on l", "ego = new Car at egoSpot", None),
        ("lane = network.lanes[0]", "egoSpot = new OrientedPoint on lane\nego = new Car at egoSpot", "as it is"),
        (
            "lane = network.lanes[0]",
            "behavior B(egoLane):\n    do FollowLaneBehavior(laneToFollow=egoLane)",
            "as it is",
        ),
    ],
)
def test_names_that_are_not_there_are_renamed_or_the_passage_left_out(before, code, shown):
    passage = Passage(kind="snippet", title="x", text=code, score=1, component="O")
    found = [p.text for p in fitted([passage], before)]
    assert found == ([] if shown is None else [code if shown == "as it is" else shown])


@pytest.mark.parametrize(("kind", "every"), [("E", 12), ("O", 24), pytest.param("O", 2, marks=pytest.mark.full)])
def test_what_is_shown_compiles_after_the_code_so_far(checker, kind, every):
    example = examples()["04"]
    before = example.before(example.of_kind(kind).id)
    found = fitted(snippets(kind), before)
    assert len(found) > 30, "most of the collection fits an ordinary place"
    for passage in found[::every]:
        report = checker.check(f"{example.fragments[0].code}\n\n{before}\n\n{passage.text}", upto="compile")
        assert report.ok, (passage.title, [d.message for s in report.stages for d in s.diagnostics])


RUNS_RED = ObjectSpec(name="van", type="van", phases=(Phase(action="run_red"),))


def structure(**parts) -> Structure:
    objects = (Component(id="O1", description="A van runs its red light.", spec=RUNS_RED),)
    return Structure(text="x", objects=objects, **parts)


def test_who_runs_a_red_light_gives_ego_a_green_one():
    s = structure()
    assert "the traffic light that ego faces: 'green'" in settings_text(s, Ground())
    assert not header.is_default_header(s) and header.is_default_header(Structure(text="x"))
    red = s.with_component(s.settings.model_copy(update={"spec": SettingsSpec(light="red")}))
    assert "ego faces: 'red'" in settings_text(red, Ground()), "what is told stands"


def test_what_is_written_later_is_not_to_be_named():
    s = structure()
    told = generator_question(s, "E", configuration("C1")).messages[1].content
    assert "do not name them here: O1." in told and "withinDistanceToAnyObjs" in told
    assert "do not name them" not in generator_question(s, "O1", configuration("C1")).messages[1].content


def test_a_repair_remembers_what_was_tried_and_sees_what_the_others_say():
    s = structure()
    finding = Diagnostic(stage="compile", message="the name 'lane1' is not defined", line=1)
    tried = Verdict("van = new Van on lane1", 2, finding)
    first = repair_question(s, "E", tried, [], None, configuration("C11")).messages
    again = repair_question(s, "E", Verdict("van = new Van on lane2", 2, finding), [tried], None, configuration("C11"))
    told = again.messages[1].content
    assert "van = new Van on lane1" in told and "The finding is still the same" in told
    assert "Tried before" not in first[1].content and "- O1: A van runs its red light." in first[1].content


def test_a_repair_lists_only_what_of_the_network_it_is_about():
    s = structure()
    finding = Diagnostic(stage="compile", message="an object of kind LaneSection has no 'lane'", line=1)
    asked = repair_question(s, "R", Verdict("x = network.laneSections", 2, finding), [], None, configuration("C11"))
    system = asked.messages[0].content
    whole = generator_question(s, "R", configuration("C4")).messages[0].content
    assert "- LaneSection:" in system and "- PedestrianCrossing:" not in system and "- PedestrianCrossing:" in whole


async def test_nothing_said_is_not_asked_for(server, client_of, checker):
    programmer = Programmer()

    def respond(request):
        if not asked_for(request) and "confidence" in str(request["messages"]):
            return "{}"
        if not asked_for(request):
            form = {**programmer._form(request), "settings": "", "restrictions": ""}
            return json.dumps(form)
        return programmer(request)

    server.respond = respond
    async with client_of(server, num_ctx=16384) as client:
        s = await PromptedMethod("C1", client).generate(TEXT)
    asked = [asked_for(r) for r in server.requests]
    assert "G" not in asked and "T" not in asked and "E" in asked
    assert s.restrictions.code.endswith(f"{USUAL_END}\n") and "EGO_MODEL" in s.settings.code
    assert {s.settings.origin, s.restrictions.origin} == {"rendered"}
    report = await checker(f"{s.settings.code}\n{EXAMPLE.before('T')}\n{s.restrictions.code}", ())
    assert report.ok, [d.message for stage in report.stages for d in stage.diagnostics]


async def test_an_untold_place_is_sought_by_what_the_others_tell(server, client_of):
    server.respond = Programmer()
    library = Library()
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C3", client, library)
        s = await method.interpret(TEXT)
        s = s.with_component(s.place.model_copy(update={"description": ""}))
        await method.write_component(s, "R")
    assert library.asked[-1][0] == " ".join(c.description for c in (s.ego, *s.objects))[:400]
    assert library.about[library.asked[-1][0]] == (), "without the learned reader nothing else is known"


async def test_snippets_are_sought_by_what_a_component_is_and_does(server, client_of):
    server.respond = Programmer()
    library = Library()
    async with client_of(server, num_ctx=16384) as client:
        method = PromptedMethod("C3", client, library, reader=learned)
        s = await method.interpret(TEXT)
        await method.write_component(s, "O1")
    assert library.about[s["O1"].description] == terms_of(s, "O1") != ()


async def test_who_reacts_to_another_is_written_after_it(server, client_of):
    def reader(text):
        waits = Phase(action="brake", trigger=Trigger(kind="action", of="O2", action="cross_road"))
        first = ObjectSpec(name="van", type="van", phases=(waits,))
        second = ObjectSpec(name="pedestrian", type="pedestrian")
        objects = (Component(id="O1", spec=first), Component(id="O2", spec=second))
        return SimpleNamespace(structure=Structure(text=text, objects=objects))

    server.respond = Programmer()
    async with client_of(server, num_ctx=16384) as client:
        s = await PromptedMethod("C1", client, reader=reader).interpret(TEXT)
    assert [o.id for o in s.objects] == ["O2", "O1"]


def test_the_marks_of_a_generated_fragment_stay():
    assert with_code(Component(id="O1", spec=ObjectSpec()), "x = 1").origin == "generated"
