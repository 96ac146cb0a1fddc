"""The front's side of the check server: starts it, sends requests, restarts it when it dies. Imports no Scenic."""

import asyncio
import contextlib
import itertools
import json
import os
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from c2s_engine.check.protocol import (
    CheckReport,
    CheckRequest,
    ImportRequest,
    ImportResult,
    PlacesReport,
    PlacesRequest,
)

LINE = 256 << 20  # bytes of the longest report
Pending = dict[int, asyncio.Future[dict[str, Any]]]


class CheckError(RuntimeError):
    """A request that the check server could not answer; the message says why."""


class CheckClient:
    """The check server as an object: several requests at a time, each cancellable.

    `runner` is "module:function" that runs a sampled scene (in the check process); `standins` is the folder with the
    stand-ins for carla and verifai (default: the shipped one).
    """

    def __init__(self, runner: str | None = None, standins: Path | None = None) -> None:
        self.runner = runner
        self.standins = standins
        self._process: asyncio.subprocess.Process | None = None
        self._reading: asyncio.Task[None] | None = None
        self._pending: Pending = {}  # of the server that runs now
        self._ending: set[asyncio.Task[None]] = set()
        self._ids = itertools.count(1)
        self._starting = asyncio.Lock()
        self._ready = asyncio.Event()

    async def __aenter__(self) -> "CheckClient":
        await self.start()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    async def start(self) -> None:
        """Start the server; it warms up (about 2 s) while requests may already be sent."""
        async with self._starting:
            if self._process is not None and self._process.returncode is None and not self._gone():
                return
            command = [sys.executable, "-m", "c2s_engine.check.server"]
            if self.runner:
                command += ["--runner", self.runner]
            if self.standins:
                command += ["--standins", str(self.standins)]
            self._ready = asyncio.Event()
            self._process = await asyncio.create_subprocess_exec(
                *command,
                stdin=asyncio.subprocess.PIPE,
                stdout=asyncio.subprocess.PIPE,
                stderr=None if os.environ.get("C2S_CHECK_DEBUG") else asyncio.subprocess.DEVNULL,
                limit=LINE,
            )
            self._pending = {}
            self._reading = asyncio.create_task(self._read(self._process, self._pending))

    @property
    def pid(self) -> int:
        """The server's process; 0 where there is none."""
        return self._process.pid if self._process is not None else 0

    def _gone(self) -> bool:
        return self._reading is None or self._reading.done()

    async def ready(self) -> None:
        """Wait until the server has warmed up."""
        await self.start()
        await self._ready.wait()

    async def check(self, request: CheckRequest) -> CheckReport:
        """Check a program. Cancelling kills its process; raises CheckError where the server itself fails."""
        return CheckReport.model_validate(await self._ask("check", request.model_dump(mode="json")))

    async def places(self, request: PlacesRequest) -> PlacesReport:
        """Count the places of a map that expressions match; raises CheckError where the map cannot be read."""
        return PlacesReport.model_validate(await self._ask("places", request.model_dump(mode="json")))

    async def expect(self, map_path: Path) -> None:
        """Say which map the next requests are likely to need: it is read meanwhile. Nothing is answered."""
        await self.start()
        if self._process is not None and self._process.stdin is not None:
            message = {"id": next(self._ids), "kind": "expect", "body": {"map": str(map_path)}}
            with contextlib.suppress(OSError, RuntimeError):
                self._process.stdin.write(json.dumps(message).encode() + b"\n")
                await self._process.stdin.drain()

    async def import_program(self, text: str, filename: str = "program.scenic") -> ImportResult:
        """Decompose a Scenic program into S; raises CheckError, with the line, where it cannot be parsed."""
        request = ImportRequest(text=text, filename=filename)
        result = ImportResult.model_validate(await self._ask("import", request.model_dump(mode="json")))
        if result.structure is None:
            first = result.diagnostics[0]
            where = f"line {first.line}: " if first.line else ""
            raise CheckError(f"{where}{first.message}")
        return result

    async def close(self) -> None:
        """Stop the server and all that it forked."""
        process, self._process = self._process, None
        if process is None:
            return
        if process.stdin:
            process.stdin.close()
        try:
            await asyncio.wait_for(process.wait(), 5)
        except TimeoutError:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            await process.wait()
        if self._reading:
            await asyncio.wait({self._reading})

    async def _ask(self, kind: str, body: dict[str, Any]) -> Any:
        await self.start()
        process, pending = self._process, self._pending
        if process is None or process.stdin is None:
            raise CheckError("the check server is closed")
        key = next(self._ids)
        future = pending[key] = asyncio.get_running_loop().create_future()
        try:
            process.stdin.write(json.dumps({"id": key, "kind": kind, "body": body}).encode() + b"\n")
            await process.stdin.drain()
            answer = await future
        except asyncio.CancelledError:
            with contextlib.suppress(OSError, RuntimeError):
                process.stdin.write(json.dumps({"id": key, "kind": "cancel"}).encode() + b"\n")
            raise
        except ConnectionError:
            raise CheckError(f"the check server stopped during a {kind} request and restarts: try again") from None
        finally:
            pending.pop(key, None)
        if not answer.get("ok"):
            raise CheckError(answer.get("error") or "the check server gave no reason")
        return answer["body"]

    async def _read(self, process: asyncio.subprocess.Process, pending: Pending) -> None:
        assert process.stdout is not None
        ready = self._ready
        with contextlib.suppress(ConnectionError, ValueError):
            while line := await process.stdout.readline():
                message = json.loads(line)
                if message.get("ready"):
                    ready.set()
                    continue
                if message.get("lost"):
                    self._leave(process)
                    continue
                future = pending.get(message["id"])
                if future is not None and not future.done():
                    future.set_result(message)
        ready.set()
        for future in list(pending.values()):
            if not future.done():
                future.set_exception(ConnectionResetError())
        if process.stdin is not None:
            process.stdin.close()

    def _leave(self, process: asyncio.subprocess.Process) -> None:
        """Send nothing more to a server that is ending; what it still answers is taken."""
        if self._process is process and self._reading is not None:
            self._process = None
            self._ending.add(self._reading)
            self._reading.add_done_callback(self._ending.discard)


class SyncCheckClient:
    """The same for code without an event loop (tests, benchmark processes)."""

    def __init__(self, runner: str | None = None, standins: Path | None = None) -> None:
        self._loop = asyncio.new_event_loop()
        self._client = self._do(_made(lambda: CheckClient(runner, standins)))
        self._do(self._client.start())

    def _do(self, work: Awaitable[Any]) -> Any:
        return self._loop.run_until_complete(work)

    def __enter__(self) -> "SyncCheckClient":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def ready(self) -> None:
        self._do(self._client.ready())

    @property
    def pid(self) -> int:
        """The server's process."""
        return self._client.pid

    def check(self, request: CheckRequest) -> CheckReport:
        return self._do(self._client.check(request))

    def expect(self, map_path: Path) -> None:
        self._do(self._client.expect(map_path))

    def import_program(self, text: str, filename: str = "program.scenic") -> ImportResult:
        return self._do(self._client.import_program(text, filename))

    def places(self, request: PlacesRequest) -> PlacesReport:
        return self._do(self._client.places(request))

    def close(self) -> None:
        """Stop the server and the loop."""
        if not self._loop.is_closed():
            self._do(self._client.close())
            self._loop.close()


async def _made(make: Callable[[], CheckClient]) -> CheckClient:
    return make()
