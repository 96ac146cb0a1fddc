"""A program on disk, with its map, the driving library and its S beside it."""

import json
import re
import shutil
from collections.abc import Sequence
from difflib import SequenceMatcher
from pathlib import Path
from typing import TYPE_CHECKING

from pydantic import ValidationError

from c2s_engine import driving
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import Edit, Replace, SetProgram, apply
from c2s_engine.structure.program import FragmentSpan, Program, assemble
from c2s_engine.structure.progress import Finished

if TYPE_CHECKING:
    from c2s_engine.api import Engine

FORMAT = "c2s structure 1"
ALIKE = 0.5
"""The share of lines that a program has in common with the one of an S that lies beside it, if that S is its own."""


def save(
    program: Program, folders: Sequence[str | None], target: Path, standalone: bool = False,
    structure: Structure | None = None,
) -> list[Path]:
    """Write a program, and its map and library beside it; the files written. What lies there under their names stays
    as it is, and is in `kept_beside` where it is another one.

    `folders`: where its map may lie, the likeliest first; `missing_files` lists those that are in none of them.
    `standalone`: with what it uses of the driving library in it. `structure`: its S, written as NAME.s.json.

    Raises OSError; the program's text is written beside and renamed, so that a full disk loses nothing.
    """
    written = []
    text = driving.inlined(program.text) if standalone else program.text
    draft = target.with_name(f".{target.name}.part")
    try:
        draft.write_text(text, encoding="utf-8")
        draft.replace(target)
    finally:
        draft.unlink(missing_ok=True)
    written.append(target)
    for source in _companions(text, folders):
        copy = target.parent / source.name
        if not copy.exists():
            shutil.copyfile(source, copy)
            written.append(copy)
    if structure is not None:
        side = beside(target)
        kept = json.dumps({"format": FORMAT, "structure": structure.model_dump(mode="json")}, ensure_ascii=False)
        side.write_text(kept + "\n", encoding="utf-8")
        written.append(side)
    return written


def _companions(text: str, folders: Sequence[str | None]) -> list[Path]:
    """What a program needs beside it: its map, where that is found, and the library."""
    places = [Path(folder) for folder in folders if folder]
    found = (next((p / name for p in places if (p / name).is_file()), None) for name in _named(text))
    return [*filter(None, found), *([driving.path()] if driving.used_by(text) and driving.path().is_file() else [])]


def kept_beside(program: Program, folders: Sequence[str | None], target: Path) -> list[str]:
    """The names of the files beside a saved program that are not those it was written for: another map, or library."""
    beside = [(source, target.parent / source.name) for source in _companions(program.text, folders)]
    return [s.name for s, there in beside if there.is_file() and there.read_bytes() != s.read_bytes()]


def kept_beside_message(names: Sequence[str]) -> str:
    """That the program uses them now, and what to do where that is not meant."""
    there = "is another one than the program was" if len(names) == 1 else "are others than the program was"
    return f"{' and '.join(names)} there {there} written for: kept as it is, and used by the program. " \
        "Save into a folder of its own to have the other."  # fmt: skip


def missing_files(file: Path) -> list[str]:
    """The files that a saved program names beside it and that are not there."""
    named = _named(file.read_text(encoding="utf-8"))
    return [name for name in dict.fromkeys(named) if not (file.parent / name).is_file()]


def missing_files_message(names: Sequence[str]) -> str:
    """That they have to be put there."""
    return f"Put {' and '.join(names)} beside it: the program needs {'them' if names[1:] else 'it'} to run elsewhere."


def _named(text: str) -> list[str]:
    return re.findall(r"localPath\(['\"]([^'\"]+)['\"]\)", text)


def beside(file: Path) -> Path:
    """Where the S of a program is kept."""
    return file.with_suffix(".s.json")


def taken(file: Path, text: str) -> list[Edit]:
    """The edits that take a program from a file with the S that was saved with it, the text's changes since as code by
    hand; none where there is no such S."""
    structure = _saved_with(file)
    if structure is None:
        return []
    was = assemble(structure).text
    if not _alike(was, text) and not _alike(driving.inlined(was), text):
        return []
    return [Replace(structure=structure), *([SetProgram(text=text)] if text != was else [])]


def not_as_saved(file: Path) -> bool:
    """Whether a file is there whose text is not what was last saved with the S beside it: somebody's own, or changed
    since."""
    if not file.exists():
        return False
    structure = _saved_with(file)
    was = assemble(structure).text if structure is not None else None
    text = file.read_text(encoding="utf-8", errors="replace")
    return was is None or text not in (was, driving.inlined(was))


def _saved_with(file: Path) -> Structure | None:
    """The S that was saved with a program; None: there is none that can be read."""
    try:
        data = json.loads(beside(file).read_text(encoding="utf-8"))
        return Structure.model_validate(data["structure"]) if data["format"] == FORMAT else None
    except (OSError, ValueError, KeyError, TypeError, ValidationError):
        return None


def spans(edits: Sequence[Edit]) -> tuple[FragmentSpan, ...]:
    """Where the components are in a program that is `taken` by these edits."""
    structure = Structure()
    for edit in edits:
        structure = apply(structure, edit)
    return assemble(structure).spans


async def followed(engine: "Engine", edits: Sequence[Edit]) -> Structure:
    """The S that these edits, as `taken` gives them, lead to: in step with the text's changes as far as they can be
    read. Nothing is run."""
    structure = apply(Structure(), edits[0])
    if edits[1:]:
        async for event in engine.apply(structure, edits[1:], run=False):
            structure = event.structure if isinstance(event, Finished) else structure
    return structure


def _alike(program: str, text: str) -> bool:
    return SequenceMatcher(None, program.splitlines(), text.splitlines(), autojunk=False).ratio() >= ALIKE
