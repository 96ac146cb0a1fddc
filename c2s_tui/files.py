"""Programs as files: save, open, import, edit outside, notice changes."""

import asyncio
import os
import shlex
import subprocess
import sys
import tempfile
from functools import partial
from itertools import chain, count
from pathlib import Path
from typing import TYPE_CHECKING

from c2s_tui.part import Part, background, sentence
from c2s_tui.screens.dialogs import Confirm

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench

WATCH_SECONDS = 2.0


class Files(Part):
    """Commands that read and write files."""

    def __init__(self, bench: "Workbench", file: Path | None):
        super().__init__(bench)
        self.file = file  # the one that was opened or saved last in this session
        self.file_seen: float | None = None  # when it was changed last, as far as is known (s since the epoch)
        self.told_change: float | None = None
        self.saved_text: str | None = None

    @property
    def unsaved(self) -> Path | None:
        """The file, where the program differs from what is in it."""
        return self.file if self.saved_text is not None and self.bench.code.text != self.saved_text else None

    async def do_save(self, argument: str) -> None:
        """Write the program (and its map beside it)."""
        target = Path(argument).expanduser() if argument else self.file
        if target is None:
            self.chat.entry.put(f"/save {self.bench.session.name if self.bench.session else 'program'}.scenic")
            self.chat.entry.focus()
            return
        if target.suffix == "":
            target = target.with_suffix(".scenic")
        own = self.file is not None and target.absolute() == self.file.absolute()
        if own and not self._changed_outside() or not target.exists():
            await self.write(target)
            return
        said = "was changed by another program" if own else "is there already and is not this session's"
        answers = {"b": ("", "go back"), "r": ("reload", "read the file instead"), "o": ("over", "overwrite the file")}
        dialog = Confirm(f"{target} {said}.", answers, by_key=False)  # what is typed on must overwrite nothing
        self.app.push_screen(dialog, lambda answer: self._resolve_change(answer, target))

    async def write(self, target: Path) -> None:
        """Write the text that the code pane shows, edits that are not applied included."""
        program = self.desk.program.model_copy(update={"text": self.bench.code.text})
        try:
            folders = [self.desk.folder, str(self.file.parent) if self.file else None]
            saved = partial(self.backend.save, program, folders, target, self.desk.structure)
            written, told = await asyncio.to_thread(saved)
        except OSError as error:
            await self.chat.note(f"{target} could not be written: {error.strerror or error}", "error")
            return
        self.file, self.file_seen = target, _stamp(target)
        self.saved_text = program.text
        await self.chat.note(f"Saved {', '.join(p.name for p in written)} in {target.absolute().parent}.")
        for words in told:
            await self.chat.note(words, "warning")

    async def _resolve_change(self, answer: str | None, target: Path) -> None:
        if answer == "over":
            await self.write(target)
        elif answer == "reload":
            await self.import_file(target)

    def _changed_outside(self) -> bool:
        """Whether this session's file is no longer as it was read or written here."""
        stamp = _stamp(self.file) if self.file is not None else None
        return self.file_seen is not None and stamp not in (None, self.file_seen)

    def forget(self) -> None:
        """Another session comes: the file belongs to the one before."""
        self.file = self.file_seen = self.told_change = self.saved_text = None

    def watch_file(self) -> None:
        """Called now and then: whether the opened file was changed by another program; told once."""
        if self.file is not None and self._changed_outside() and self.told_change != _stamp(self.file):
            self.told_change = _stamp(self.file)
            self.app.notify(
                f"{self.file.name} was changed by another program: /open {self.file} reads it again.",
                severity="warning", markup=False,
            )  # fmt: skip

    async def do_open(self, argument: str) -> None:
        if not argument:
            self.bench.sessions.offer_sessions()
            return
        path = Path(argument).expanduser()
        if path.suffix == ".scenic" or path.is_file():
            await self.import_file(path)
        else:
            self.bench.sessions.opens()
            self.bench.sessions.open_known(argument)

    async def import_file(self, path: Path) -> None:
        """Take a Scenic file into the session, in components."""
        if not await self.bench.turns.may_begin():
            return
        try:
            text = (await asyncio.to_thread(path.read_bytes)).decode()
        except (OSError, UnicodeDecodeError) as error:
            await self.chat.note(f"{path} cannot be read: {getattr(error, 'strerror', None) or error}", "error")
            return
        self.take_program(text, path)

    @background("choices")
    async def take_program(self, text: str, path: Path) -> None:
        """Make a program a session's, this one's where it is empty, else a new one's: with the S that was saved with
        it, else with what is recognised in it."""
        from c2s_engine.saving import taken
        from c2s_engine.structure.edits import Replace
        from c2s_engine.structure.program import assemble

        edits, converted = await asyncio.to_thread(taken, path, text), False
        if not edits:
            try:
                structure = await self.backend.ask(lambda engine: engine.import_program(text, folder=path.parent))
            except (ValueError, OSError, RuntimeError) as error:
                await self.chat.note(f"{path.name} could not be imported: {sentence(error)}", "error")
                return
            edits, converted = [Replace(structure=structure)], assemble(structure).text != text
        name, left = path.stem, self.session.name
        if self.desk.program.text or self.bench.code.edited:
            others = {s.name for s in await self.backend.all_sessions()}
            names = chain([name], (f"{name}-{i}" for i in count(2)))
            await self.bench.sessions.enter(next(n for n in names if n not in others))
            await self.chat.note(f"{path.name} was opened in a session of its own; /open {left} goes back.")
        self.file, self.file_seen = path, _stamp(path)
        self.saved_text = text
        if converted:
            said = f"{path.name} is written in Scenic 2; you see it converted to Scenic 3."
            await self.chat.note(said, "warning")
        await self.chat.note(f"Opened {path.name}.")
        await self.bench.turns.make_edits(tuple(edits))

    async def do_editor(self, _: str) -> None:
        """The program in $EDITOR; what comes back is a hand edit."""
        editor = os.environ.get("VISUAL") or os.environ.get("EDITOR")
        if not editor:
            await self.chat.note("Set EDITOR (for example EDITOR=vim) to use your own editor.", "error")
            return
        text = self.bench.code.text
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "program.scenic"
            file.write_bytes(text.encode())
            try:
                with self.app.suspend():
                    subprocess.run([*shlex.split(editor), str(file)], stdout=sys.__stdout__, stderr=sys.__stderr__)
            except Exception as error:
                await self.chat.note(f"{editor} could not be run: {sentence(error)}", "error")
                return
            changed = file.read_bytes().decode()
        self.app.refresh()
        if changed != text:
            self.bench.code.area.text = changed
            self.bench.code.commit()


def _stamp(path: Path) -> float | None:
    try:
        return path.stat().st_mtime
    except OSError:
        return None
