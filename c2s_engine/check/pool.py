"""The warm processes: the root with Scenic, one a map, one a preamble, and the reader."""

import asyncio
import contextlib
import os
import socket
from collections import OrderedDict
from pathlib import Path
from typing import Any

from c2s_engine.check import wire
from c2s_engine.check.processes import Child, Zygote

MAPS = 4
PREAMBLES = 8
SPARES = 2
REST = 0.02  # s after a check: its report goes first
READ_SECONDS = 15.0
LIBRARY_SECONDS = 90.0  # a driving library beside the program is compiled with it
GROW_SECONDS = 300.0  # a large map is parsed for minutes the first time, and Scenic's library for a second or two


class TooSlow(Exception):
    """The reader did not come back within READ_SECONDS, or LIBRARY_SECONDS."""


class NotMade(Exception):
    """A warm process could not be made; the message is its reason."""


class Pool:
    """Finds or makes the warmest process to fork a job from."""

    def __init__(self, root: Zygote) -> None:
        self.root = root
        self.lost = asyncio.Event()
        self.maps: OrderedDict[Any, asyncio.Task[Zygote]] = OrderedDict()
        self.preambles: OrderedDict[Any, asyncio.Task[Zygote]] = OrderedDict()
        self.read_params: OrderedDict[tuple, frozenset[str]] = OrderedDict()
        self.why_not: dict[Any, str] = {}
        self._spared: list[Zygote] = []
        self._spared_maps: list[Zygote] = []
        self._expected: set[asyncio.Task[Zygote | None]] = set()
        self._reader: Child | None = None
        self._reading = asyncio.Lock()
        self._watch = asyncio.create_task(self._root_gone())

    @classmethod
    async def start(cls, control: socket.socket) -> "Pool":
        return cls(await Zygote.over(control))

    async def _root_gone(self) -> None:
        await self.root._task
        self.lost.set()

    def expect(self, map_path: str) -> bool:
        """Begin to read a map that a program is likely to name; False where that was begun before, or cannot be."""
        key = _file_key(map_path)
        if key is None or key in self.maps:
            return False
        task = asyncio.create_task(self._map(map_path))
        self._expected.add(task)
        task.add_done_callback(self._expected.discard)
        return True

    async def _map(self, path: str) -> Zygote | None:
        """The process that holds a map, made where it is missing."""
        key = _file_key(path)
        if key is None:
            return None
        return await self._get(self.maps, key, MAPS, self.root, {"kind": "map", "path": path})

    async def no_map(self, path: str) -> str:
        """Why a map cannot be held in memory; nothing where it can."""
        return "" if await self._map(path) is not None else self.why_not.get(_file_key(path), "it cannot be opened")

    async def read(self, request: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        """Have the reader parse a program; raises TooSlow, or wire.Closed where it dies of it."""
        task = asyncio.create_task(self._read(request))
        return await asyncio.shield(task)

    async def _read(self, request: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        async with self._reading:
            if self._reader is not None:
                with contextlib.suppress(wire.Closed):  # of something else, perhaps: a new reader decides
                    return await self._ask(self._reader, request)
            self._reader = await self.root.spawn({"kind": "reader"})
            await asyncio.wait_for(wire.read(self._reader.reader), GROW_SECONDS)  # it knows the world model by then
            return await self._ask(self._reader, request)

    async def _ask(self, reader: Child, request: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        try:
            reader.writer.write(wire.encode(request))
            seconds = LIBRARY_SECONDS if request.get("modules") else READ_SECONDS
            return await asyncio.wait_for(wire.read(reader.reader), seconds)
        except (TimeoutError, wire.Closed, ConnectionError) as error:
            reader.kill()
            self._reader = None
            if isinstance(error, TimeoutError):
                raise TooSlow from None
            raise wire.Closed from None

    async def nearest(self, map_path: str, header: dict[str, Any], job: dict[str, Any], blob: bytes) -> Zygote:
        """The zygote that has most of what a program needs, as the reader's header says; makes those that are missing.

        A snapshot after `model` also serves programs that differ in params that were not read by then.
        """
        key = _file_key(map_path)
        zygote = await self._map(map_path) or self.root
        if not header["preamble"]:
            return zygote
        shape = (key, header["preamble"], job["filename"], repr(sorted(job["params"].items())), job.get("model"))
        params = tuple(map(tuple, header["params"]))
        wanted = self._that_matter(shape, params)
        job = {**job, "kind": "preamble", "count": header["count"]}
        found = await self._get(self.preambles, (shape, wanted), PREAMBLES, zygote, job, blob)
        if found is None:
            return zygote
        self.read_params[shape] = self.read_params.get(shape, frozenset()) | frozenset(found.grown["read"])
        self.read_params.move_to_end(shape)
        while len(self.read_params) > 4 * PREAMBLES:
            self.read_params.popitem(last=False)
        return self._moved((shape, wanted), (shape, self._that_matter(shape, params)), found)

    def _that_matter(self, shape: tuple, params: tuple) -> tuple:
        """Those params that decide whether a snapshot serves: those that `model` reads, all where that is not known."""
        read = self.read_params.get(shape)
        return params if read is None else tuple(pair for pair in params if pair[0] in read)

    def _moved(self, old: tuple, new: tuple, zygote: Zygote) -> Zygote:
        """Keep a snapshot under its new key; where there is one already, that one serves."""
        task = self.preambles.pop(old, None) if old != new else None
        if task is None:
            return zygote
        there = self.preambles.setdefault(new, task)
        if there is not task and there.done() and not there.cancelled() and not there.exception():
            other = there.result()
            if other.alive:
                _drop(task)
                return other
        self.preambles[new] = task
        return zygote

    def used(self, zygote: Zygote, job: dict[str, Any], header: dict[str, Any], blob: bytes, executed: bool) -> None:
        """A check is over: fork children ahead for the next one, for the next snapshot of its map, for the next map."""
        zygote.ahead.learn(header, executed)
        self._spare(self._spared, zygote, SPARES, REST)
        asyncio.get_running_loop().call_later(REST, zygote.ahead.begin, job, header, blob)
        if zygote.parent is not None and zygote.parent is not self.root:
            self._spare(self._spared_maps, zygote.parent, 1, 2 * REST)
        asyncio.get_running_loop().call_later(3 * REST, self.root.prepare)

    def _spare(self, spared: list[Zygote], zygote: Zygote, bound: int, rest: float) -> None:
        if zygote in spared:
            spared.remove(zygote)
        spared.append(zygote)
        for old in spared[:-bound]:
            old.drop_spare()
        del spared[:-bound]
        asyncio.get_running_loop().call_later(rest, zygote.prepare)

    async def _get(
        self,
        shelf: OrderedDict[Any, asyncio.Task[Zygote]],
        key: Any,
        bound: int,
        parent: Zygote,
        job: dict[str, Any],
        blob: bytes = b"",
    ) -> Zygote | None:
        task = shelf.get(key)
        if task is not None and task.done() and (task.cancelled() or task.exception() or not _living(task)):
            task = None
        if task is None:
            task = shelf[key] = asyncio.create_task(_grow(parent, job, blob))
        shelf.move_to_end(key)
        while len(shelf) > bound:
            _, old = shelf.popitem(last=False)
            old.add_done_callback(_drop)
        try:
            return await asyncio.shield(task)
        except (NotMade, wire.Closed) as error:
            self.why_not[key] = str(error)
            return None

    def close(self) -> None:
        for expected in self._expected:
            expected.cancel()
        for shelf in (self.preambles, self.maps):
            for task in shelf.values():
                task.cancel() if not task.done() else _drop(task)
        if self._reader is not None:
            self._reader.kill()
        self.root.close()


def _living(task: asyncio.Task[Zygote]) -> bool:
    return task.result().alive


def _drop(task: asyncio.Task[Zygote]) -> None:
    if not task.cancelled() and task.exception() is None:
        task.result().close()


async def _grow(parent: Zygote, job: dict[str, Any], blob: bytes) -> Zygote:
    """Raises NotMade, or wire.Closed where the parent is gone."""
    child = await parent.spawn(job, blob)
    try:
        header, _ = await asyncio.wait_for(wire.read(child.reader), GROW_SECONDS)
        if not header.get("ready"):
            raise NotMade(str(header.get("failed") or "it gave no reason"))
    except (NotMade, TimeoutError, wire.Closed) as error:
        child.kill()
        raise error if isinstance(error, NotMade) else NotMade("it took too long, or too much memory") from None
    return child.becomes_zygote(header)


def _file_key(path: str) -> tuple | None:
    if not path or not Path(path).is_file():
        return None
    stat = os.stat(path)
    return (os.path.realpath(path), stat.st_mtime_ns, stat.st_size)
