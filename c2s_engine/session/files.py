"""Writing small files so that they are whole after a crash."""

import os
from pathlib import Path


def write_whole(file: Path, text: str) -> None:
    """Replace a file's content: whatever happens, the old or the new one is there, and it is on the disk."""
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_name(f".{file.name}.{os.getpid()}.part")
    with part.open("w", encoding="utf-8", newline="") as handle:
        handle.write(text)
        handle.flush()
        os.fsync(handle.fileno())
    part.replace(file)
    sync_folder(file.parent)


def sync_folder(folder: Path) -> None:
    """Put a folder's entries on the disk (a rename or a new file is lost without)."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
