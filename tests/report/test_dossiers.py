"""Dossiers of texts, programs and broken runs."""

import json
from pathlib import Path

import pytest

from c2s_engine.api import Engine
from c2s_engine.report.dossier import dossier
from c2s_engine.report.gather import TextRecord, of_program, of_session, of_text, read_records
from c2s_engine.report.material import ReportError
from c2s_engine.report.writing import write
from c2s_engine.saving import save
from c2s_engine.session.errors import SessionError

TEXT = "The ego follows a truck on a straight road at 50 km/h. After five seconds the truck brakes hard."
PROGRAM = """param map = localPath('town.xodr')
param carla_map = None
model scenic.simulators.carla.model
ego = new Car with behavior FollowLaneBehavior(8)
lead = new Car ahead of ego by 12, with behavior FollowLaneBehavior(8)
"""


@pytest.mark.full
async def test_same_inputs_give_the_same_bytes(engine: Engine, tmp_path: Path) -> None:
    for form in ("md", "html", "json"):
        for again in ("a", "b"):
            material = await of_text(engine, TextRecord("truck", TEXT), seed=3)
            write(material, tmp_path / f"{form}-{again}", form)
        names = sorted(f.name for f in (tmp_path / f"{form}-a").iterdir())
        assert names == sorted(["moments.png", "plots.png", f"report.{form}"])
        for name in names:
            assert (tmp_path / f"{form}-a" / name).read_bytes() == (tmp_path / f"{form}-b" / name).read_bytes(), name


async def test_shows_what_was_said_and_what_happened(engine: Engine, tmp_path: Path) -> None:
    material = await of_text(engine, TextRecord("truck", TEXT, "the truck brakes"))
    shown = json.loads(write(material, tmp_path, "json").read_text("utf-8"))
    assert shown["text"] == TEXT and shown["matters"] == "the truck brakes"
    assert [c["id"] for c in shown["structure"]] == ["G", "R", "E", "O1", "T"]
    first = shown["tracks"][0]["others"]["truck"]
    assert first["where"] == "ego's lane" and 10 < first["gap"] < 60 and first["ahead"] > first["gap"]
    assert abs(shown["tracks"][4]["speed"] - 50) < 2
    assert {"time": 5.0, "who": "truck", "event": "brake_hard", "other": ""} in shown["timeline"]
    assert any(m["what"].startswith("first event: truck brake") and m["time"] == 5.0 for m in shown["moments"])
    (with_truck,) = shown["criticality"]
    assert 0 < with_truck["ttc_s"] < 10 and with_truck["required_deceleration_mps2"] > 0.5
    text = write(material, tmp_path, "md").read_text("utf-8")
    assert TEXT in text and shown["program"] in text and "What matters most to its writer: the truck brakes" in text


async def test_blind_tells_neither_method_nor_scores(engine: Engine, tmp_path: Path) -> None:
    material = await of_text(engine, TextRecord("truck", TEXT))
    text = write(material, tmp_path, "md", blind=True, head="THE RUBRIC").read_text("utf-8")
    assert text.startswith("THE RUBRIC") and "method" not in text and "digests" not in dossier(material, blind=True)


async def test_program_without_a_text(engine: Engine, tmp_path: Path) -> None:
    file = tmp_path / "own.scenic"
    engine.library.working_copy(engine.library.find("town"))
    (tmp_path / "town.xodr").write_bytes(engine.library.find("town").path.read_bytes())
    file.write_text(PROGRAM)
    text = write(await of_program(engine, file, PROGRAM), tmp_path).read_text("utf-8")
    assert "There is no text: S is what was recognised in the program" in text
    assert "FollowLaneBehavior" in text and "## Tracks" in text


async def test_program_with_its_text_names_what_makes_no_difference(engine: Engine, tmp_path: Path) -> None:
    said = "The ego drives at 50 km/h in light rain."
    *_, done = [event async for event in engine.generate(said, run=False)]
    file = tmp_path / "rain.scenic"
    save(done.program, done.details["folder"], file, structure=done.structure)
    material = await of_program(engine, file, file.read_text("utf-8"))
    assert [lost["text"] for clause in dossier(material)["account"] for lost in clause["lost"]] == ["light"]


async def test_program_that_does_not_run_says_why(engine: Engine, tmp_path: Path) -> None:
    broken = PROGRAM.replace("FollowLaneBehavior(8)", "NoSuchBehavior(8)")
    (tmp_path / "town.xodr").write_bytes(engine.library.find("town").path.read_bytes())
    material = await of_program(engine, tmp_path / "broken.scenic", broken)
    assert material.problem.startswith("It did not run: ") and "NoSuchBehavior" in material.problem
    text = write(material, tmp_path).read_text("utf-8")
    assert f"**{material.problem}**" in text and "## Tracks" not in text


async def test_run_that_breaks_off_says_when(engine: Engine, tmp_path: Path) -> None:
    breaking = PROGRAM.replace("FollowLaneBehavior(8)", "Fails()", 1).replace(
        "ego =", "behavior Fails():\n    do FollowLaneBehavior(8) for 2 seconds\n    take undefined_thing\nego =", 1
    )
    (tmp_path / "town.xodr").write_bytes(engine.library.find("town").path.read_bytes())
    material = await of_program(engine, tmp_path / "breaking.scenic", breaking)
    assert material.problem, material.facts
    assert f"**{material.problem}**" in write(material, tmp_path).read_text("utf-8")


async def test_text_that_tells_no_scene(engine: Engine, tmp_path: Path) -> None:
    material = await of_text(engine, TextRecord("poem", "Roses are red and violets are blue."))
    assert material.problem.startswith("It did not run: ")
    assert "There is no program." in write(material, tmp_path).read_text("utf-8")


async def test_session_that_is_not_there(engine: Engine) -> None:
    with pytest.raises(SessionError, match="There is no session 'nobody'"):
        await of_session(engine, "nobody")


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("", "holds no list of records"),
        ("id: a\ntext: b\n", "holds no list of records"),
        ("- {id: a, text: [", "line 1 is no YAML"),
        ("- {id: a}\n", "record 1 has no text"),
        ("- {id: a, text: ''}\n", "record 1 has no text"),
        ("- {id: ../a, text: b}\n", "record 1 needs an id of letters"),
        ("- {id: a, text: b}\n- {id: a, text: c}\n", "the id a is used twice"),
        (b"\xff\xfe- 1", "is no text in UTF-8"),
    ],
)
async def test_unreadable_records(content: str | bytes, says: str, tmp_path: Path) -> None:
    file = tmp_path / "records.yaml"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(ReportError, match=says):
        read_records(file)
