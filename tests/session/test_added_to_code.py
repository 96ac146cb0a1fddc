"""Who is added by chat to a program of somebody else's: it runs, and not a byte of that program is another."""

from pathlib import Path

import pytest

from c2s_engine import driving
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure.edits import Replace
from c2s_engine.structure.progress import Finished

PROGRAMS = {p.stem: p.read_text() for p in sorted((Path(__file__).parent / "programs").glob("*.scenic"))}
ADDED = [
    ("ego_alone", "add a parked van on the right 25 m ahead"),
    ("ego_alone", "add a cyclist who crosses from the right 30 m ahead"),
    ("ego_alone", "a truck comes towards ego in the oncoming lane"),
    ("ego_alone", "a motorcycle follows ego 15 m behind"),
    ("ego_alone", "a pedestrian steps out from behind a parked van"),
    ("names_of_its_own", "add a pedestrian who crosses from the right 40 m ahead"),
    ("names_of_its_own", "a car cuts in from the left lane 15 m ahead of ego"),
    ("names_of_its_own", "add a parked van on the right 25 m ahead of the bus"),
    ("two_walkers", "add a traffic cone 40 m ahead in ego's lane"),
]  # fmt: skip


async def last(events):
    found = [event async for event in events]
    assert isinstance(found[-1], Finished)
    return found[-1]


async def opened_and_told(engine, folder, program, *said):
    """The end of each turn in a session in which a program was opened first."""
    session = Sessions(folder).open("one", engine)
    try:
        await last(session.apply([Replace(structure=await engine.import_program(program))]))
        return [await last(session.say(text)) for text in said]
    finally:
        session.close()


def lines_kept(before, after):
    """Whether all lines of a text are in another, in their order."""
    rest = iter(after.splitlines())
    return all(line in rest for line in before.splitlines())


@pytest.mark.parametrize(("name", "said"), ADDED)
async def test_who_is_added_to_a_program_of_somebody_elses_runs_in_it(engine, tmp_path, name, said):
    (done,) = await opened_and_told(engine, tmp_path, PROGRAMS[name], said)
    assert {s.name: s.ok for s in done.stages}["run"], done.diagnostics
    assert lines_kept(PROGRAMS[name], done.program.text)
    assert len(done.facts[0].objects) > PROGRAMS[name].count(" = new ") - PROGRAMS[name].count("OrientedPoint")


async def test_a_second_one_goes_by_the_names_that_are_there_by_then(engine, tmp_path):
    said = (
        "add a parked van on the right 25 m ahead of the bus",
        "add a pedestrian who crosses from the right 70 m ahead",
        "remove the van",
    )
    _, two, rest = await opened_and_told(engine, tmp_path, PROGRAMS["names_of_its_own"], *said)
    assert two.program.text.count("place = place_of(ego)") == 1
    assert "Van" not in rest.program.text and rest.program.text.count("place = place_of(ego)") == 1
    assert all(s.ok for done in (two, rest) for s in done.stages)


async def test_names_of_the_library_that_mean_something_else_are_others_in_one_file_too(engine, tmp_path):
    said = "add a pedestrian who crosses from the right 40 m ahead"
    (done,) = await opened_and_told(engine, tmp_path, PROGRAMS["names_of_its_own"], said)
    assert "gap as c2s_gap" in done.program.text
    alone = driving.inlined(done.program.text)
    assert driving.MODULE not in alone.replace(driving.FILE, "") and "def c2s_gap(" in alone
    report = await engine.check(alone, upto="run", map="town")
    assert report.ok, [d for stage in report.stages for d in stage.diagnostics]
    assert len(report.facts[0].objects) == 3


async def test_a_program_with_ego_alone_is_not_replaced_by_a_description_of_another(engine, tmp_path):
    (done,) = await opened_and_told(engine, tmp_path, PROGRAMS["ego_alone"], "Heavy rain at night.")
    assert lines_kept(PROGRAMS["ego_alone"], done.program.text) and "param weather" in done.program.text
