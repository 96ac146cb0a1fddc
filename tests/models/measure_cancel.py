"""`python -m tests.models.measure_cancel [TIMES]`: how long it takes to stop a model in mid-stream, by the facade."""

import asyncio
import statistics
import sys
import threading
import time
from contextlib import suppress

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from tests.models.fake_ollama import Answer, FakeOllama, endless

TEXT = "A van drives 20 m ahead of ego at 40 km/h."


async def stops(times: int) -> list[float]:
    """Milliseconds from closing the turn's events until the work has ended, each time with the model streaming."""
    found = []
    with FakeOllama() as server:
        table = {"host": server.host, "probe": False}
        async with Engine(Settings(model="small", method="typed", ollama=table)) as engine:
            for _ in range(times):
                server.respond = lambda request: Answer(endless('{"objects": ['), hold=threading.Event())
                server.streaming.clear()
                server.disconnected.clear()
                events = engine.generate(TEXT, run=False)
                taking = asyncio.create_task(_take(events))
                assert await asyncio.to_thread(server.streaming.wait, 120)
                await asyncio.sleep(0.05)
                began = time.perf_counter()
                taking.cancel()
                with suppress(asyncio.CancelledError):
                    await taking
                await events.aclose()
                found.append(1000 * (time.perf_counter() - began))
                assert await asyncio.to_thread(server.disconnected.wait, 5), "the server goes on"
    return found


async def _take(events) -> None:
    async for _ in events:
        pass


if __name__ == "__main__":
    ms = asyncio.run(stops(int(sys.argv[1]) if len(sys.argv) > 1 else 20))
    print(f"{len(ms)} times: median {statistics.median(ms):.1f} ms, longest {max(ms):.1f} ms")
