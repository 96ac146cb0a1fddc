"""The scenes: one or two wordings each, and the S of them by hand."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from c2s_engine.interpret.learned.quantities import si
from c2s_engine.report.gather import structure_of
from c2s_engine.structure.components import Structure

FOLDER = Path(__file__).parent / "data"


@dataclass(frozen=True)
class Scene:
    """One scene. `components`: S as plain data, quantities as strings with the texts' units. `lost`: the phrases of
    each text that S does not hold; None where nobody noted them."""

    id: str
    texts: tuple[str, ...]
    components: dict[str, dict[str, Any]]
    lost: tuple[tuple[str, ...], ...] | None = None

    @property
    def writer(self) -> str:
        """Who wrote it."""
        return self.id.split("-")[0]

    @property
    def held(self) -> bool:
        """Whether it is held out of training: those of each writer's every tenth sheet."""
        return int(self.id.split("-")[1]) % 10 == 7

    @property
    def structure(self) -> Structure:
        """Its S."""
        return structure_of({"G": {}, "T": {}, **si(self.components)}, self.texts[0])


def scenes(folder: Path = FOLDER) -> Iterator[Scene]:
    """All scenes, by writer and sheet."""
    for file in sorted(folder.glob("*.yaml")):
        rows = yaml.load(file.read_text(encoding="utf-8"), Loader=yaml.CSafeLoader)
        yield from (Scene(row["id"], tuple(row["texts"]), row["S"], _lost(row)) for row in rows)


def _lost(row: dict[str, Any]) -> tuple[tuple[str, ...], ...] | None:
    if "lost" not in row:
        return None
    of_texts = row["lost"] or [[]] * len(row["texts"])
    return tuple(tuple(" ".join(p.split()) for p in phrases) for phrases in of_texts)
