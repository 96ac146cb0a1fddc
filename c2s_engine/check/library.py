"""The compiled code of Scenic's own library modules: from memory, the disk cache, or the compiler.

To compile them takes more than a second. Where the cache lacks them, a process forked for that does it (`ahead`) while
maps are read and programs are parsed; who needs them meanwhile waits for its end (`wait`).
"""

import contextlib
import functools
import hashlib
import importlib
import marshal
import os
import pickle
import sys
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

from c2s_engine import driving, paths
from c2s_engine.check import caching

MODULES = (
    "scenic.domains.driving.behaviors",
    "scenic.domains.driving.model",
    "scenic.simulators.carla.behaviors",
    "scenic.simulators.carla.model",
)
REHEARSALS = tuple(Path(__file__).with_name(f"{name}.scenic") for name in ("rehearsal", "rehearsal_objects"))
Compiled = tuple[Any, list, bytes]  # code, requirements, digest
_code: dict[tuple[bytes, str], Compiled] = {}
_coming: int | None = None  # a pipe that ends with the process that compiles the library


def code(source: bytes, filename: str) -> Compiled:
    """The compiled code of one module of the library."""
    key = (hashlib.blake2b(source, digest_size=16).digest(), filename)
    if key not in _code:
        cached = _cache(key)
        _code[key] = _read(cached) or (wait() and _read(cached)) or _compile(source, filename, cached)
    return _code[key]


def load() -> None:
    """Have the code of all modules in memory."""
    for path in _sources():
        if path != driving.path() or not fault():
            code(path.read_bytes(), str(path))


@functools.cache
def fault() -> str:
    """What is wrong with the driving library, with its file and line; empty where it compiles."""
    from c2s_engine.check import diagnose

    path = driving.path()
    try:
        code(path.read_bytes(), str(path))
    except Exception as error:
        found = diagnose.diagnose(error, "parse", diagnose.Program(path.read_text(encoding="utf-8"), str(path)))
        return str(driving.BrokenLibrary(found.line or 1, found.message))
    return ""


def ahead(begin: Callable[[], None]) -> int:
    """Load all modules, or fork a process that compiles them and calls `begin` at its start; its id, 0 for none."""
    global _coming
    if all(_cache(_key(path)).exists() for path in _sources()) or not caching.writable():
        load()
        return 0
    reading, writing = os.pipe()
    pid = os.fork()
    if pid == 0:
        with contextlib.suppress(Exception):
            begin()
            os.close(reading)
            load()
        os._exit(0)
    os.close(writing)
    _coming = reading
    return pid


def wait() -> bool:
    """Wait for the process that compiles the library; False where there is none, or it was waited for before."""
    global _coming
    pipe, _coming = _coming, None
    if pipe is None:
        return False
    with contextlib.suppress(OSError):
        os.read(pipe, 1)
        os.close(pipe)
    return True


def _compile(source: bytes, filename: str, cached: Path) -> Compiled:
    import ast

    from c2s_engine.check import pieces, world

    tree = pieces.parse(source.decode(), filename)
    if Path(filename) not in REHEARSALS:
        world.keep(source, tree)
    python, requirements, _ = pieces.translate(tree, filename, [], 0)
    digest = hashlib.blake2b(ast.dump(python).encode(), digest_size=4).digest()
    compiled = compile(python, filename, "exec")
    caching.write(cached, marshal.dumps(compiled) + pickle.dumps(requirements) + pickle.dumps(digest))
    return compiled, requirements, digest


def _read(cached: Path) -> Compiled | None:
    try:
        with cached.open("rb") as file:
            return marshal.load(file), pickle.load(file), pickle.load(file)
    except (OSError, ValueError, EOFError, TypeError, pickle.UnpicklingError, AttributeError):
        return None


def _key(path: Path) -> tuple[bytes, str]:
    return hashlib.blake2b(path.read_bytes(), digest_size=16).digest(), str(path)


def _cache(key: tuple[bytes, str]) -> Path:
    tag = hashlib.blake2b(repr((key, version("scenic"), sys.version)).encode(), digest_size=16).hexdigest()
    return paths.cache_folder() / "modules" / f"{tag}.bin"


@functools.cache
def _sources() -> tuple[Path, ...]:
    found = []
    for name in MODULES:
        package, _, last = name.rpartition(".")
        found.append(Path(importlib.import_module(package).__file__ or "").parent / f"{last}.scenic")
    return (*found, driving.path(), *REHEARSALS)
