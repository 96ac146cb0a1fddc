"""A program that somebody opened or edited: byte for byte theirs, whatever is edited by hand or written anew."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, MoveObject, RemoveObject, SetProgram, apply
from c2s_engine.structure.layout import edited, merged
from c2s_engine.structure.program import assemble, run_limit
from c2s_engine.structure.specs import ObjectSpec

WRITTEN = {
    "G": "## G: Noon.\nparam map = 1\nmodel m", "R": "## R: A road.\nlane = 1", "E": "## E: It.\nego = new Car on lane",
    "O1": "## O1: A van.\nbehavior Slow():\n    wait\nvan = new Van, with behavior Slow()",
    "O2": "## O2: A bus.\nbus = new Bus", "T": "## T: None.\nterminate after 20 seconds",
}  # fmt: skip
LINES = st.sampled_from(
    ["", "# mine", "    # indented", "X = 3", '"""A text', 'of two lines"""', "van.speed = 4", "\t", "\r"]
)


def imported(*row: tuple[str, str]) -> Structure:
    structure = Structure(arrangement=row)
    for cid in dict.fromkeys(c for c, _ in row if c):
        code = "".join(t for c, t in row if c == cid)
        component = structure[cid].model_copy(update={"origin": "imported", "code": code})
        structure = structure.with_component(component)
    return structure


def written() -> Structure:
    objects = tuple(Component(id=cid, spec=ObjectSpec(name=cid.lower())) for cid in ("O1", "O2"))
    structure = Structure(objects=objects)
    for cid, code in WRITTEN.items():
        structure = structure.with_component(structure[cid].model_copy(update={"code": code, "key": "k"}))
    return structure


def order(structure: Structure) -> list[str]:
    return [s.component for s in assemble(structure).spans]


def anew(structure: Structure, cid: str, code: str) -> Structure:
    return structure.with_component(structure[cid].model_copy(update={"code": code, "origin": "rendered"}))


def test_a_place_written_anew_stands_after_the_world_model_and_before_who_reads_it():
    row = (
        ("G", "param map = 1\n"),
        ("E", "SPEED = 3\n"),
        ("G", "model m\n"),
        ("E", "ego = new Car\n"),
        ("R", "require x\n"),
    )
    structure = imported(*row)
    assert order(structure) == ["G", "E", "G", "E", "R"] and assemble(structure).text == "".join(t for _, t in row)
    assert order(anew(structure, "R", "lane = 1\n")) == ["G", "E", "G", "R", "E"]
    assert order(anew(anew(structure, "R", "lane = 1\n"), "G", "model m\n")) == ["G", "R", "E"]


def test_sessions_of_before_keep_the_places_of_their_parts():
    old = imported(("G", "a = 1\n"), ("E", "b = 1\n"), ("G", "c = 1\n")).model_dump(
        mode="json", exclude={"arrangement"}
    )
    old["settings"]["layout"], old["ego"]["layout"] = [[0, "a = 1\n"], [2, "c = 1\n"]], [[1, "b = 1\n"]]
    assert assemble(Structure.model_validate(old)).text == "a = 1\nb = 1\nc = 1\n"


def test_comments_between_components_are_nobodys():
    structure = written()
    text = "# Ours, 2026.\n\n" + assemble(structure).text.replace("## O2", "# the bus waits\n\n## O2") + "# end\n"
    after = edited(structure, text)
    assert assemble(after).text == text and {c.origin for c in after.components} == {"rendered"}
    new = anew(after, "O1", "## O1: A truck.\nvan = new Truck")
    assert assemble(new).text == text.replace(WRITTEN["O1"], "## O1: A truck.\nvan = new Truck")
    gone = apply(new, RemoveObject(component="O2"))
    assert "# the bus waits\n" in assemble(gone).text and "new Bus" not in assemble(gone).text
    assert "# the bus waits" in assemble(apply(new, MoveObject(component="O2", index=0))).text


def test_a_statement_between_components_is_the_one_befores():
    structure = written()
    text = assemble(structure).text.replace("## O2", "SPEED = 4\n\n## O2")
    after = edited(structure, text)
    assert assemble(after).text == text and after["O1"].origin == "by_hand" and "SPEED = 4" in after["O1"].code
    assert after["O2"].origin == "rendered"


@st.composite
def by_hand(draw, text: str) -> str:
    """A text with lines inserted, replaced or taken out at up to four places."""
    lines = text.split("\n")
    for _ in range(draw(st.integers(1, 4))):
        first = draw(st.integers(0, len(lines)))
        last = draw(st.integers(first, min(len(lines), first + 3)))
        lines[first:last] = draw(st.lists(LINES, max_size=3))
    return "\n".join(lines)


@settings(max_examples=300)
@given(st.data())
def test_what_is_edited_by_hand_is_there_byte_for_byte(data):
    structure = written()
    for _ in range(3):
        text = data.draw(by_hand(assemble(structure).text))
        structure = apply(structure, SetProgram(text=text))
        assert assemble(structure).text == text
        again = Structure.model_validate(structure.model_dump(mode="json"))
        assert assemble(again).text == text, "as a session keeps it"


@pytest.mark.full
@settings(max_examples=300)
@given(st.data())
def test_a_turn_changes_its_components_span_and_nothing_else(data):
    structure = written()
    for number in range(4):
        structure = apply(structure, SetProgram(text=data.draw(by_hand(assemble(structure).text))))
        before = assemble(structure).text.splitlines()
        ours = [c for c in structure.objects if c.origin == "rendered"]
        turn = data.draw(st.sampled_from(["add", "remove", "write"] if ours else ["add"]))
        if turn == "add":
            structure = apply(structure, AddObject(spec=ObjectSpec(name=f"new{number}")))
            code = f"## a new one\nnew{number} = new Car"
            structure, lost = anew(structure, structure.objects[-1].id, code), []
        else:
            chosen = data.draw(st.sampled_from(ours))
            lost = chosen.code.splitlines()
            structure = (
                apply(structure, RemoveObject(component=chosen.id))
                if turn == "remove"
                else anew(structure, chosen.id, f"## {chosen.id}: other\nother{number} = new Truck")
            )
        after = assemble(structure).text.splitlines()
        kept = [line for line in before if line.strip() and line not in lost]
        assert [line for line in after if line in kept] == kept or not set(kept) - set(after)
        assert [line for line in after if line.lstrip().startswith("# ")] == [
            line for line in before if line.lstrip().startswith("# ")
        ]


@given(st.data())
def test_both_changes_of_a_text_are_kept(data):
    base = "\n".join(f"line {i}" for i in range(12))
    mine = data.draw(by_hand(base))
    theirs = base.replace("line 3\n", "line 3 of theirs\n")
    both = merged(base, mine, theirs)
    assert merged(base, base, theirs) == theirs and merged(base, mine, base) == mine == merged(base, mine, mine)
    assert [line for line in mine.splitlines() if line not in base] == [
        line for line in both.splitlines() if line not in base and line != "line 3 of theirs"
    ]


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("ego = new Car\nterminate after 33 seconds\n", 33),
        ("terminate after 5 seconds\nterminate after 12.5 seconds", 12.5),
        ("# terminate after 33 seconds", 0),
        ("terminate when ego.speed < 1", 0),
        ("terminate after 99999 seconds", 600),
    ],
)
def test_a_program_says_how_long_it_runs(text, seconds):
    assert run_limit(text) == seconds
    assert run_limit(text, usual=20.0) == max(seconds, 20)
