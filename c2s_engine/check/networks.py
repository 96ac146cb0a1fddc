"""Road networks as Scenic parses them, kept in memory and in the cache folder: what Network.fromFile does here."""

import gzip
import hashlib
import mmap
import os
import pickle
import struct
import sys
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

from c2s_engine import paths
from c2s_engine.check import caching, packing
from c2s_engine.maps.extras import read_extras
from c2s_engine.maps.opendrive import BrokenMap, refuse_large

COMPRESSION = 6  # of gzip: level 9, Scenic's own, takes five times as long for a file of the same size
_networks: dict[tuple, Any] = {}
_unsaved: list[tuple[Any, Path, Path | None, bytes]] = []
save_later = False
"""Whether networks that were parsed wait for `save`."""
_unions: dict[tuple, tuple[tuple, Any]] = {}
_made: list[tuple] = []
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


def known() -> list[tuple[str, Any]]:
    """The networks in memory, with the paths of their files."""
    return [(key[0], network) for key, network in _networks.items()]


def _load(original: Callable[..., Any], cls: Any, path: Path, options: dict[str, Any]) -> Any:
    """The network from the cache; else parsed, and to be saved there."""
    from scenic.core.serialization import deterministicHash

    refuse_large(path)
    digest, chosen = hashlib.blake2b(path.read_bytes()).digest(), deterministicHash(options, digest_size=8)
    folder = paths.cache_folder() / "maps" / digest.hex()[:24]
    cached, packed = folder / f"network{cls.pickledExt}", folder / f"network-{_tag(cls, digest + chosen)}.packed"
    try:
        with packed.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            network, unions = packing.unpack(data)
        _unions.update((_union_key(*made[:-1]), (made[0], made[-1])) for made in unions)
        return network
    except (OSError, ValueError, pickle.UnpicklingError):  # ValueError: of mmap, where it is empty
        pass
    head = struct.pack("<I", cls._currentFormatVersion()) + digest + chosen
    try:
        network = cls.fromPickle(cached, originalDigest=digest, optionsDigest=chosen)
        _unsaved.append((network, packed, None, b""))
    except (OSError, pickle.UnpicklingError, cls.DigestMismatchError):
        network = _parsed(original, cls, path, options)
        _unsaved.append((network, packed, cached, head))
    if not save_later:
        save()
    return network


def _parsed(original: Callable[..., Any], cls: Any, path: Path, options: dict[str, Any]) -> Any:
    """The network from its file; raises BrokenMap. Scenic's parser expands entities and hangs on what is too large, so
    that the file is read with care first."""
    from scenic.core.errors import ScenicError

    try:
        read_extras(path)
        return original(cls, path, useCache=False, writeCache=False, **options)
    except (BrokenMap, ScenicError):
        raise
    except Exception as error:
        what = f" ({type(error).__name__}: {error})"[:200] if str(error) else ""
        raise BrokenMap(
            f"Scenic cannot read the map {path.name}: its roads and links do not fit together{what}"
        ) from error


def _tag(cls: Any, digest: bytes) -> str:
    """What else a packed network depends on."""
    versions = [sys.version, *map(version, ("scenic", "shapely", "numpy")), packing.FORMAT, cls._currentFormatVersion()]
    return hashlib.blake2b(digest + repr(versions).encode(), digest_size=8).hexdigest()


def union(original: Callable[..., Any]) -> Callable[..., Any]:
    """Scenic's polygonUnion, `original`: a union that `prepare` made is not made again. Polygons do not change."""

    def found_or_made(polys: Any, *args: Any, **kwargs: Any) -> Any:
        parts = tuple(polys)
        key = _union_key(parts, args, kwargs)
        known = _unions.get(key)
        made = original(parts, *args, **kwargs) if known is None else known[1]
        if _remember:
            _unions[key] = parts, made
            _made.append((parts, args, kwargs, made))
        return made

    return found_or_made


def _union_key(parts: tuple, args: tuple, kwargs: dict[str, Any]) -> tuple:
    return tuple(map(id, parts)), args, tuple(kwargs.items())


def prepare(network: Any) -> list[tuple]:
    """Make once what the world model makes of a network each time that it is executed: roads with their shoulders.

    Gives what was made: the parts, the further arguments, the union.
    """
    global _remember
    _made.clear()
    _remember = True
    try:
        network.drivableRegion.union(network.shoulderRegion)
    finally:
        _remember = False
    return list(_made)


def save() -> None:
    """Write the networks that were parsed to the cache: packed, and as Scenic reads them."""
    for network, packed, plain, head in _unsaved if caching.may_write else ():
        caching.write(packed, packing.pack((network, prepare(network))))
        if plain is not None:
            caching.write(plain, head + gzip.compress(pickle.dumps(network), COMPRESSION))
    _unsaved.clear()


def save_apart() -> int:
    """The same in a process of its own that outlives this one for some seconds; its id, 0 for none."""
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
