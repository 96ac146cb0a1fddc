"""Named, durable sessions in one folder: list, open, rename, duplicate, delete, export and import."""

import shutil
from dataclasses import dataclass
from pathlib import Path

from c2s_engine.paths import data_folder
from c2s_engine.session.errors import NO_SESSION, SessionError
from c2s_engine.session.facade import Turns
from c2s_engine.session.files import write_whole
from c2s_engine.session.session import ROOT, Session, Turn
from c2s_engine.session.store import Store

__all__ = ["Session", "SessionError", "SessionInfo", "Sessions", "Turn"]


@dataclass(frozen=True)
class SessionInfo:
    """A session as a list shows it."""

    name: str
    turns: int
    created: float  # s since the epoch
    updated: float
    last: str = ""  # the last turn's text


class Sessions:
    """The sessions of a folder (default: the user's)."""

    def __init__(self, folder: Path | None = None):
        self.folder = folder or data_folder() / "sessions"
        self._store = Store(self.folder / "sessions.sqlite")

    def list(self) -> list[SessionInfo]:
        """All of them, the one used last first."""
        found = []
        for row in self._store.rows():
            turns = self._store.turns(row.thread)
            path, at = [], row.head
            while at in turns:
                path.append(turns[at])
                at = turns[at].parent
            path = [t for t in path if t.kind != ROOT]
            found.append(SessionInfo(row.name, len(path), row.created, row.updated, path[0].text if path else ""))
        return found

    def open(self, name: str, engine: Turns, create: bool = True) -> Session:
        """Open a session; one that is not there is made, unless `create` is off."""
        row = self._store.row(name)
        if row is None:
            if not create:
                raise SessionError(NO_SESSION.format(name))
            row = self._store.create(name)
        return Session(self._store, row, self._folder_of(row.thread), engine)

    def rename(self, name: str, new: str) -> None:
        """Give a session another name, also one that is open; raises SessionError."""
        self._store.rename(name, new)

    def duplicate(self, name: str, new: str) -> None:
        """A second session with the same turns; drafts stay with the first."""
        self._store.copy(self._thread(name), new)

    def delete(self, name: str) -> None:
        """Delete a session with all its turns and drafts."""
        thread = self._thread(name)
        self._store.delete(thread)
        shutil.rmtree(self._folder_of(thread), ignore_errors=True)

    def export(self, name: str, file: Path) -> None:
        """Write a session with its turns as one file."""
        from c2s_engine.session.bundle import bundle

        write_whole(file, bundle(self._store, self._thread(name), name))

    def import_file(self, file: Path, name: str | None = None) -> str:
        """Take a session from a file; returns its name, which is numbered where it is taken already."""
        from c2s_engine.session.bundle import unbundle

        try:
            text = file.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise SessionError(f"{file} cannot be read: {error}") from None
        return unbundle(self._store, text, str(file), name)

    def close(self) -> None:
        self._store.close()

    def _thread(self, name: str) -> str:
        row = self._store.row(name)
        if row is None:
            raise SessionError(NO_SESSION.format(name))
        return row.thread

    def _folder_of(self, thread: str) -> Path:
        return self.folder / thread
