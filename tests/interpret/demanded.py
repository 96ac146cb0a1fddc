"""What typed demands make of a scene, for the tests of this room."""

from c2s_engine.interpret.turn import route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import apply

LIGHTS = (
    "Ego approaches a signalised intersection at 40 km/h and turns left. An oncoming truck goes straight on. "
    "A motorcycle follows ego."
)
MOTORWAY = (
    "On a three-lane motorway ego drives at 108 km/h in the middle lane. A van 30 m ahead brakes. "
    "A car on the left at 140 km/h overtakes ego."
)
ROW = (
    "Ego drives at 30 km/h past three cars that are parked on the right. A boy runs out from behind them. "
    "A bus comes the other way."
)


def changed(structure: Structure, text: str) -> Structure:
    """S after a text that must be understood as a change of it."""
    turn = route(text, structure)
    assert turn.kind == "edit" and turn.edits, (text, turn)
    for edit in turn.edits:
        structure = apply(structure, edit)
    return structure


def specs(structure: Structure) -> dict[str, object]:
    """The specs by id."""
    return {c.id: c.spec for c in structure.components}


def after(structure: Structure, text: str) -> dict[str, object]:
    """The specs after such a text."""
    return specs(changed(structure, text))


def assert_same(structure: Structure, plain: str, wordings: str) -> None:
    """Each of the wordings (parted by " | ") must change S as the plainest one does, which must change it."""
    wanted = after(structure, plain)
    assert wanted != specs(structure), plain
    wrong = [text for text in wordings.split(" | ") if after(structure, text) != wanted]
    assert not wrong
