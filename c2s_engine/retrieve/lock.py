"""A lock between processes on the index folder; the system lets go of it when its holder dies."""

import fcntl
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from c2s_engine.retrieve.errors import RetrievalError, storage_error


@contextmanager
def exclusive(folder: Path, patience: float = 120.0) -> Iterator[None]:
    """Hold the folder's lock; waits up to `patience` s for another process, then raises RetrievalError."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        handle = os.open(folder / "lock", os.O_RDWR | os.O_CREAT, 0o644)
    except OSError as error:
        raise storage_error(error, folder) from None
    try:
        deadline = time.monotonic() + patience
        while True:
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() > deadline:
                    holder = os.pread(handle, 20, 0).decode(errors="replace").strip() or "unknown"
                    raise RetrievalError(
                        f"Another c2s (process {holder}) is writing the index; wait for it or stop it, then try again."
                    ) from None
                time.sleep(0.05)
        os.ftruncate(handle, 0)
        os.pwrite(handle, str(os.getpid()).encode(), 0)
        yield
    finally:
        os.close(handle)
