"""What a description rests on when it is picked from an answer, answers to "why is this here?", offers."""

import pytest

from c2s_engine.paths import shipped
from c2s_engine.retrieve.blocks import chunks
from c2s_engine.retrieve.markdown import read_markdown
from c2s_engine.session.citing import description_of, resting_on, source_of, tells_scenario, uncited, wanted
from c2s_engine.session.offers import snippets
from c2s_engine.session.why import explained
from c2s_engine.structure.components import Assumption, Component, Link, Structure, Unmet
from c2s_engine.structure.progress import Passage
from c2s_engine.structure.specs import ObjectSpec, Phase, Placement
from c2s_engine.write.prompted.influence import sources

TITLE = "UN Regulation No. 157: Automated Lane Keeping Systems (ALKS) › Test: cut-in (Annex 5, 4.4)"
TOLD = Passage(kind="doc", title=TITLE, clause="Annex 5, 4.4", score=0.9,
               text="Scenario: Ego drives on a motorway. A car cuts in.\n\nPurpose: to show it.")  # fmt: skip
REST = TOLD.model_copy(update={"text": "Pass criterion: no contact.\n\nIn other words: no crash."})


@pytest.mark.parametrize(
    ("text", "number"),
    [("use 2", 2), ("Use 2.", 2), ("take the first", 1), ("pick number 3", 3), ("use the second one", 2),
     ("use a truck", None), ("use 2 trucks", None), ("the lead should use 2 lanes", None), ("2", None)],
)  # fmt: skip
def test_which_result_a_turn_picks(text, number):
    assert wanted(text) == number


def test_a_passage_becomes_its_scenario_with_its_source():
    assert source_of(TOLD) == "UN R157, Annex 5, 4.4"
    assert description_of(TOLD) == "[UN R157, Annex 5, 4.4] Ego drives on a motorway. A car cuts in."
    assert description_of(REST, [TOLD]) == description_of(TOLD), "another chunk of its section tells it"
    assert description_of(REST) == "[UN R157, Annex 5, 4.4] Pass criterion: no contact."
    assert tells_scenario(TOLD) and not tells_scenario(REST)


def test_the_source_is_hidden_from_interpreters_and_linked():
    text = "[UN R157, 5.2] A car cuts in."
    plain, source = uncited(text)
    assert len(plain) == len(text) and plain.strip() == "A car cuts in." and source == "UN R157, 5.2"
    assert uncited("A car [red] cuts in.") == ("A car [red] cuts in.", "")
    assert uncited("[only a bracket]") == ("[only a bracket]", "")
    structure = resting_on(Structure(text=plain), source, text)
    assert structure.text == text and {c.links[-1] for c in structure.components} == {Link(kind="clause", label=source)}
    assert resting_on(Structure(), "", "x").ego.links == ()


def test_every_test_of_the_regulations_tells_a_scenario():
    for name in ("un_r152", "un_r157", "un_r171"):
        text = shipped("docs", f"{name}.md").read_text()
        found = chunks(read_markdown(text), name)
        tests = {c.path[-1] for c in found if c.path[-1].startswith("Test: ")}
        told = {c.path[-1] for c in found if c.text.startswith("Scenario: ")}
        assert tests and tests <= told, tests - told


VAN = Component(
    id="O2", description="A van is parked.", origin="rendered", code="van = 1\n",
    spec=ObjectSpec(
        name="van", type="van", placement=Placement(position="parked"), phases=(Phase(action="stationary"),)
    ),
    links=(Link(kind="text", label="parked van", span=(0, 10)), Link(kind="clause", label="UN R157, 5.3")),
    assumed=(Assumption(field="speed", value="0", reason="it is parked"),),
)  # fmt: skip


def test_why_names_words_sources_and_the_rule():
    structure = Structure(objects=(Component(id="O1", description="A car.", spec=ObjectSpec(), code="x = 1\n"), VAN))
    said = explained("Why is the van here?", structure)
    assert said == explained("why is O2 there", structure)
    assert "O2 rests on your words “parked van”; the source “UN R157, 5.3”." in said
    assert "rules for type van, placement parked, phases stationary" in said and "speed = 0 (it is parked)" in said
    assert "O1" not in said and "O1" in explained("why is all this here?", structure)
    assert explained("why is a cut-in dangerous?", structure) == ""
    assert explained("what is O2?", structure) == "" and explained("why is the van here?", Structure()) == ""
    generated = VAN.model_copy(update={"origin": "generated"})
    assert "no retrieved passage shows in it" in explained("why O2", structure.with_component(generated))


def test_only_passages_that_show_in_the_code_are_its_sources():
    code = "## O1: A van.\nvanSpot = new OrientedPoint ahead of ego by 31\nvan = new Van at vanSpot\n"
    snippet = Passage(kind="snippet", title="A van.", score=1, text="vanSpot = new OrientedPoint ahead of ego by 20")
    other = Passage(kind="snippet", title="A bus.", score=1, text="bus = new Bus at busSpot, with behavior Waits()")
    doc = Passage(kind="doc", title="Points", clause="3.1", score=1, text="An OrientedPoint has a heading.")
    far = Passage(kind="doc", title="Monitors", score=1, text="A TrafficMonitor watches.")
    found = [(k.kind, k.label) for k in sources([snippet, other, doc, far], code)]
    assert found == [("snippet", "A van."), ("chunk", "Points (3.1)")]


class Shelf:
    """A retriever with one snippet that says what was looked for."""

    asked = ()

    async def ready(self, progress):
        progress("reading", 0, 1)

    async def search(self, query, kind, component, limit):
        self.asked += ((query, component),)
        return [Passage(kind=kind, title=f"{component}: {query}", text="x = 1", score=0.5, component=component or "")]


async def test_snippets_near_to_what_has_no_field():
    lights, horn = Unmet(text="its hazard lights flash", reason="no field"), Unmet(text="honks twice", reason="unknown")
    value = Unmet(text="40 m", reason="no field of S has the value 40 m")
    structure = Structure(objects=(VAN.model_copy(update={"unmet": (lights,)}),), not_understood=(horn, value))
    found = await snippets(structure, Shelf())
    assert [(cid, words, [p.title for p in near]) for cid, words, near in found] == [
        ("O2", "its hazard lights flash", ["O: its hazard lights flash"]), ("", "honks twice", ["None: honks twice"]),
    ]  # fmt: skip
    shelf = Shelf()
    assert await snippets(Structure(), shelf) == [] and shelf.asked == (), "nothing is looked for without need"
