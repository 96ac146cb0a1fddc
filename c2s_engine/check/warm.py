"""What is loaded once before anything is checked: Scenic, its library's code, maps; and the hooks that keep them."""

import functools
import gc
import hashlib
import importlib
import marshal
import os
import pickle
import random
import sys
import tempfile
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

from c2s_engine import paths
from c2s_engine.check import landlock

LIBRARY = (
    "scenic.domains.driving.behaviors",
    "scenic.domains.driving.model",
    "scenic.simulators.carla.behaviors",
    "scenic.simulators.carla.model",
)
REHEARSAL = Path(__file__).with_name("rehearsal.scenic")
_code: dict[tuple[bytes, str], tuple[Any, list, bytes]] = {}
_networks: dict[tuple, Any] = {}
_prepare: Callable[[Any, str], None] | None = None
may_write = True
"""Whether map caches may be written: false in a confined child."""


def warm(standins: Path, runner: str | None = None) -> None:
    """Load everything that checks share. Call it once, in a process without threads."""
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ[name] = "1"
    if standins.is_dir():
        sys.path.insert(0, str(standins))
    import scenic.syntax.translator as translator
    from scenic.core import type_support
    from scenic.domains.driving import roads

    translator.compileStream = _compile_stream
    type_support.saveErrorLocation = _error_location
    roads.Network.fromFile = classmethod(_from_file(roads.Network.fromFile.__func__))
    for name in (
        "scenic.domains.driving.actions", "scenic.domains.driving.simulators", "scenic.domains.driving.workspace",
        "scenic.simulators.carla.actions", "scenic.simulators.carla.blueprints", "scenic.simulators.carla.sensors",
        "scenic.simulators.carla.simulator", "scenic.simulators.utils.colors", "scenic.core.pruning", "scipy.spatial",
    ):  # fmt: skip
        importlib.import_module(name)
    for name in LIBRARY:
        spec = Path(importlib.import_module(name.rpartition(".")[0]).__file__ or "").parent
        path = str(spec / f"{name.rpartition('.')[2]}.scenic")
        library_code(Path(path).read_bytes(), path)
    library_code(REHEARSAL.read_bytes(), str(REHEARSAL))
    landlock.always()
    if runner:
        global _prepare
        _prepare = getattr(importlib.import_module(runner.partition(":")[0]), "prepare", None)
        prepare()
    gc.collect()
    gc.freeze()
    gc.disable()


def prepare(network: Any = None, path: str = "") -> None:
    """Let the runner make what its runs share: once at the start, and for each map that is loaded to be kept."""
    if _prepare is not None:
        _prepare(network, path)


def reseed(seed: int) -> None:
    """Set every random state that Scenic draws from."""
    import numpy

    random.seed(seed)
    numpy.random.seed(seed % (1 << 32))


def library_code(source: bytes, filename: str) -> tuple[Any, list, bytes]:
    """The compiled code of a Scenic library module, from memory, the disk cache or the compiler."""
    key = (hashlib.blake2b(source, digest_size=16).digest(), filename)
    if key in _code:
        return _code[key]
    from c2s_engine.check.pieces import compile_text

    tag = hashlib.blake2b(repr((key, version("scenic"), sys.version)).encode(), digest_size=16).hexdigest()
    cached = paths.cache_folder() / "modules" / f"{tag}.bin"
    try:
        with cached.open("rb") as file:
            _code[key] = (marshal.load(file), pickle.load(file), pickle.load(file))
            return _code[key]
    except (OSError, ValueError, EOFError, TypeError, pickle.UnpicklingError, AttributeError):
        pass
    tree, requirements, digest = compile_text(source.decode(), filename)
    _code[key] = (compile(tree, filename, "exec"), requirements, digest)
    if may_write:
        write_cache(cached, marshal.dumps(_code[key][0]) + pickle.dumps(requirements) + pickle.dumps(digest))
    return _code[key]


def write_cache(path: Path, data: bytes) -> None:
    """Write a cache file whole or not at all; a cache that cannot be written is done without."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
            file.write(data)
        os.replace(file.name, path)
    except OSError:
        pass


def _error_location() -> Any:
    """Scenic's saveErrorLocation without reading sources: the innermost frame outside Scenic's core."""
    import traceback

    frame = sys._getframe(1)
    while frame is not None:
        name = frame.f_code.co_filename
        if not (_is_hidden(name)):
            return traceback.FrameSummary(name, frame.f_lineno, frame.f_code.co_name, lookup_line=False)
        frame = frame.f_back  # type: ignore[assignment]
    return None


@functools.cache
def _is_hidden(filename: str) -> bool:
    from scenic.core import errors

    parents = Path(filename).parents
    return filename in errors.hiddenFolders or any(folder in parents for folder in errors.hiddenFolders)


def _compile_stream(stream: Any, namespace: dict, options: Any, filename: str) -> tuple[Any, str]:
    """Scenic's compileStream with the parsing and compiling left out where the source is known."""
    from scenic.syntax import translator, veneer

    veneer.activate(options, namespace)
    try:
        exec(compile(translator.preamble, "<veneer>", "exec"), namespace)
        namespace[translator.namespaceReference] = namespace
        code, requirements, digest = library_code(stream.read(), filename)
        translator.executeCodeIn(code, namespace)
        translator.storeScenarioStateIn(namespace, requirements, digest, options)
    finally:
        veneer.deactivate()
    return code, ""


def _from_file(original: Any) -> Any:
    def from_file(cls: Any, path: Any, useCache: bool = True, writeCache: bool = True, **options: Any) -> Any:
        """Network.fromFile, from memory where the file is known, and with the .snet in the cache folder."""
        real = Path(path)
        if real.suffix != ".xodr":
            return original(cls, path, useCache=useCache, writeCache=False, **options)
        stat = real.stat()
        key = (os.path.realpath(real), stat.st_mtime_ns, stat.st_size, repr(sorted(options.items())))
        if key not in _networks:
            copy = _cached_copy(real)
            _networks[key] = original(cls, copy, useCache=True, writeCache=may_write and copy != real, **options)
        return _networks[key]

    return from_file


def _cached_copy(path: Path) -> Path:
    data = path.read_bytes()
    folder = paths.cache_folder() / "maps" / hashlib.blake2b(data, digest_size=12).hexdigest()
    copy = folder / path.name
    if not copy.exists() and may_write:
        write_cache(copy, data)
    return copy if copy.exists() else path
