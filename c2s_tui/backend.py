"""How the app comes to the engine and its sessions: everything of theirs runs in the engine's thread."""

import asyncio
import contextlib
from collections.abc import AsyncGenerator, AsyncIterator, Awaitable, Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from c2s_tui.engine_thread import EngineThread

if TYPE_CHECKING:
    from c2s_engine.check.protocol import CheckReport
    from c2s_engine.session.session import Session
    from c2s_engine.session.sessions import SessionInfo, Sessions
    from c2s_engine.structure.components import Structure
    from c2s_engine.structure.program import Program
    from c2s_tui.facade import EngineFacade

CLOSE_SECONDS = 1.0
T = TypeVar("T")


def real_engine() -> "EngineFacade":
    """The engine with the user's settings."""
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    return Engine(load_settings(), apart=True)


class Backend:
    """One engine, one folder of sessions, one open session at a time."""

    def __init__(self, engine: "Callable[[], EngineFacade]" = real_engine, folder: Path | None = None):
        self._make, self._folder = engine, folder
        self.thread = EngineThread()
        self._engine: EngineFacade | None = None
        self._sessions: Sessions | None = None
        self.session: Session | None = None

    @property
    def engine(self) -> "EngineFacade":
        assert self._engine is not None, "loaded first"
        return self._engine

    @property
    def sessions(self) -> "Sessions":
        assert self._sessions is not None, "loaded first"
        return self._sessions

    async def load(self) -> None:
        """Import and make engine and sessions (nothing is started yet)."""

        def make() -> None:
            from c2s_engine.session.sessions import Sessions

            self._engine, self._sessions = self._make(), Sessions(self._folder)

        await self.thread.do(make)

    async def start(self) -> None:
        """Start the engine's processes, and import meanwhile what the first turn needs."""

        async def start() -> None:
            await self.engine.start()
            await asyncio.to_thread(import_module, "c2s_engine.session.turns")

        await self.thread.call(start)

    async def open(self, name: str) -> "Session":
        """Open (or make) a session and close the one before; raises SessionError, and then the old one stays open."""

        def change() -> "Session":
            if self.session is not None and self.session.name == name:
                return self.session
            opened = self.sessions.open(name, self.engine)
            if self.session is not None:
                self.session.close()
            self.session = opened
            return opened

        return await self.thread.do(change)

    async def all_sessions(self) -> "list[SessionInfo]":
        """The sessions, the one used last first."""
        return await self.thread.do(self.sessions.list)

    def events(self, source: Callable[[], AsyncIterator[T]]) -> AsyncGenerator[T, None]:
        """The events of a turn; closing the iterator cancels the turn."""
        return self.thread.stream(source)

    async def ask(self, wanted: "Callable[[EngineFacade], Awaitable[T]]") -> T:
        """What an async method of the engine answers."""
        return await self.thread.call(lambda: wanted(self.engine))

    async def do(self, wanted: "Callable[[EngineFacade], T]") -> T:
        """What a plain method of the engine answers."""
        return await self.thread.do(lambda: wanted(self.engine))

    async def warm(self, map: str) -> None:
        """Have a map read that the next turn is likely to use."""
        await self.ask(lambda engine: engine.warm(map))

    async def set_model(self, name: str) -> None:
        """Use that model for the methods that need one."""

        def change() -> None:
            self.engine.settings.model = name

        await self.thread.do(change)

    async def models(self) -> list[dict[str, Any]]:
        """The models at hand: name and a note with their size. Raises what the client raises (one sentence)."""

        async def ask() -> list[dict[str, Any]]:
            async with self.engine.model_client() as client:
                return await client.models()

        return [{**m, "note": _note(m)} for m in await self.thread.call(ask)]

    async def pull(self, name: str) -> AsyncIterator[tuple[str, int, int]]:
        """Fetch a model: (what is done, bytes so far, bytes in all)."""

        async def steps() -> AsyncIterator[tuple[str, int, int]]:
            async with self.engine.model_client() as client:
                async for step in client.pull(name):
                    yield step

        async for step in self.thread.stream(steps):
            yield step

    def folder(self, program: str) -> str | None:
        """The folder in which the map that a program names lies; None where it names none that is known."""
        return self.engine.library.folder_of(program)

    async def check(self, program: str, **options: Any) -> "CheckReport":
        """Check a program where its map is found."""
        folder = await self.thread.do(lambda: self.folder(program))
        return await self.ask(lambda engine: engine.check(program, folder=folder, **options))

    def save(
        self, program: "Program", folders: Sequence[str | None], target: Path, structure: "Structure"
    ) -> tuple[list[Path], list[str]]:
        """Write a program, its map and its S beside it; the files written, and what is to be known of the others that
        it needs: those that are not there, and those that are others. Raises OSError."""
        from c2s_engine.saving import kept_beside, kept_beside_message, missing_files, missing_files_message, save

        places = (*folders, self.folder(program.text))
        written = save(program, places, target, structure=structure)
        missing, kept = missing_files(target), kept_beside(program, places, target)
        told = [missing_files_message(missing)] if missing else []
        return written, [*told, *([kept_beside_message(kept)] if kept else [])]

    async def close(self) -> None:
        """Close the session, the engine and the thread. None that is slow to end is waited for: the pipe of a process
        is closed, so that it ends by itself, and a session's lock goes with this process.
        """
        for held in (self.session, self._sessions):
            if held is not None:
                with contextlib.suppress(TimeoutError):
                    await asyncio.wait_for(self.thread.do(held.close), CLOSE_SECONDS)
        if self._engine is not None:
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self.thread.call(self.engine.close), CLOSE_SECONDS)
        self.thread.stop()


def _note(model: dict[str, Any]) -> str:
    size = f"{model['size'] / 1e9:.1f} GB" if model.get("size") else ""
    return "  ".join(filter(None, [size, model.get("parameters", ""), model.get("quantization", "")]))
