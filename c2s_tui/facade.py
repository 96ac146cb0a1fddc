"""What the app asks of an engine: `c2s_engine.api.Engine`, or a scripted one in tests."""

from collections.abc import AsyncGenerator, Iterable, Sequence
from contextlib import AbstractAsyncContextManager
from pathlib import Path
from typing import Any, Protocol

from c2s_engine.config import Settings
from c2s_engine.maps.library import MapFile
from c2s_engine.session.facade import Checking, Turns
from c2s_engine.structure.components import ComponentId, Structure, Unmet
from c2s_engine.structure.edits import Edit
from c2s_engine.structure.facts import Trajectories
from c2s_engine.structure.measures import SeedResult
from c2s_engine.structure.offers import Offer
from c2s_engine.structure.program import Program


class Maps(Protocol):
    """The maps at hand, so far as the app asks for them."""

    def folder_of(self, program: str) -> str | None: ...


class EngineFacade(Turns, Checking, Protocol):
    """Turns upon S, checks, and the single services that the panes use. `options`: those of the facade's methods."""

    @property
    def settings(self) -> Settings: ...

    @property
    def library(self) -> Maps: ...

    async def start(self) -> None: ...

    async def close(self) -> None: ...

    async def warm(self, map: str) -> bool: ...  # noqa: A002

    async def reworded(self, structure: Structure, edits: Sequence[Edit]) -> tuple[list[Edit], list[str]]: ...

    def reach(self, structure: Structure, edit: Edit) -> list[ComponentId]: ...

    def gaps(self, ways: Trajectories) -> dict[str, list[float]]: ...

    def seeds(
        self, structure: Structure, program: Program, numbers: Sequence[int], **options: Any
    ) -> AsyncGenerator[SeedResult, None]: ...

    def contradictions(
        self, structure: Structure, *, map: str, room: float = 1.0  # noqa: A002
    ) -> AsyncGenerator[Offer, None]: ...

    async def without_effect(
        self, text: str, structure: Structure, before: Structure | None = None
    ) -> Sequence[Unmet]: ...

    async def import_program(self, text: str, filename: str = ..., folder: Path | None = ...) -> Structure: ...

    async def search(self, query: str, *, kind: str = "doc", limit: int = 5) -> list[Any]: ...

    async def snippets(self, structure: Structure) -> list[Any]: ...

    def maps(self) -> Iterable[MapFile]: ...

    async def doctor(self) -> list[dict[str, Any]]: ...

    def model_client(self) -> AbstractAsyncContextManager[Any]: ...
