"""`c2s edit` and `c2s sessions` over a fake engine: everything of a session without the app."""

import json

import pytest
import typer
from session_fake import FakeEngine
from typer.testing import CliRunner

from c2s_engine.commands import sessions


class OpenEngine(FakeEngine):
    def __init__(self, settings=None):
        super().__init__()

    async def __aenter__(self):
        return self

    async def __aexit__(self, *_):
        return None


@pytest.fixture
def c2s(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setattr("c2s_engine.api.Engine", OpenEngine)
    app = typer.Typer()
    app.command()(sessions.edit)
    app.add_typer(sessions.app, name="sessions")

    def call(*arguments, code=0):
        result = CliRunner().invoke(app, [*map(str, arguments)])
        assert result.exit_code == code, (result.output, result.exception)
        return result.output

    return call


def state(c2s, *arguments):
    return json.loads(c2s("edit", "one", "--new", "--json", *arguments))


def test_turns_edits_undo_and_redo(c2s, tmp_path):
    assert [c["id"] for c in state(c2s, "--say", "car")["structure"]] == ["G", "R", "E", "O1", "T"]
    said = state(c2s, "--set", "O1.count=3", "--set", "O1.description=three of them", "--set", "G.map=town")
    cars = said["structure"][3]
    assert (cars["spec"]["count"], cars["description"]) == (3, "three of them")
    assert said["structure"][0]["spec"]["map"] == "town" and said["session"] == "one"
    assert [t["kind"] for t in said["history"]] == ["say", "apply"]
    assert state(c2s, "--undo")["structure"][3]["spec"]["count"] == 1
    assert state(c2s, "--redo")["structure"][3]["spec"]["count"] == 3
    (tmp_path / "mine.scenic").write_text("x = 1\n")
    assert state(c2s, "--code", f"O1={tmp_path / 'mine.scenic'}")["structure"][3]["origin"] == "by_hand"
    assert len(state(c2s, "--remove", "O1")["structure"]) == 4


def test_a_refused_change_ends_with_why_it_was_refused(c2s):
    c2s("edit", "one", "--new", "--say", "car")
    said = c2s("edit", "one", "--say", "refuse this", code=2)
    assert said.rstrip().endswith("heard refuse this") and said.count("heard") == 2


def test_one_goes_to_a_turn_by_its_number(c2s):
    for text in ("car", "truck", "bus"):
        c2s("edit", "one", "--new", "--say", text)
    assert len(state(c2s, "--to", "1")["history"]) == 1
    assert len(state(c2s, "--to", "3")["history"]) == 3
    assert "there is no turn 9" in json.loads(c2s("edit", "one", "--json", "--to", "9", code=2))["error"]


def test_the_program_is_saved_and_shown(c2s, tmp_path):
    c2s("edit", "one", "--new", "--say", "car", "-o", tmp_path / "a.scenic")
    assert "## O1: car" in (tmp_path / "a.scenic").read_text()
    assert "car" in c2s("edit", "one")


def test_values_are_read_as_in_the_app(c2s):
    c2s("edit", "one", "--new", "--say", "car")

    def speed(*given):
        return next(c for c in state(c2s, *given)["structure"] if c["id"] == "E")["spec"]["speed"]

    assert speed("--set", "E.speed=36") == pytest.approx(10) == speed("--set", "E.speed=10 m/s")
    assert speed("--set", "E.speed=18-36 km/h") == [5, 10] == speed("--set", "E.speed=[5, 10]")
    assert speed("--set", "E.speed=") is None


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["--set", "O1"], "write it as ID.FIELD=VALUE"),
        (["--say", "car", "--set", "E.speed=9 bananas"], "speed has the unit km/h or kmh or kph or m/s or mph"),
        (["--code", "O1"], "write it as ID=FILE"),
        (["--undo"], "nothing to undo"),
        (["--resume"], "no turn was interrupted"),
    ],
)
def test_what_cannot_be_done_is_one_sentence(c2s, arguments, complaint):
    said = json.loads(c2s("edit", "another", "--new", "--json", *arguments, code=2))
    assert complaint in said["error"] and said["ok"] is False


def test_a_slip_in_a_name_makes_no_session(c2s):
    c2s("edit", "crossing", "--new", "--say", "car")
    for arguments in (["--say", "a truck"], ["--undo"], []):
        said = json.loads(c2s("edit", "crosing", "--json", *arguments, code=2))
        assert said["error"] == "There is no session 'crosing': did you mean crossing? --new makes it."
    assert [s["name"] for s in json.loads(c2s("sessions", "list", "--json"))["sessions"]] == ["crossing"]


def test_sessions_as_a_whole(c2s, tmp_path):
    c2s("edit", "one", "--new", "--say", "car")
    c2s("sessions", "rename", "one", "uno")
    c2s("sessions", "duplicate", "uno", "two")
    c2s("sessions", "export", "two", tmp_path / "two.c2s")
    c2s("sessions", "delete", "two")
    assert c2s("sessions", "import", tmp_path / "two.c2s", "--name", "again").strip() == "again"
    listed = json.loads(c2s("sessions", "list", "--json"))["sessions"]
    assert {(s["name"], s["turns"], s["last"]) for s in listed} == {("uno", 1, "car"), ("again", 1, "car")}
    assert "again" in c2s("sessions", "list")
    assert "no session 'one'" in c2s("sessions", "delete", "one", code=2)
