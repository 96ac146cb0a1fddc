"""Changes upon scenes: what somebody types upon an S, and the S that it should become, by hand: as the lines of
c2s_engine/interpret/learned/change.py. No line: the words are no change (a question, another scenario)."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import yaml

from c2s_bench.reading.agreement import agreement
from c2s_bench.reading.scenes import Scene, scenes
from c2s_engine.interpret.learned.change import changed_structure
from c2s_engine.interpret.learned.edits import after
from c2s_engine.session.reader import routed
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import EditError

FOLDER = Path(__file__).parent / "changes"
HELD = ("frost", "mauve", "quartz")
"""Writers whose changes are held out of training."""


@dataclass(frozen=True)
class Turn:
    """What is typed upon a scene, with the lines of the change; `writer`: who wrote it."""

    scene: Scene
    text: str
    lines: tuple[str, ...]
    writer: str = ""

    @property
    def held(self) -> bool:
        """Whether it is held out of training."""
        return self.writer in HELD

    @property
    def after(self) -> Structure:
        """The S that the change makes of the scene's."""
        return changed_structure(self.scene.structure, self.lines)


def turns(folder: Path = FOLDER) -> Iterator[Turn]:
    """All of them, by file."""
    known = {scene.id: scene for scene in scenes()}
    for file in sorted(folder.glob("*.yaml")):
        rows = yaml.load(file.read_text(encoding="utf-8"), Loader=yaml.CSafeLoader)
        yield from (Turn(known[row["scene"]], row["say"], tuple(row["change"]), file.stem) for row in rows)


def outcome(turn: Turn) -> str:
    """What the app makes of a turn: `right` (S becomes what it should, or stays as it is where nothing should change),
    `nothing` (S stays as it is, though it should change), `wrong`."""
    before, wanted = turn.scene.structure, turn.after
    asked = routed(turn.text, before)
    edits = asked.edits if asked.kind == "edit" else ()
    try:
        found = after(before, edits)
    except EditError:
        return "wrong"
    if agreement(found, wanted).exact and (turn.lines or not edits):
        return "right"
    return "nothing" if not edits else "wrong"
