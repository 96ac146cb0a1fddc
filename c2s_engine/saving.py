"""A program on disk, with its map and the driving library beside it."""

import re
import shutil
from pathlib import Path

from c2s_engine import driving
from c2s_engine.structure.program import Program


def save(program: Program, folder: str | None, target: Path, standalone: bool = False) -> list[Path]:
    """Write a program, and its map and library beside it (unless they already lie there); the files written.

    `standalone`: with what it uses of the driving library in it.

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
    sources = [Path(folder or ".") / name for name in re.findall(r"localPath\('([^']+)'\)", text)]
    for source in [*sources, *([driving.path()] if driving.used_by(text) else [])]:
        copy = target.parent / source.name
        if (
            source.is_file()
            and (not copy.exists() or copy.read_bytes() != source.read_bytes())
            and source.resolve() != copy.resolve()
        ):
            shutil.copyfile(source, copy)
            written.append(copy)
    return written
