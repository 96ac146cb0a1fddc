"""The beginning of the next program, done before it comes: most edits leave what stands above them as it is.

After a check a child is forked that is confined like any other, does the statements that the next program is likely to
begin with, and waits. Where the next program does begin with them, byte for byte as compiled, the child goes on with
its rest; else it is killed. Only statements that have come to their end before are done ahead, and none of a program
that is trusted: it may act on what is outside.
"""

import asyncio
import contextlib
from typing import TYPE_CHECKING, Any

from c2s_engine.check import wire

if TYPE_CHECKING:
    from c2s_engine.check.processes import Child, Zygote

PATIENCE = 1.0  # s for a child that is not ready yet
_THE_SAME = ("filename", "params", "limits", "allow", "trust", "model", "modules")


class Ahead:
    """The child of one zygote that has done the beginning of a program."""

    def __init__(self, zygote: "Zygote") -> None:
        self.zygote = zygote
        self.good: list[str] = []  # the statements of the last program that was executed to its end
        self.cut = 0  # how many of a program's statements are done ahead
        self._begun: tuple[list[str], dict[str, Any]] = ([], {})
        self._task: asyncio.Task[Child] | None = None

    async def give(self, job: dict[str, Any], header: dict[str, Any], blob: bytes) -> "Child | None":
        """Give the job to the child that waits, where its program begins with what that has done."""
        done, circumstances = self._begun
        if self._task is None or header["pieces"][: len(done)] != done or _circumstances(job) != circumstances:
            return None
        if not self._task.done() and self.zygote.has_spare:
            return None
        task, self._task = self._task, None
        fit = False
        try:
            with contextlib.suppress(TimeoutError, wire.Closed):
                child = await asyncio.wait_for(asyncio.shield(task), PATIENCE)
                await child.give(job, blob)
                answer, _ = await asyncio.wait_for(wire.read(child.reader), PATIENCE)
                fit = bool(answer.get("fit"))
            return child if fit else None
        finally:
            if not fit:
                end(task)

    def learn(self, header: dict[str, Any], executed: bool) -> None:
        """Take note of a program that was checked, and whether its statements came to their end."""
        said = header["pieces"]
        common = next((i for i, pair in enumerate(zip(self.good, said, strict=False)) if pair[0] != pair[1]), -1)
        common = min(len(self.good), len(said)) if common < 0 else common
        if not executed:
            self.cut = common
        elif common < len(said):  # edited here, and here again perhaps; else behind ego
            self.cut = common if common > header["count"] else header["ego"]
        if executed:
            self.good = said
        self.cut = self.cut if self.cut > header["count"] else 0

    def begin(self, job: dict[str, Any], header: dict[str, Any], blob: bytes) -> None:
        """Fork the child that does the beginning of this program again."""
        begun = header["pieces"][: self.cut], _circumstances(job)
        if self._task is not None and begun == self._begun and not _failed(self._task):
            return
        self.drop()
        if not self.cut or job["trust"] or not self.zygote.alive:
            return
        self._begun = begun
        self._task = asyncio.create_task(self._wait({**job, "kind": "ahead", "until": self.cut}, blob))
        self._task.add_done_callback(seen)

    async def _wait(self, job: dict[str, Any], blob: bytes) -> "Child":
        child = await self.zygote.fork()
        try:
            await child.give(job, blob)
            await wire.read(child.reader)
        except BaseException:
            child.kill()
            raise
        return child

    def drop(self) -> None:
        """Do without the child."""
        task, self._task = self._task, None
        if task is not None:
            end(task)


def _circumstances(job: dict[str, Any]) -> dict[str, Any]:
    """What else decides on how statements are executed."""
    return {name: job.get(name) for name in _THE_SAME}


def end(task: "asyncio.Task[Child]") -> None:
    """Do without the child that a task forks or has forked."""
    if not task.done():
        task.cancel()
    elif not _failed_to_fork(task):
        task.result().kill()


def seen(task: "asyncio.Task[Child]") -> None:
    """Take note of how a task ended, so that nothing is said of an error that nobody waits for."""
    if not task.cancelled():
        task.exception()


def _failed_to_fork(task: "asyncio.Task[Child]") -> bool:
    return task.cancelled() or task.exception() is not None


def _failed(task: "asyncio.Task[Child]") -> bool:
    return task.done() and (_failed_to_fork(task) or task.result().gone)
