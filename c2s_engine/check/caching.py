"""Files in the cache folder: written whole or not at all; a cache that cannot be written is done without."""

import contextlib
import os
import tempfile
from pathlib import Path

from c2s_engine import paths

may_write = True
"""Whether caches may be written: false in a confined child."""


def write(path: Path, data: bytes) -> None:
    """Write a cache file whole, or leave it."""
    if not may_write:
        return
    with contextlib.suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
            file.write(data)
        os.replace(file.name, path)


def writable() -> bool:
    """Whether the cache folder is there, or can be made, and can be written."""
    folder = paths.cache_folder()
    with contextlib.suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
    return may_write and folder.is_dir() and os.access(folder, os.W_OK)
