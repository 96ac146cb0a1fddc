"""The front's side of retrieval: it starts the worker when needed, talks to it, and restarts it when it dies."""

import asyncio
import contextlib
import json
import sys
from collections import deque
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from c2s_engine.paths import data_folder
from c2s_engine.retrieve.errors import BadDocument, RetrievalError
from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Passage

Progress = Callable[[str, int, int], None]
Decompose = Callable[[str], Awaitable[Structure]]
Describe = Callable[[str, str], Awaitable[str]]
LINE = 1 << 28  # bytes of the longest message


@dataclass
class _Request:
    id: int
    method: str
    params: dict
    future: asyncio.Future
    progress: Progress | None = None
    begun: bool = False

    def line(self) -> bytes:
        return (json.dumps({"id": self.id, "method": self.method, "params": self.params}) + "\n").encode()

    def words(self) -> str:
        """The request as a sentence names it."""
        what = next((str(v) for k, v in self.params.items() if k in ("query", "location", "id")), "")
        return f"{self.method}({what[:60]!r})" if what else self.method


@dataclass
class RetrievalClient:
    """`folder`: of the index (default: in the user's data folder). `model`: another model's folder or name."""

    folder: Path | None = None
    model: str | None = None
    _process: asyncio.subprocess.Process | None = field(default=None, init=False)
    _pending: dict[int, _Request] = field(default_factory=dict, init=False)
    _tasks: list[asyncio.Task] = field(default_factory=list, init=False)
    _errors: deque = field(default_factory=lambda: deque(maxlen=20), init=False)
    _next: int = field(default=1, init=False)
    _lock: asyncio.Lock = field(default_factory=asyncio.Lock, init=False)
    _readying: asyncio.Task | None = field(default=None, init=False)
    _listeners: list[Progress] = field(default_factory=list, init=False)

    async def search(self, query: str, kind: Literal["doc", "snippet"] = "doc", component: str | None = None,
                     limit: int = 5, *, abstain: bool = True, method: str | None = None, terms: Sequence[str] = (),
                     progress: Progress | None = None) -> list[Passage]:  # fmt: skip
        """The passages for a query, best first; an empty list means that nothing fits.

        `terms`: what snippets of a component are to be about (retrieve.terms); what is about others is left out.

        `abstain=False` gives the nearest, however far. `method`: embedding, bm25, fused (default: fused for documents,
        embedding for snippets, as in the paper). The index is built first where there is none."""
        params = {
            "query": query,
            "kind": kind,
            "component": component,
            "limit": limit,
            "abstain": abstain,
            "method": method,
            "terms": list(terms),
        }
        return [Passage.model_validate(p) for p in await self._ask("search", params, progress)]

    async def embed(self, texts: Sequence[str]) -> list[list[float]]:
        """A unit vector for each text."""
        return await self._ask("embed", {"texts": list(texts)}) if texts else []

    async def ready(self, progress: Progress | None = None) -> None:
        """Have model and index loaded, the index built where it must be.

        All who wait share one request, which goes on where one of them gives up."""
        if progress:
            self._listeners.append(progress)
        try:
            if self._readying is None or self._readying.done() and _failed(self._readying):
                self._readying = asyncio.create_task(self._ask("warm", {}, self._tell))
                self._readying.add_done_callback(_failed)
            await asyncio.shield(self._readying)
        finally:
            if progress:
                self._listeners.remove(progress)

    def _tell(self, stage: str, done: int, total: int) -> None:
        for listener in self._listeners:
            listener(stage, done, total)

    async def build(self, progress: Progress | None = None) -> dict:
        """Build the index anew; `progress(stage, done, total)`. Known vectors and the user's sources are kept."""
        return await self._ask("build", {}, progress)

    async def add(self, location: str, progress: Progress | None = None, *, decompose: Decompose | None = None,
                  describe: Describe | None = None) -> dict:  # fmt: skip
        """Index a file, folder or address: {"added": [...], "refused": [sentence, ...]}; raises BadDocument.

        With `decompose` (program -> S), .scenic files also give component snippets; `describe` (component, code ->
        sentence) words them, else their own descriptions do."""
        report = await self._ask("add", {"location": location}, progress)
        if decompose is None:
            return report
        from c2s_engine.retrieve.programs import component_snippets

        for source in [s for s in report["added"] if s["location"].endswith(".scenic")]:
            path = Path(source["location"])
            try:
                parts = await component_snippets(path.read_text(errors="replace"), decompose, describe)
            except Exception as error:  # whatever the importer says of a program: it stays indexed as a text
                report["refused"].append(f"{path.name} could not be taken apart ({str(error).splitlines()[0][:120]}).")
                continue
            if parts:
                params = {"location": str(path), "title": path.stem, "snippets": parts}
                report["added"].append(await self._ask("add_snippets", params, progress))
        return report

    async def list(self) -> dict:
        """What is indexed: {"sources": [...], "model", "counts", "bytes", "folder", "stale"}."""
        return await self._ask("list", {})

    async def remove(self, id: str) -> dict:
        """Take one of the user's sources (by id or path) out of the index."""
        return await self._ask("remove", {"id": id})

    async def verify(self) -> dict:
        """Whether the index is whole and up to date: {"ok", "findings": [sentence, ...]}."""
        return await self._ask("verify", {})

    async def close(self) -> None:
        """End the worker."""
        process, self._process = self._process, None
        for task in (*self._tasks, *filter(None, [self._readying])):
            task.cancel()
        self._tasks.clear()
        self._readying = None
        if process and process.returncode is None:
            assert process.stdin
            process.stdin.close()
            try:
                await asyncio.wait_for(process.wait(), 3)
            except TimeoutError:
                process.kill()
                await process.wait()
        for request in self._pending.values():
            if not request.future.done():
                request.future.set_exception(RetrievalError("The retrieval worker was closed."))
        self._pending.clear()

    async def __aenter__(self) -> "RetrievalClient":
        return self

    async def __aexit__(self, *exc: object) -> None:
        await self.close()

    @property
    def pid(self) -> int | None:
        """The worker's process id, while it runs."""
        return self._process.pid if self._process and self._process.returncode is None else None

    async def _ask(self, method: str, params: dict, progress: Progress | None = None) -> Any:
        await self._start()
        request = _Request(self._next, method, params, asyncio.get_running_loop().create_future(), progress)
        self._next += 1
        self._pending[request.id] = request
        await self._send(request.line())
        try:
            return await request.future
        except asyncio.CancelledError:
            self._pending.pop(request.id, None)
            await self._send((json.dumps({"cancel": request.id}) + "\n").encode())
            raise

    async def _send(self, line: bytes) -> None:
        process = self._process
        if process and process.stdin:
            with contextlib.suppress(OSError):  # a worker that died is noticed by its reader, which sends anew
                process.stdin.write(line)
                await process.stdin.drain()

    async def _start(self) -> None:
        async with self._lock:
            if self._process and self._process.returncode is None:
                return
            folder = self.folder or data_folder() / "index"
            self._process = await asyncio.create_subprocess_exec(
                sys.executable, "-m", "c2s_engine.retrieve.worker", str(folder), self.model or "",
                stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE,
                limit=LINE,
            )  # fmt: skip
            self._tasks = [t for t in self._tasks if not t.done()]
            self._tasks.append(asyncio.create_task(self._read(self._process)))
            self._tasks.append(asyncio.create_task(self._log(self._process)))

    async def _log(self, process: asyncio.subprocess.Process) -> None:
        assert process.stderr
        while line := await process.stderr.readline():
            self._errors.append(line.decode(errors="replace").rstrip())

    async def _read(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdout
        while line := await process.stdout.readline():
            try:
                message = json.loads(line)
            except ValueError:
                continue
            self._take(message)
        code = await process.wait()
        if self._process is process:
            self._process = None
            await self._died(code)

    def _take(self, message: dict) -> None:
        request = self._pending.get(message.get("id", -1))
        if request is None:
            return
        if message.get("begun"):
            request.begun = True
        elif "progress" in message:
            if request.progress:
                request.progress(*message["progress"])
        else:
            del self._pending[request.id]
            if request.future.done():
                return
            if "error" in message:
                kind = BadDocument if message.get("kind") == "BadDocument" else RetrievalError
                request.future.set_exception(kind(message["error"]))
            else:
                request.future.set_result(message["result"])

    async def _died(self, code: int) -> None:
        """Fail what the worker was at, and start another for what was only waiting."""
        how = f"signal {-code}" if code < 0 else f"code {code}"
        last = next((e for e in reversed(self._errors) if e.strip()), "")
        for request in [r for r in self._pending.values() if r.begun]:
            del self._pending[request.id]
            if not request.future.done():
                reason = f" ({last[:160]})" if last and code > 0 else ""
                request.future.set_exception(
                    RetrievalError(
                        f"The retrieval worker died ({how}) at {request.words()}; it is started anew{reason}."
                    )
                )
        waiting = list(self._pending.values())
        if not waiting:
            return
        if code != 0 and not any(r.begun for r in waiting) and self._errors and "Error" in last:
            for request in waiting:  # it cannot even start: do not try for ever
                del self._pending[request.id]
                if not request.future.done():
                    request.future.set_exception(RetrievalError(f"The retrieval worker cannot start ({last[:160]})."))
            return
        await self._start()
        for request in waiting:
            await self._send(request.line())


def _failed(task: asyncio.Task) -> bool:
    """Whether a task that is done was cancelled or raised (which counts as looked at with this)."""
    return task.cancelled() or task.exception() is not None
