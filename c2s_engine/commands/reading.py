"""Texts and programs as they come in: an argument, standard input, a .txt, .md or .pdf file."""

import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from c2s_engine.commands.console import InputError
from c2s_engine.structure.components import Structure
from c2s_engine.structure.program import Program, assemble

if TYPE_CHECKING:
    from c2s_engine.api import Engine

LONGEST = 60_000
"""Characters of a description; a report beyond that is no scenario."""


def read_text(text: str | None, file: Path | None) -> str:
    """The description; raises InputError."""
    if text is None and file is None:
        raise InputError(
            'Give a description: c2s generate "A car brakes hard in front of ego.", `-` for standard input, or --file.'
        )
    if file is not None:
        found = _from_file(file)
    elif text == "-":
        found = _decoded(sys.stdin.buffer.read(LONGEST * 8), "standard input")
    else:
        found = text or ""
    return description(found)


def description(text: str) -> str:
    """A text as it is interpreted; raises InputError where it is empty or too long."""
    found = text.strip()
    if not found:
        raise InputError(
            "The description is empty: say in a sentence what happens, for example who brakes, crosses or cuts in."
        )
    if len(found) > LONGEST:
        raise InputError(
            f"The description has {len(found):,} characters, at most {LONGEST:,} can be read: "
            "give the part that tells the scenario."
        )
    return found


def read_program(file: Path) -> str:
    """A Scenic program; raises InputError."""
    text = _decoded(_bytes(file), str(file))
    if not text.strip():
        raise InputError(f"{file} is empty: give a Scenic program.")
    return text


def _bytes(file: Path) -> bytes:
    if file.is_dir():
        raise InputError(f"{file} is a folder: name a file in it.")
    if not file.exists():
        raise InputError(f"There is no file {file}: check the name.")
    return file.read_bytes()


def _from_file(file: Path) -> str:
    data = _bytes(file)
    if file.suffix.lower() == ".pdf" or data[:5] == b"%PDF-":
        return _pdf(file)
    return _decoded(data, str(file))


def _pdf(file: Path) -> str:
    from pypdf import PdfReader
    from pypdf.errors import PyPdfError

    try:
        text = "\n".join(page.extract_text() or "" for page in PdfReader(file).pages)
    except (PyPdfError, ValueError, KeyError) as error:
        raise InputError(f"{file} cannot be read as a PDF ({error}): save its text as .txt.") from None
    if not text.strip():
        raise InputError(f"{file} holds no text (a scan?): save its text as .txt.")
    return text


def _decoded(data: bytes, name: str) -> str:
    if b"\0" in data[:4096]:
        raise InputError(f"{name} is binary, not text: give a text file, such as .txt, .md or .scenic, or a .pdf.")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


async def judged_by(engine: "Engine", text: str, file: Path | None) -> tuple[Structure, Program, str]:
    """The S by which a program is judged, where its components are, and in words which S that is: the one that was
    saved with the file, what was changed in it since as code by hand; else what is recognised in it, if anything."""
    from c2s_engine.check.client import CheckError
    from c2s_engine.saving import beside, followed, spans, taken

    if file is not None and (edits := taken(file, text)):
        words = f"Judged by the S in {beside(file).name}"
        words += f", and what was changed in {file.name} since." if edits[1:] else ", saved with the program."
        return await followed(engine, edits), Program(text=text, spans=spans(edits)), words
    with suppress(CheckError):  # what cannot be parsed is told by the check
        name, folder = (file.name, file.parent) if file else ("program.scenic", None)
        structure = await engine.import_program(text, name, folder)
        program = assemble(structure)
        found = program.spans if program.text.strip() == text.strip() else ()
        return structure, Program(text=text, spans=found), "Judged by what is recognised in the program."
    return Structure(), Program(text=text), ""
