"""A thread of its own for the engine, so that no step of it can hold up the drawing of a key."""

import asyncio
import sys
import threading
from collections.abc import AsyncGenerator, AsyncIterator, Awaitable, Callable
from contextlib import aclosing
from typing import Any, TypeVar

T = TypeVar("T")
_END = object()
SWITCH_SECONDS = 0.001
"""How long a thread may hold Python's lock while another waits for it (5 ms by default, several times a key)."""


class EngineThread:
    """An event loop in a thread: coroutines and event streams are run there and awaited here."""

    def __init__(self) -> None:
        sys.setswitchinterval(SWITCH_SECONDS)
        self.loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._run, name="engine", daemon=True)
        self._thread.start()

    def _run(self) -> None:
        asyncio.set_event_loop(self.loop)
        self.loop.run_forever()
        self.loop.close()

    async def call(self, function: Callable[[], Awaitable[T]]) -> T:
        """Run an async function there; cancelling the wait cancels it."""

        async def run() -> T:
            return await function()

        return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(run(), self.loop))

    async def do(self, function: Callable[[], T]) -> T:
        """Run a plain function there."""

        async def run() -> T:
            return function()

        return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(run(), self.loop))

    async def stream(self, source: Callable[[], AsyncIterator[T]]) -> AsyncGenerator[T, None]:
        """Iterate there, yield here. Closing this iterator closes the other, and returns once that is done."""
        here = asyncio.get_running_loop()
        queue: asyncio.Queue[Any] = asyncio.Queue()

        async def pump() -> None:
            try:
                async with aclosing(source()) as events:  # type: ignore[type-var]
                    async for event in events:
                        here.call_soon_threadsafe(queue.put_nowait, event)
            except Exception as error:
                here.call_soon_threadsafe(queue.put_nowait, _Failure(error))
            finally:
                here.call_soon_threadsafe(queue.put_nowait, _END)

        pumping = asyncio.run_coroutine_threadsafe(pump(), self.loop)
        ended = False
        try:
            while (item := await queue.get()) is not _END:
                if isinstance(item, _Failure):
                    raise item.error
                yield item
            ended = True
        finally:
            if not ended:
                pumping.cancel()
                while await queue.get() is not _END:
                    pass

    def stop(self) -> None:
        """Cancel what still runs, stop the loop and wait for its thread."""
        asyncio.run_coroutine_threadsafe(self._end(), self.loop)
        self._thread.join(timeout=5)

    async def _end(self) -> None:
        others = asyncio.all_tasks() - {asyncio.current_task()}
        for task in others:
            task.cancel()
        await asyncio.gather(*others, return_exceptions=True)
        self.loop.stop()


class _Failure:
    def __init__(self, error: Exception):
        self.error = error
