"""A saved program is opened again with its S, what was changed in the file since as code by hand."""

import json

import pytest
import pytest_asyncio

from c2s_engine.commands.console import InputError, may_save
from c2s_engine.commands.reading import judged_by
from c2s_engine.commands.texts import imported
from c2s_engine.saving import beside, kept_beside, not_as_saved, save, taken
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.edits import Replace, SetProgram
from c2s_engine.structure.progress import Finished

TEXT = "Ego drives at 30 km/h in a city. A car ahead of ego at 50 km/h brakes hard. The light rain does not matter."


@pytest_asyncio.fixture(scope="module")
async def made(engine):
    return engine, await ended(engine.generate(TEXT, run=False))


async def ended(events):
    found = [event async for event in events]
    assert isinstance(found[-1], Finished)
    return found[-1]


async def reopened(engine, file, tmp_path):
    sessions = Sessions(tmp_path / "sessions")
    opened = sessions.open("again", engine)
    await ended(opened.apply(taken(file, file.read_text()), run=False))
    opened.close()
    sessions.close()
    return opened


async def test_it_comes_back_whole(made, tmp_path):
    engine, done = made
    file = tmp_path / "a.scenic"
    assert beside(file) in save(done.program, [], file, structure=done.structure)
    assert taken(file, file.read_text()) == [Replace(structure=done.structure)]
    session = await reopened(engine, file, tmp_path)
    assert session.structure == done.structure and session.program.text == file.read_text()


async def test_what_was_changed_in_the_file_is_code_by_hand(made, tmp_path):
    engine, done = made
    file = tmp_path / "a.scenic"
    save(done.program, [], file, structure=done.structure)
    text = file.read_text().replace("EGO_SPEED = 8.33", "EGO_SPEED = 5").replace("\nthe_car = ", "\n# mine\nthe_car = ")
    file.write_text(text)
    session = await reopened(engine, file, tmp_path)
    assert session.structure["E"].spec.speed == pytest.approx(5)
    lead = session.structure["O1"]
    assert lead.origin == "by_hand" and "# mine" in lead.code and lead.spec == done.structure["O1"].spec


@pytest.mark.full
async def test_a_standalone_program_comes_back_whole_too(made, tmp_path):
    engine, done = made
    file = tmp_path / "alone.scenic"
    assert beside(file) in save(done.program, [], file, standalone=True, structure=done.structure)
    text = file.read_text()
    assert "import *" not in text and taken(file, text) == [Replace(structure=done.structure), SetProgram(text=text)]
    session = await reopened(engine, file, tmp_path)
    assert session.program.text == text
    assert all(session.structure[c.id].spec == c.spec for c in done.structure.components)


async def test_a_file_is_judged_by_the_s_that_was_saved_with_it(made, tmp_path):
    engine, done = made
    file = tmp_path / "a.scenic"
    save(done.program, [], file, structure=done.structure)
    structure, program, words = await judged_by(engine, file.read_text(), file)
    assert (structure, program.spans, words) == (
        done.structure, done.program.spans, "Judged by the S in a.s.json, saved with the program.",
    )  # fmt: skip
    text = file.read_text().replace("EGO_SPEED = 8.33", "EGO_SPEED = 5")
    structure, program, words = await judged_by(engine, text, file)
    assert structure.ego.spec.speed == pytest.approx(5) and structure.text == TEXT
    assert (program.text, program.spans) == (text, done.program.spans)
    assert words == "Judged by the S in a.s.json, and what was changed in a.scenic since."
    beside(file).unlink()
    structure, program, words = await judged_by(engine, text, file)
    assert not structure.text and words == "Judged by what is recognised in the program."


async def test_an_import_has_the_components_that_were_saved_with_the_program(made, tmp_path):
    engine, done = made
    file = tmp_path / "a.scenic"
    save(done.program, [], file, structure=done.structure)
    found, whose = await imported(engine, file.read_text(), file)
    assert (found.structure, whose) == (done.structure, "a.s.json")
    text = file.read_text().replace("EGO_SPEED = 8.33", "EGO_SPEED = 5")
    found, whose = await imported(engine, text, file)
    assert found.structure.ego.spec.speed == pytest.approx(5) and whose == ""
    found, whose = await imported(engine, "model scenic.simulators.carla.model\nego = new Car\n", file)
    assert whose == "" and found.structure.text == ""


async def test_an_s_of_another_program_or_none_is_left_alone(made, tmp_path):
    _, done = made
    file = tmp_path / "a.scenic"
    save(done.program, [], file, structure=done.structure)
    assert taken(file, "model scenic.simulators.carla.model\nego = new Car\n") == []
    for broken in ("", "{}", json.dumps({"format": "c2s structure 1", "structure": {"ego": 3}}), "[]"):
        beside(file).write_text(broken)
        assert taken(file, done.program.text) == []
    assert taken(tmp_path / "b.scenic", done.program.text) == []


async def test_a_small_change_leaves_the_s(made, tmp_path):
    _, done = made
    file = tmp_path / "a.scenic"
    save(done.program, [], file, structure=done.structure)
    assert taken(file, done.program.text + "# end\n")[1:] == [SetProgram(text=done.program.text + "# end\n")]


async def test_what_lies_beside_is_never_replaced(made, tmp_path):
    engine, done = made
    library, map_file = tmp_path / "c2s_driving.scenic", tmp_path / "town.xodr"
    library.write_text("# MY OWN\n")
    map_file.write_text("mine")
    folders = [done.details["folder"]]
    save(done.program, folders, tmp_path / "a.scenic", structure=done.structure)
    assert (library.read_text(), map_file.read_text()) == ("# MY OWN\n", "mine")
    assert kept_beside(done.program, folders, tmp_path / "a.scenic") == ["town.xodr", "c2s_driving.scenic"]
    (tmp_path / "new").mkdir()
    save(done.program, folders, tmp_path / "new" / "a.scenic", structure=done.structure)
    assert not kept_beside(done.program, folders, tmp_path / "new" / "a.scenic")


async def test_a_file_is_as_it_was_saved_until_somebody_changes_it(made, tmp_path):
    engine, done = made
    file = tmp_path / "a.scenic"
    assert not not_as_saved(file)
    for standalone in (False, True):
        save(done.program, [], file, standalone=standalone, structure=done.structure)
        assert not not_as_saved(file)
    file.write_text(file.read_text() + "# mine\n")
    assert not_as_saved(file)
    may_save(tmp_path / "b.scenic")
    with pytest.raises(InputError, match="a.scenic is there already and is not as c2s saved it"):
        may_save(file)
