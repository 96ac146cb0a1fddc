"""Road networks as Scenic parses them, kept in memory and in the cache folder: what Network.fromFile does here."""

import gzip
import hashlib
import os
import pickle
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

from c2s_engine import paths
from c2s_engine.check import caching

COMPRESSION = 6  # of gzip: level 9, Scenic's own, takes five times as long for a file of the same size
_networks: dict[tuple, Any] = {}
_unsaved: list[tuple[Any, Path, bytes]] = []
save_later = False
"""Whether networks that were parsed wait for `save`."""


def from_file(original: Callable[..., Any]) -> Callable[..., Any]:
    """Scenic's Network.fromFile, `original`, with the caches."""

    def load(cls: Any, path: Any, useCache: bool = True, writeCache: bool = True, **options: Any) -> Any:
        """Network.fromFile, from memory where the file is known, and with the .snet in the cache folder."""
        real = Path(path)
        if real.suffix != ".xodr":
            return original(cls, path, useCache=useCache, writeCache=False, **options)
        stat = real.stat()
        key = (os.path.realpath(real), stat.st_mtime_ns, stat.st_size, repr(sorted(options.items())))
        if key not in _networks:
            _networks[key] = _load(original, cls, real, options)
        return _networks[key]

    return load


def _load(original: Callable[..., Any], cls: Any, path: Path, options: dict[str, Any]) -> Any:
    """The network from the cache; else parsed, and to be saved there."""
    from scenic.core.serialization import deterministicHash

    data = path.read_bytes()
    digest, chosen = hashlib.blake2b(data).digest(), deterministicHash(options, digest_size=8)
    copy = _cached_copy(path, data)
    cached = copy.with_suffix(cls.pickledExt)
    try:
        return cls.fromPickle(cached, originalDigest=digest, optionsDigest=chosen)
    except (OSError, pickle.UnpicklingError, cls.DigestMismatchError):
        network = original(cls, copy, useCache=False, writeCache=False, **options)
    if copy != path:
        _unsaved.append((network, cached, struct.pack("<I", cls._currentFormatVersion()) + digest + chosen))
        if not save_later:
            save()
    return network


def save() -> None:
    """Write the networks that were parsed to the cache, as Scenic reads them."""
    for network, path, head in _unsaved:
        caching.write(path, head + gzip.compress(pickle.dumps(network), COMPRESSION))
    _unsaved.clear()


def save_apart() -> int:
    """The same in a process of its own that outlives this one for about a second; its id, 0 for none."""
    if not _unsaved or not caching.may_write:
        return 0
    pid = os.fork()
    if pid == 0:
        try:
            os.setsid()
            os.closerange(3, 256)  # nobody is to take this process for the one that it was forked from
            save()
        finally:
            os._exit(0)
    _unsaved.clear()
    return pid


def _cached_copy(path: Path, data: bytes) -> Path:
    folder = paths.cache_folder() / "maps" / hashlib.blake2b(data, digest_size=12).hexdigest()
    copy = folder / path.name
    if not copy.exists():
        caching.write(copy, data)
    return copy if copy.exists() else path
