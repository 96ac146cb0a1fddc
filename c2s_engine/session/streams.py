"""Work that reports by a callback, as the iterator of events that the facade yields."""

import asyncio
import contextlib
from collections.abc import AsyncGenerator, Awaitable, Callable
from typing import Generic, TypeVar

from c2s_engine.session.steps import Emit
from c2s_engine.structure.progress import Progress

T = TypeVar("T")


class Result(Generic[T]):
    """What the work came to: the last thing of the stream."""

    def __init__(self, value: T):
        self.value = value


async def streamed(work: Callable[[Emit], Awaitable[T]]) -> AsyncGenerator[Progress | Result[T], None]:
    """The work's events as they come, then its result; what it raises is raised. Closing the iterator cancels it."""
    queue: asyncio.Queue[Progress | None] = asyncio.Queue()

    async def run() -> T:
        try:
            return await work(queue.put_nowait)
        finally:
            queue.put_nowait(None)

    task = asyncio.create_task(run())
    try:
        while (event := await queue.get()) is not None:
            yield event
        yield Result(await task)
    finally:
        if not task.done():
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task
