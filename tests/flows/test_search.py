"""What a search finds: read in full, with whose words they are, and used in the app."""

from c2s_engine.paths import shipped
from c2s_engine.retrieve.provenance import NOTES, attribution
from c2s_engine.structure.progress import Passage

R157 = shipped("docs", "un_r157.md").read_text().split("\n", 1)[0].removeprefix("# ")
CLAUSE = Passage(
    kind="doc", title=f"{R157} › Test: cut-in", clause="Annex 5, 4.4", source=R157, score=0.9,
    text="Scenario: Ego drives on a motorway. A car cuts in.\n" + "A long text. " * 40 + "\nIts last words.",
)  # fmt: skip
CODE = Passage(kind="snippet", title="A car that waits.", component="O", source="own", score=0.8,
               text="waiting = new Car ahead of ego by 20\n")  # fmt: skip


def test_notes_of_this_project_are_told_from_a_regulations_own_text():
    assert attribution(CLAUSE) == NOTES
    assert attribution(CLAUSE.model_copy(update={"source": "my own copy.pdf"})) == ""
    assert attribution(CLAUSE.model_copy(update={"clause": ""})) == "" and attribution(CODE) == ""


async def test_a_result_is_read_in_full_and_says_whose_words_it_is(stage):
    stage.engine.passages = [CLAUSE, CODE]
    async with stage.described() as pilot:
        await stage.say(pilot, "/search a car cuts in", wait=False)
        await stage.until(pilot, lambda: NOTES in "".join(str(s.content) for s in stage.bench.query("Sources")))
        await stage.say(pilot, "/read 3", wait=False)
        await stage.until(pilot, lambda: "Give a number: /read 1 to /read 2." in stage.said)
        await stage.say(pilot, "/read 1", wait=False)
        await stage.until(pilot, lambda: len(stage.app.screen_stack) == 3)
        body = str(stage.app.screen.body)
        assert "Its last words." in body and NOTES in body and "Annex 5, 4.4" in body


async def test_a_clause_becomes_the_description_and_code_a_components(stage):
    stage.engine.passages = [CLAUSE, CODE]
    async with stage.described() as pilot:
        await stage.say(pilot, "/search a car cuts in", wait=False)
        await stage.until(pilot, lambda: len(stage.bench.chat.passages) == 2)
        await stage.say(pilot, "/use 1", wait=False)
        await stage.until(pilot, lambda: stage.bench.chat.entry.text.startswith("[UN R157, Annex 5, 4.4] Ego drives"))
        await stage.say(pilot, "/use 2", wait=False)
        await stage.until(pilot, lambda: any("name the component (/use 2 O1)" in line for line in stage.said))
        await stage.say(pilot, "/use 2 O1")
        await stage.until(pilot, lambda: stage.bench.desk.structure["O1"].origin == "by_hand" and not stage.busy)
        assert CODE.text in stage.bench.desk.program.text
        await pilot.press("alt+z")
        await stage.until(pilot, lambda: CODE.text not in stage.bench.desk.program.text and not stage.busy)
