"""A program on disk, with its map beside it."""

import re
import shutil
from pathlib import Path

from c2s_engine.structure.program import Program


def save(program: Program, folder: str | None, target: Path) -> list[Path]:
    """Write a program, and its map beside it (unless the map already lies there); the files written.

    Raises OSError; the program's text is written beside and renamed, so that a full disk loses nothing.
    """
    written = []
    draft = target.with_name(f".{target.name}.part")
    try:
        draft.write_text(program.text, encoding="utf-8")
        draft.replace(target)
    finally:
        draft.unlink(missing_ok=True)
    written.append(target)
    for name in re.findall(r"localPath\('([^']+)'\)", program.text):
        source, copy = Path(folder or ".") / name, target.parent / name
        if (
            source.is_file()
            and (not copy.exists() or copy.read_bytes() != source.read_bytes())
            and source.resolve() != copy.resolve()
        ):
            shutil.copyfile(source, copy)
            written.append(copy)
    return written
