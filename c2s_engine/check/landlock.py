"""Landlock through ctypes: this process may read the given paths, and nothing else of the file system."""

import ctypes
import functools
import os
import sys
from pathlib import Path
from typing import Any

from c2s_engine import driving, paths

_CREATE, _ADD, _RESTRICT = 444, 445, 446
_ALL = 0x1FFF  # every right of the first version of the interface
_READ_FILE, _READ_DIR, _EXECUTE = 1 << 2, 1 << 3, 1 << 0
_SYSTEM = ("/usr/lib", "/usr/lib64", "/lib", "/lib64", "/usr/share/zoneinfo", "/dev/null", "/dev/urandom")
MAPS = 200  # at most so many maps beside a program


class _Ruleset(ctypes.Structure):
    _fields_ = [("handled_access_fs", ctypes.c_uint64)]


class _Beneath(ctypes.Structure):
    _pack_ = 1
    _fields_ = [("allowed_access", ctypes.c_uint64), ("parent_fd", ctypes.c_int32)]


@functools.cache
def always() -> tuple[str, ...]:
    """What every job may read."""
    own = Path(__file__).resolve().parents[1]
    libraries = [p for p in sys.path if p and os.path.isabs(p) and p != str(own.parent)]
    cache = [str(paths.cache_folder() / name) for name in ("maps", "modules")]
    found = (*_SYSTEM, sys.prefix, sys.base_prefix, *libraries, str(own), str(paths.shipped()), *cache)
    return tuple(dict.fromkeys(p for p in found if os.path.exists(p)))


def readable(job: dict[str, Any]) -> list[str]:
    """The paths that a job may read: Python, Scenic, this package, map caches, the map that the program names,
    and what lies beside it."""
    folder = Path(job["filename"]).parent
    maps: list[str] = []
    if folder.is_dir():
        with os.scandir(folder) as entries:
            maps = [e.path for e in entries if e.name.endswith((".xodr", ".snet", ".net", driving.FILE))][:MAPS]
    named = job.get("map") or ""
    return [*always(), *maps, *([named] if named.lower().endswith(".xodr") and os.path.exists(named) else [])]


def restrict(allowed: list[str]) -> bool:
    """Restrict this process for good; False where the kernel has no Landlock."""
    try:
        libc = ctypes.CDLL(None, use_errno=True)
        attributes = _Ruleset(_ALL)
        ruleset = libc.syscall(_CREATE, ctypes.byref(attributes), ctypes.sizeof(attributes), 0)
        if ruleset < 0:
            return False
        for path in allowed:
            _allow(libc, ruleset, path)
        ok = libc.prctl(38, 1, 0, 0, 0) == 0 and libc.syscall(_RESTRICT, ruleset, 0) == 0
        os.close(ruleset)
    except (OSError, AttributeError):
        return False
    return ok


def _allow(libc: Any, ruleset: int, path: str) -> None:
    try:
        fd = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    rights = _READ_FILE | _READ_DIR | _EXECUTE if os.path.isdir(path) else _READ_FILE
    rule = _Beneath(rights, fd)
    libc.syscall(_ADD, ruleset, 1, ctypes.byref(rule), 0)
    os.close(fd)
