"""The example session that a first run opens: one exported file, and six lines that explain it."""

import json
from pathlib import Path
from typing import TYPE_CHECKING

from c2s_engine.paths import shipped

if TYPE_CHECKING:
    from c2s_engine.session.sessions import Sessions
    from c2s_engine.session.state import State


def file() -> Path:
    return shipped("examples", "session.json")


def lines() -> list[str]:
    """Six lines on what is on the screen and what to do next."""
    return shipped("examples", "session.txt").read_text("utf-8").strip().splitlines()


def state() -> "State":
    """Where the example stands, to be shown while it is being installed (that imports the database's side)."""
    from c2s_engine.session.state import State

    turns = json.loads(file().read_text("utf-8"))["turns"]
    return State.model_validate(turns[-1]["state"])


def install(sessions: "Sessions", name: str) -> str:
    """The name of the example session, taken from its file where the user does not have it. Raises SessionError."""
    if any(info.name == name for info in sessions.list()):
        return name
    return sessions.import_file(file(), name)
