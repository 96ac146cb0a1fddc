"""What must outlive a crash before it is in a checkpoint: the turn that is being worked on, and drafts.

A turn is written down, and on the disk, before the graph is invoked; its end is a second line. A turn without its end
was interrupted: it is offered again when the session is opened. A text that led to no turn stays with its end.
"""

import contextlib
import json
import os
import re
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict

from c2s_engine.session.errors import SessionError
from c2s_engine.session.files import sync_folder, write_whole
from c2s_engine.structure.components import Unmet
from c2s_engine.structure.edits import Edit

COMPACT_AT = 256 << 10  # bytes
KEPT_TEXTS = 50  # that led to no turn
Kind = Literal["say", "apply", "regenerate"]


class Pending(BaseModel):
    """A turn as it was asked for."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    number: int
    kind: Kind
    text: str = ""
    edits: tuple[Edit, ...] = ()
    components: tuple[str, ...] = ()
    options: dict[str, Any] = {}
    when: float = 0.0


class Unread(BaseModel):
    """A text that led to no turn: its reading failed, it was not understood, or it was cancelled."""

    model_config = ConfigDict(frozen=True)

    text: str
    when: float = 0.0  # s since the epoch
    replies: tuple[str, ...] = ()


class Journal:
    """One session's turns, a JSON line as each begins and ends."""

    def __init__(self, file: Path):
        self.file = file
        self._open: dict[int, Pending] = {}
        self._last = 0
        self.unread: list[Unread] = []
        for line in self._lines():
            self._take(line)

    @property
    def pending(self) -> Pending | None:
        """The turn that was interrupted, if there is one."""
        return self._open[max(self._open)] if self._open else None

    def begin(
        self,
        kind: Kind,
        text: str = "",
        edits: tuple[Edit, ...] = (),
        components: tuple[str, ...] = (),
        options: dict[str, Any] | None = None,
    ) -> Pending:
        """Write a turn down; when this returns it is on the disk."""
        self._last += 1
        turn = Pending(
            number=self._last, kind=kind, text=text, edits=edits, components=components, options=options or {},
            when=time.time(),
        )  # fmt: skip
        self._open = {self._last: turn}  # an older interrupted turn is given up when another is begun
        self._append({"begin": turn.model_dump(mode="json")})
        return turn

    def end(self, turn: Pending, unread: Unread | None = None) -> None:
        """Note that a turn is in a checkpoint, was refused or cancelled: it will not be offered again; `unread`: its
        text, where that led to no turn."""
        entry: dict[str, Any] = {"end": turn.number}
        if unread is not None:
            entry["unread"] = [unread.model_dump(mode="json")]
        self._take(entry)
        if self.file.exists() and self.file.stat().st_size > COMPACT_AT:
            kept: list[Unread] = []
            for text in reversed(self.unread):
                if sum(len(t.model_dump_json()) for t in (*kept, text)) < COMPACT_AT // 2:
                    kept.insert(0, text)
            self.unread = kept
            told = [t.model_dump(mode="json") for t in kept]
            write_whole(self.file, json.dumps({"last": self._last, "unread": told}) + "\n")
        else:
            self._append(entry)

    def _append(self, entry: dict[str, Any]) -> None:
        new = not self.file.exists()
        self.file.parent.mkdir(parents=True, exist_ok=True)
        with self.file.open("a", encoding="utf-8") as handle:
            handle.write(json.dumps(entry) + "\n")
            handle.flush()
            os.fsync(handle.fileno())
        if new:
            sync_folder(self.file.parent)

    def _lines(self) -> list[dict[str, Any]]:
        try:
            text = self.file.read_text(encoding="utf-8", errors="replace")
        except FileNotFoundError:
            return []
        if text and not text.endswith("\n"):  # the line that a crash tore: it must not swallow the next
            text = text[: text.rfind("\n") + 1]
            write_whole(self.file, text)
        found = []
        for line in text.splitlines():
            try:
                found.append(json.loads(line))
            except ValueError:
                continue
        return found

    def _take(self, entry: dict[str, Any]) -> None:
        if "begin" in entry:
            try:
                turn = Pending.model_validate(entry["begin"])
            except ValueError:
                return
            self._last = turn.number
            self._open = {turn.number: turn}
        elif "end" in entry:
            self._open.pop(entry["end"], None)
        elif "last" in entry:
            self._last = entry["last"]
        with contextlib.suppress(ValueError, TypeError):
            self.unread = [*self.unread, *map(Unread.model_validate, entry.get("unread", ()))][-KEPT_TEXTS:]


class Idle:
    """By text, the phrases of it without which S would be the same: they take a while to find, so they are kept."""

    def __init__(self, file: Path):
        self.file = file

    def of(self, text: str) -> tuple[Unmet, ...] | None:
        """What was found of a text; None where nobody has looked, or what was written cannot be read."""
        try:
            return tuple(Unmet.model_validate(u) for u in self._all()[text])
        except (KeyError, TypeError, ValueError):
            return None

    def keep(self, text: str, found: Sequence[Unmet]) -> None:
        others = {k: v for k, v in self._all().items() if k != text}
        kept = dict([*others.items(), (text, [u.model_dump(mode="json") for u in found])][-KEPT_TEXTS:])
        write_whole(self.file, json.dumps(kept))

    def _all(self) -> dict[str, Any]:
        try:
            found = json.loads(self.file.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return found if isinstance(found, dict) else {}


class Drafts:
    """What is typed and not sent, a swap file a pane."""

    def __init__(self, folder: Path):
        self.folder = folder
        self._writing = threading.Lock()

    def save(self, pane: str, text: str) -> None:
        """Keep a pane's text; empty text removes it. From any thread: one after the other."""
        with self._writing:
            if text:
                write_whole(self._file(pane), text)
            else:
                self._file(pane).unlink(missing_ok=True)

    def load(self, pane: str) -> str:
        try:
            with self._file(pane).open(encoding="utf-8", newline="") as handle:
                return handle.read()
        except FileNotFoundError:
            return ""

    def panes(self) -> list[str]:
        """The panes with a draft."""
        return sorted(f.stem for f in self.folder.glob("*.swap"))

    def _file(self, pane: str) -> Path:
        if not re.fullmatch(r"\w[\w-]{0,40}", pane):
            raise SessionError(f"{pane!r} is no name of a pane: use letters, digits and dashes")
        return self.folder / f"{pane}.swap"
