"""The errors of this room: each is one sentence that says what to do."""

import errno
from pathlib import Path


class RetrievalError(Exception):
    """Something about the index or a document that the user can act on."""


class BadDocument(RetrievalError):
    """A file, folder or address that cannot be indexed."""


def storage_error(error: BaseException, folder: Path) -> RetrievalError:
    """What the operating system (or LanceDB in its words) says about the index's folder, as one sentence."""
    number = error.errno if isinstance(error, OSError) else None
    text = str(error).lower()
    if number in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG) or "no space left" in text or "file too large" in text:
        return RetrievalError(
            f"The disk that holds {folder} is full: the index was left as it was; free some space and try again."
        )
    if number in (errno.EACCES, errno.EPERM, errno.EROFS) or "permission denied" in text or "read-only file" in text:
        return RetrievalError(
            f"{folder} cannot be written: give yourself the right to, or set XDG_DATA_HOME to a folder of yours."
        )
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return RetrievalError(
        f"The index in {folder} could not be used ({reason.splitlines()[0] if reason else type(error).__name__})."
    )
