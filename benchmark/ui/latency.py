"""From a key to the drawn frame, while a scenario is interpreted, written, checked and run by the real engine."""

import asyncio
import statistics
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

TEXTS = (
    "Ego drives at 50 km/h on a road with two lanes. A van in the left lane cuts in 15 m ahead.",
    "Ego turns left at a signalised intersection. A pedestrian crosses from the right.",
    "Ego follows a truck at 70 km/h in the rain. The truck brakes hard.",
    "At a roundabout a motorcycle comes from the left and ego lets it pass.",
    "A cyclist rides ahead of ego on a country road at dusk. Ego overtakes it.",
    "On a motorway with three lanes a bus in the right lane changes into ego's lane.",
    "A parked car on the right pulls out 20 m ahead of ego, which drives at 40 km/h.",
    "At a stop sign ego waits for two cars that cross from the right, then turns left.",
    "A deer runs onto the road from the left in fog. Ego brakes.",
)
KEYS_PER_TURN = 120


@dataclass(frozen=True)
class Times:
    """Milliseconds that passed, and of the process's own processor time (which a busy machine disturbs less)."""

    wall: float
    processor: float


async def key_to_draw() -> Times:
    """95th percentiles over keys typed into the chat during these turns."""
    from c2s_tui.app import C2SApp
    from c2s_tui.backend import Backend
    from c2s_tui.prefs import Prefs

    times: list[Times] = []
    with tempfile.TemporaryDirectory() as folder:
        backend = Backend(folder=Path(folder))
        app = C2SApp(backend=backend, session="bench", prefs=Prefs(welcomed=True))
        async with app.run_test(size=(140, 45)) as pilot:
            while app.workbench is None or not app.workbench.start.ready:
                await asyncio.sleep(0.05)
            for text in TEXTS:
                await app.workbench.turns.say(text)
                while not app.workbench.turns.busy:
                    await asyncio.sleep(0.005)
                entry = app.workbench.chat.entry
                entry.focus()
                count = 0
                while app.workbench.turns.busy or count < 20:
                    if count < KEYS_PER_TURN:
                        times.append(await one_key(app, entry, "abcdefgh "[count % 9]))
                        count += 1
                    await asyncio.sleep(0.04)
                entry.put("")
            del pilot
        await backend.close()
    return percentiles(times)


async def one_key(app: Any, area: Any, key: str) -> Times:
    """From handing a key to the app until the widget has been drawn with it."""
    from textual import events

    drawn = asyncio.Event()
    before = area.text
    started, used = time.perf_counter(), time.process_time()
    app.post_message(events.Key("space" if key == " " else key, key))
    while area.text == before:
        await asyncio.sleep(0.001)
    app.call_after_refresh(drawn.set)
    await drawn.wait()
    return Times(1000 * (time.perf_counter() - started), 1000 * (time.process_time() - used))


def percentiles(times: list[Times]) -> Times:
    """The 95th percentile of each."""
    return Times(percentile([t.wall for t in times]), percentile([t.processor for t in times]))


def percentile(times: list[float], share: float = 0.95) -> float:
    """The value below which that share of the times lies."""
    return statistics.quantiles(times, n=100)[round(share * 100) - 1]
