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
_unions: dict[tuple, tuple[tuple, Any]] = {}
_remember = False


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

    digest, chosen = hashlib.blake2b(path.read_bytes()).digest(), deterministicHash(options, digest_size=8)
    cached = paths.cache_folder() / "maps" / digest.hex()[:24] / f"network{cls.pickledExt}"
    try:
        return cls.fromPickle(cached, originalDigest=digest, optionsDigest=chosen)
    except (OSError, pickle.UnpicklingError, cls.DigestMismatchError):
        network = original(cls, path, useCache=False, writeCache=False, **options)
    _unsaved.append((network, cached, struct.pack("<I", cls._currentFormatVersion()) + digest + chosen))
    if not save_later:
        save()
    return network


def union(original: Callable[..., Any]) -> Callable[..., Any]:
    """Scenic's polygonUnion, `original`: a union that `prepare` made is not made again. Polygons do not change."""

    def found_or_made(polys: Any, *args: Any, **kwargs: Any) -> Any:
        parts = tuple(polys)
        key = (tuple(map(id, parts)), args, tuple(kwargs.items()))
        known = _unions.get(key)
        if known is not None:
            return known[1]
        made = original(parts, *args, **kwargs)
        if _remember:
            _unions[key] = parts, made
        return made

    return found_or_made


def prepare(network: Any) -> None:
    """Make once what the world model makes of a network each time that it is executed: roads with their shoulders."""
    global _remember
    _remember = True
    try:
        network.drivableRegion.union(network.shoulderRegion)
    finally:
        _remember = False


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
