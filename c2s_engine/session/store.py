"""The database of sessions: names, heads and turns beside LangGraph's own tables, in one SQLite file.

A turn's row and the session's new head are one transaction, made after the checkpoint is there: whatever a crash cuts
off, the head names a whole checkpoint.
"""

import json
import sqlite3
import threading
import time
import uuid
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from c2s_engine.session.errors import NO_SESSION, SessionError

KEPT_TURNS = 100  # that undo can go back

_SCHEMA = """
CREATE TABLE IF NOT EXISTS sessions (
    name TEXT PRIMARY KEY, thread TEXT UNIQUE NOT NULL, head TEXT, redo TEXT NOT NULL DEFAULT '[]',
    created REAL NOT NULL, updated REAL NOT NULL);
CREATE TABLE IF NOT EXISTS turns (
    thread TEXT NOT NULL, checkpoint_id TEXT NOT NULL, parent TEXT, kind TEXT NOT NULL, text TEXT NOT NULL,
    at REAL NOT NULL, summary TEXT NOT NULL, replies TEXT NOT NULL, PRIMARY KEY (thread, checkpoint_id));
"""


@dataclass(frozen=True)
class Row:
    """One session: where it stands and what redo would bring back (last first)."""

    name: str
    thread: str
    head: str | None
    redo: tuple[str, ...]
    created: float  # s since the epoch
    updated: float


@dataclass(frozen=True)
class TurnRow:
    """One turn with the checkpoint that it ended in."""

    checkpoint: str
    parent: str | None
    kind: str
    text: str
    when: float  # s since the epoch
    summary: str = ""
    replies: tuple[str, ...] = ()


class Store:
    """One connection, usable from any thread; LangGraph's saver shares it and its lock."""

    def __init__(self, file: Path):
        file.parent.mkdir(parents=True, exist_ok=True)
        try:
            self.connection = sqlite3.connect(file, check_same_thread=False, timeout=10)
            self.connection.execute("PRAGMA auto_vacuum=INCREMENTAL")
            self.connection.execute("PRAGMA journal_mode=WAL")
            self.connection.execute("PRAGMA synchronous=FULL")
            self.connection.executescript(_SCHEMA)
        except sqlite3.DatabaseError as error:
            raise SessionError(f"the sessions in {file} cannot be read ({error}): move that file away") from None
        self.lock = threading.RLock()

    def close(self) -> None:
        self.connection.close()

    @contextmanager
    def transaction(self) -> Iterator[sqlite3.Connection]:
        """Everything inside happens or nothing does."""
        with self.lock:
            try:
                yield self.connection
            except BaseException:
                self.connection.rollback()
                raise
            self.connection.commit()

    def rows(self) -> list[Row]:
        """All sessions, the latest first."""
        with self.lock:
            found = self.connection.execute(
                "SELECT name, thread, head, redo, created, updated FROM sessions ORDER BY updated DESC, name"
            ).fetchall()
        return [Row(n, t, h, tuple(json.loads(r)), c, u) for n, t, h, r, c, u in found]

    def row(self, name: str) -> Row | None:
        return next((r for r in self.rows() if r.name == name), None)

    def create(self, name: str) -> Row:
        """A new session without a checkpoint."""
        checked_name(name)
        now, thread = time.time(), uuid.uuid4().hex
        try:
            with self.transaction() as db:
                db.execute("INSERT INTO sessions VALUES (?, ?, NULL, '[]', ?, ?)", (name, thread, now, now))
        except sqlite3.IntegrityError:
            raise SessionError(f"there is already a session {name!r}: choose another name") from None
        return Row(name, thread, None, (), now, now)

    def rename(self, name: str, new: str) -> None:
        checked_name(new)
        try:
            with self.transaction() as db:
                changed = db.execute("UPDATE sessions SET name = ? WHERE name = ?", (new, name)).rowcount
        except sqlite3.IntegrityError:
            raise SessionError(f"there is already a session {new!r}: choose another name") from None
        if not changed:
            raise SessionError(NO_SESSION.format(name))

    def delete(self, thread: str) -> None:
        with self.transaction() as db:
            for table, column in (("sessions", "thread"), ("turns", "thread"), *_langgraph(db)):
                db.execute(f"DELETE FROM {table} WHERE {column} = ?", (thread,))
        self._shrink()

    def copy(self, thread: str, name: str) -> Row:
        """A second session with the same turns and checkpoints."""
        row = self.create(name)
        with self.transaction() as db:
            for table, column in (("turns", "thread"), *_langgraph(db)):
                columns = [c[1] for c in db.execute(f"PRAGMA table_info({table})") if c[1] != column]
                names = ", ".join(columns)
                db.execute(
                    f"INSERT INTO {table} ({column}, {names}) SELECT ?, {names} FROM {table} WHERE {column} = ?",
                    (row.thread, thread),
                )
            head, redo = db.execute("SELECT head, redo FROM sessions WHERE thread = ?", (thread,)).fetchone()
            db.execute("UPDATE sessions SET head = ?, redo = ? WHERE thread = ?", (head, redo, row.thread))
        return row

    def turns(self, thread: str) -> dict[str, TurnRow]:
        """Every turn of a session by its checkpoint."""
        with self.lock:
            found = self.connection.execute(
                "SELECT checkpoint_id, parent, kind, text, at, summary, replies FROM turns WHERE thread = ?", (thread,)
            ).fetchall()
        return {
            c: TurnRow(c, parent, kind, text, at, told, tuple(json.loads(r)))
            for c, parent, kind, text, at, told, r in found
        }

    def add_turn(self, thread: str, turn: TurnRow, redo: Sequence[str] = ()) -> None:
        """A turn, and the head on it. What redo would still bring back comes after it: it changed nothing."""
        with self.transaction() as db:
            db.execute(
                "INSERT OR REPLACE INTO turns VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
                (thread, turn.checkpoint, turn.parent, turn.kind, turn.text, turn.when, turn.summary,
                 json.dumps(turn.replies)),
            )  # fmt: skip
            self._move(db, thread, turn.checkpoint, redo)
            if redo:
                where = "WHERE thread = ? AND checkpoint_id = ?"
                db.execute(f"UPDATE turns SET parent = ? {where}", (turn.checkpoint, thread, redo[-1]))

    def move(self, thread: str, head: str, redo: Sequence[str]) -> None:
        """Undo or redo: another head."""
        with self.transaction() as db:
            self._move(db, thread, head, redo)

    def prune(self, thread: str, keep: int = KEPT_TURNS) -> None:
        """Drop what neither undo nor redo can reach, and turns older than the last `keep`."""
        row = next(r for r in self.rows() if r.thread == thread)
        turns = self.turns(thread)
        kept = set(row.redo)
        at = row.head
        while at in turns and len(kept) < keep + len(row.redo) + 1:
            kept.add(at)
            at = turns[at].parent or ""
        with self.transaction() as db:
            marks = ", ".join("?" * len(kept))
            for table, column in (("turns", "thread"), *_langgraph(db)):
                db.execute(
                    f"DELETE FROM {table} WHERE {column} = ? AND checkpoint_id NOT IN ({marks})", (thread, *kept)
                )
        self._shrink()

    def _move(self, db: sqlite3.Connection, thread: str, head: str, redo: Sequence[str]) -> None:
        db.execute(
            "UPDATE sessions SET head = ?, redo = ?, updated = ? WHERE thread = ?",
            (head, json.dumps(list(redo)), time.time(), thread),
        )

    def _shrink(self) -> None:
        with self.lock:
            self.connection.execute("PRAGMA incremental_vacuum").fetchall()


def _langgraph(db: sqlite3.Connection) -> list[tuple[str, str]]:
    """LangGraph's tables that are there yet, each with its column of the thread."""
    there = {r[0] for r in db.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    return [(t, "thread_id") for t in ("checkpoints", "writes") if t in there]


def checked_name(name: str) -> str:
    """A session's name: one printable line of at most 80 characters."""
    if not name.strip() or len(name) > 80 or not name.isprintable():
        raise SessionError("a session's name is one line of 1 to 80 printable characters")
    return name
