"""The server's handles on its processes: zygotes that fork, and the children that they forked."""

import asyncio
import contextlib
import json
import os
import signal
import socket
from typing import Any

from c2s_engine.check import wire
from c2s_engine.check.ahead import Ahead, end, seen
from c2s_engine.check.zygote import NOW, SPARE


class Zygote:
    """A warm process that forks on demand."""

    def __init__(self, control: socket.socket, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.control, self.reader, self.writer = control, reader, writer
        self.alive = True
        self.parent: Zygote | None = None
        self.grown: dict[str, Any] = {}
        self.warm = asyncio.Event()
        self.spare: asyncio.Task[Child] | None = None
        self.ahead = Ahead(self)
        self._waiting: dict[int, asyncio.Future[int]] = {}
        self._task = asyncio.create_task(self._watch())

    @classmethod
    async def over(cls, control: socket.socket) -> "Zygote":
        control.setblocking(False)
        reader, writer = await asyncio.open_connection(sock=control)
        return cls(control, reader, writer)

    async def _watch(self) -> None:
        """Take in how children ended, until the zygote is gone."""
        with contextlib.suppress(ConnectionError, ValueError):
            while line := await self.reader.readline():
                message = json.loads(line)
                if "warm" in message:
                    self.warm.set()
                    continue
                waiting = self._waiting.pop(message["pid"], None)
                if waiting is not None and not waiting.done():
                    waiting.set_result(message["status"])
        self.alive = False
        self.warm.set()
        for future in self._waiting.values():
            if not future.done():
                future.set_result(-1)

    def prepare(self) -> None:
        """Have a child forked ahead of the next job."""
        if self.alive and self.spare is None:
            self.spare = asyncio.create_task(self.fork(SPARE))
            self.spare.add_done_callback(seen)

    def drop_spare(self) -> None:
        """Do without the children that were forked ahead."""
        self.ahead.drop()
        spare, self.spare = self.spare, None
        if spare is not None:
            end(spare)

    async def spawn(self, job: dict[str, Any], blob: bytes = b"") -> "Child":
        """Give a job to the spare child or one that is forked now; raises wire.Closed where the zygote is gone."""
        await self.warm.wait()
        spare, self.spare = self.spare, None
        child: Child | None = None
        if spare is not None:
            with contextlib.suppress(wire.Closed):
                child = await spare
        if child is None or child.gone:
            child = await self.fork(NOW)
        await child.give(job, blob)
        return child

    @property
    def has_spare(self) -> bool:
        """Whether a child that was forked ahead is ready."""
        return self.spare is not None and self.spare.done()

    async def fork(self, when: bytes = NOW) -> "Child":
        """A child without a job; raises wire.Closed where the zygote is gone."""
        ours, theirs = socket.socketpair()
        try:
            socket.send_fds(self.control, [when], [theirs.fileno()])
        except OSError:
            self.alive = False
            ours.close()
            raise wire.Closed from None
        finally:
            theirs.close()
        ours.setblocking(False)
        reader, writer = await asyncio.open_connection(sock=ours, limit=1 << 20)
        child = Child(self, ours, reader, writer)
        try:
            header, _ = await wire.read(reader)
            child.pid = int(header["pid"])
            child.ended = asyncio.get_running_loop().create_future()
            self._waiting[child.pid] = child.ended
        except BaseException as error:
            child.kill()
            if isinstance(error, OSError | KeyError | ValueError):
                raise wire.Closed from None
            raise
        return child

    def close(self) -> None:
        self.drop_spare()
        self._task.cancel()
        self.writer.close()
        self.alive = False


class Child:
    """A forked process with the socket over which it reports."""

    def __init__(
        self, zygote: Zygote, sock: socket.socket, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self.zygote, self.sock, self.reader, self.writer = zygote, sock, reader, writer
        self.pid = 0
        self.ended: asyncio.Future[int] | None = None

    @property
    def gone(self) -> bool:
        return self.ended is None or self.ended.done()

    async def give(self, job: dict[str, Any], blob: bytes) -> None:
        """Send a job; where that fails, kill it and raise wire.Closed."""
        try:
            self.writer.write(wire.encode(job, blob))
            await self.writer.drain()
        except BaseException as error:
            self.kill()
            if isinstance(error, OSError):
                raise wire.Closed from None
            raise

    def kill(self) -> None:
        """Kill it with all that it started, and close the socket."""
        if self.pid and self.ended is not None and not self.ended.done():
            for target in (os.killpg, os.kill):
                with contextlib.suppress(ProcessLookupError, PermissionError):
                    target(self.pid, signal.SIGKILL)
        self.writer.close()

    async def status(self) -> int:
        """How it ended, as waitpid says; -1 where nobody knows."""
        if self.ended is None:
            return -1
        try:
            return await asyncio.wait_for(asyncio.shield(self.ended), 5)
        except TimeoutError:
            return -1

    def becomes_zygote(self, grown: dict[str, Any]) -> Zygote:
        """The handle on a child that has become a zygote itself, and has said so in the message `grown`."""
        zygote = Zygote(self.sock, self.reader, self.writer)
        zygote.grown = grown
        zygote.parent = self.zygote
        zygote.warm.set()
        return zygote
