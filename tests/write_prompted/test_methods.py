"""Methods by name: baselines with and without a model, mixed, and what is said where a model is missing."""

import json
import re

import pytest

from c2s_engine import paths
from c2s_engine.interpret.learned import learned
from c2s_engine.models import ModelSettings, OllamaClient, errors
from c2s_engine.session.places import resolve
from c2s_engine.structure.components import Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Passage, Say
from c2s_engine.structure.regenerate import dirty
from c2s_engine.structure.specs import EgoSpec
from c2s_engine.write.baselines import NL2Scenic
from c2s_engine.write.baselines.nl2scenic import taken_apart
from c2s_engine.write.methods import MethodTools, UnknownMethod, method, names, needs_model
from c2s_engine.write.prompted.examples import examples
from tests.models.answers import COMPONENTS, FORMS, TEXT, asked_of
from tests.models.backends import BAD
from tests.models.fake_ollama import Answer, said
from tests.write_prompted.programmer import Library, asked_for

LEFT_TURN = "Ego turns left at an intersection while an oncoming car goes straight over it."


class Shelf:
    """The shipped snippets, found by words in common (the real retriever needs its worker): as there, each by the
    nearest of its description and paraphrases."""

    def __init__(self) -> None:
        self.rows = []
        for path in sorted(paths.shipped("snippets").glob("*/*.scenic")):
            head, _, code = path.read_text(encoding="utf-8").partition("# ---\n")
            title = re.search(r"# description: (.*)", head)[1]
            told = [_words(t) for t in (title, *re.findall(r"#   - (.*)", head))]
            self.rows.append((path.parent.name, title, told, code))

    async def __call__(
        self, query: str, kind: str, component: str | None, limit: int, terms: tuple[str, ...] = ()
    ) -> list[Passage]:
        wanted = _words(query)
        near = [
            (max(len(wanted & words) / len(wanted | words) for words in told), title, code)
            for c, title, told, code in self.rows
            if c == component
        ]
        best = sorted(near, reverse=True)[:limit]
        return [Passage(kind="snippet", title=t, text=c, score=s, component=component or "") for s, t, c in best]


def _words(text: str) -> set[str]:
    return set(re.findall(r"[a-z]{3,}", text.lower()))


def tools(client=None, **more) -> MethodTools:
    return MethodTools(reader=learned, client=client, **more)


async def program_of(name: str, text: str, given: MethodTools):
    found = method(name, given)
    structure = await found.write((await found.interpret(text)).structure)
    return structure, assemble(structure)


def test_every_name_makes_a_method():
    client = OllamaClient(ModelSettings(model="small", host="http://127.0.0.1:9"))
    given = tools(client, search=Library())
    assert len(names()) == 20
    for name in [*names(), "nl2scenic", "chat2scenic:C1+repair"]:
        assert method(name, given).name
    for name in ("chat2scenic:C13", "reader+repair", "magic", "nl2scenic:many"):
        with pytest.raises(UnknownMethod, match="chat2scenic:C11"):
            method(name, given)


def test_without_a_model_only_those_that_need_none():
    for name in names():
        if needs_model(name):
            with pytest.raises(errors.ModelNotSet):
                method(name, tools(search=Library()))
        else:
            assert method(name, tools(search=Library()))


async def test_chatscene_without_a_model_takes_the_nearest_snippets_as_they_are(checker):
    text = "On a straight road the car ahead of ego brakes hard."  # whose snippets rest on the same names
    structure, program = await program_of("chatscene", text, tools(search=Shelf()))
    assert [c.id for c in structure.components if c.code] == ["G", "R", "E", "O1"]
    codes = {code.strip() for _, _, _, code in Shelf().rows}
    for cid in ("R", "E", "O1"):
        assert structure[cid].code.split("\n", 1)[1].strip() in codes
        assert structure[cid].links[-1].kind == "snippet"
    report = await checker(program.text, program.spans)
    assert report.stages[0].name == "parse" and report.stages[0].ok


async def test_chatscene_with_a_model_extracts_one_adversary(server, client_of, checker):
    extract = {
        "adversary": "A car.",
        "behavior": "It goes straight over the intersection.",
        "geometry": "A crossroads with the lane of the opposite approach at hand.",
        "position": "On the opposite approach.",
    }
    server.respond = lambda request: json.dumps(extract)
    async with client_of(server) as client:
        structure, program = await program_of("chatscene", LEFT_TURN, tools(client, search=Shelf()))
        assert client.ledger.total().calls == 1
    assert structure.place.description == extract["geometry"] and len(structure.objects) == 1
    assert structure["O1"].description == "A car. It goes straight over the intersection. On the opposite approach."
    assert "\nego = new " in program.text and structure["O1"].links[-1].kind == "snippet"
    assert (await checker(program.text, program.spans, "parse")).ok


@pytest.mark.parametrize("variant", ["zero", "few", "cot"])
async def test_nl2scenic_is_one_prompt_for_the_whole_program(server, client_of, checker, variant):
    example = examples()["03"]
    server.respond = lambda request: f"Plan: ...\n```scenic\n{example.text}\n```"
    async with client_of(server, num_ctx=16384) as client:
        structure, program = await program_of(f"nl2scenic:{variant}", example.description, tools(client))
    assert len(server.requests) == 1
    prompt = said(server.requests[0])
    assert prompt.count("```scenic\n## G") == (0 if variant == "zero" else 3)
    assert ("plan in numbered notes" in prompt) == (variant == "cot")
    assert structure.ids == ("G", "R", "E", "O1", "T")
    assert (await checker(program.text, program.spans)).ok


async def test_nl2scenic_shows_the_nearest_programs(server, client_of):
    async def embed(texts):
        return [[float("motorcycle" in t.lower()), 1.0] for t in texts]

    async with client_of(server) as client:
        assert (await NL2Scenic(client, embed).nearest("A motorcycle overtakes."))[0].number == "08"
        assert (await NL2Scenic(client).nearest(examples()["07"].description))[0].number == "07"


@pytest.mark.parametrize(
    "program",
    [
        "ego = new Car\n",
        "## R: A lane.\nx = 1\n## E: Ego.\nego = new Car\n",
        "## G: h\na = 1\n## E: Ego.\nego = new Car\n",
    ],
)
def test_a_program_without_whole_borders_is_one_fragment(program):
    structure = taken_apart(Structure(text="x"), program)
    assert [c.id for c in structure.components if c.code] == ["E"]
    assert program.strip() in assemble(structure).text
    assert isinstance(structure.ego.spec, EgoSpec)


async def mixed(server, client_of, checker, generated, name="mixed"):
    """The typed program of TEXT with the van's form leaving something unmet; `generated` makes code of the rendered."""
    forms = {**FORMS, "O1": {**FORMS["O1"], "unmet": "its hazard lights flash"}}

    def forms_only(request):
        cid = asked_of(request)
        return json.dumps(forms[cid] if cid else COMPONENTS)

    async def resolved(structure):
        from c2s_engine.maps.library import MapLibrary

        return (await resolve(structure, MapLibrary(), checker)).writer

    server.respond = forms_only
    events: list = []
    async with client_of(server, num_ctx=16384) as client:
        reading = await method("typed", tools(client)).interpret(TEXT)
        writer = await resolved(reading.structure)
        given = tools(client, search=Library(), check=checker, writer=writer)
        rendered = await method("typed", given).write(reading.structure)
        answer = generated(rendered["O1"].code)
        server.respond = lambda r: answer if asked_for(r).endswith("O1") else forms_only(r)
        structure = await method(name, given).write(reading.structure, events.append)
    return rendered, structure, writer, [e.text for e in events if isinstance(e, Say)]


async def test_mixed_writes_what_is_unmet_and_keeps_the_rest(server, client_of, checker):
    rendered, structure, writer, _ = await mixed(
        server, client_of, checker, lambda code: f"```scenic\n{code}HAZARD = True\n```"
    )
    assert rendered["O1"].unmet and rendered["O1"].origin == "rendered"
    assert structure["O1"].origin == "generated" and "HAZARD = True" in structure["O1"].code
    assert structure["O1"].unmet == () and structure["O1"].description == rendered["O1"].description
    others = [c for c in rendered.ids if c != "O1"]
    assert [structure[c].code for c in others] == [rendered[c].code for c in others]
    assert dirty(structure, writer) == [], "it is not rendered over at the next turn"
    assert any("hazard lights flash" in said(r) and asked_for(r) == "O1" for r in server.requests)
    program = assemble(structure)
    assert (await checker(program.text, program.spans)).ok


@pytest.mark.parametrize(
    "answer",
    [
        "```scenic\nx = 1\n```",
        *(
            pytest.param(a, marks=pytest.mark.full)
            for a in ("no", "```scenic\nvan = new Nothing\n```", Answer(status=503))
        ),
    ],
)
async def test_mixed_keeps_what_was_rendered_where_the_model_fails(server, client_of, checker, answer):
    rendered, structure, _, notes = await mixed(server, client_of, checker, lambda code: answer)
    assert structure == rendered and structure["O1"].unmet
    assert any("O1" in note for note in notes)


@pytest.mark.parametrize("name", ["garbage", "empty"])
async def test_bad_models_and_whole_programs(server, client_of, name):
    server.respond = BAD[name](0)
    async with client_of(server, num_ctx=16384) as client:
        with pytest.raises(errors.AnswerUnusable):
            await program_of("nl2scenic", TEXT, tools(client))
