"""The installed Scenic's own library: what programs may take from it, and what it may not do were it a program."""

import re
from pathlib import Path

import pytest
import scenic

from c2s_engine.check import importer, pieces, safety, world
from c2s_engine.check.protocol import ImportRequest
from c2s_engine.structure.program import assemble

ROOT = Path(scenic.__file__).parent
MODELS = ("scenic.domains.driving.model", "scenic.simulators.carla.model")
DRIVING = [
    *ROOT.glob("domains/driving/*.scenic"), *ROOT.glob("simulators/carla/*.scenic"),
    *ROOT.glob("simulators/newtonian/*.scenic"),
]  # fmt: skip
OF_A_WORLD_MODEL = re.compile(
    r"(import .*|from .* import .*|a simulator of its own|the attribute fromFile|the private attribute _control"
    r"|(_model|_utils|utils|blueprints|pathlib|warnings), which the world model only uses itself"
    r"|Scenic's internal CarlaSimulator|record of a module beside the program"
    r"|Python's (type|ModuleNotFoundError))"
)
"""What makes a file a world model rather than a scenario: it loads the map and the simulator's packages."""


@pytest.mark.parametrize("model", MODELS)
def test_whatever_a_model_gives_may_be_used(model: str) -> None:
    given = world.world(model)
    assert given is not None
    own = {n for n in given.names - world.language() if not n.startswith("_")} - safety.leaks()
    refused = sorted(n for n in own if safety.bad_name(n))
    assert len(own) > 80
    assert refused == ["CarlaSimulator"] if "carla" in model else not refused


@pytest.mark.parametrize("path", DRIVING, ids=lambda p: f"{p.parent.name}.{p.stem}")
def test_it_does_nothing_else_that_is_refused(path: Path) -> None:
    words = "not allowed in a scenario: "
    found = [d.message for d in safety.examine(pieces.parse(path.read_text(encoding="utf-8"), path.name))]
    assert [m for m in found if not OF_A_WORLD_MODEL.fullmatch(m.removeprefix(words))] == []


@pytest.mark.full
@pytest.mark.parametrize("path", sorted(ROOT.rglob("*.scenic")), ids=lambda p: f"{p.parent.name}.{p.stem}")
def test_it_is_imported_and_exported_again(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    structure = importer.import_program(ImportRequest(text=text)).structure
    assert structure is not None
    assert assemble(structure).text == text
