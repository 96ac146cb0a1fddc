"""Typing and scrolling in a program of 2,000 lines."""

import asyncio
import time
from pathlib import Path
from tempfile import TemporaryDirectory

from c2s_bench.ui.latency import Times, one_key, percentiles

LINES = 2000
FRAGMENT = """behavior Behavior{i}(speed=10):
    try:
        do FollowLaneBehavior(target_speed=speed)  # m/s
    interrupt when withinDistanceToAnyObjs(self, 10):
        take SetBrakeAction(0.8)

car{i} = new Car following roadDirection from ego for {i},
    with behavior Behavior{i}(speed=Range(8, 12))

"""


async def edit_long_program(keys: int = 100) -> tuple[Times, Times]:
    """95th percentiles: a key to its drawing, scrolling a page."""
    from c2s_engine.structure.components import Component, Structure
    from c2s_engine.structure.edits import Replace
    from c2s_engine.structure.specs import EgoSpec
    from c2s_tui.app import C2SApp
    from c2s_tui.backend import Backend
    from c2s_tui.prefs import Prefs

    code = "".join(FRAGMENT.format(i=i) for i in range(1, LINES // FRAGMENT.count("\n") + 1))
    imported = Structure(ego=Component(id="E", spec=EgoSpec(), code=code, origin="imported"))
    typed: list[Times] = []
    scrolled: list[Times] = []
    with TemporaryDirectory() as folder:
        backend = Backend(folder=Path(folder))
        app = C2SApp(backend=backend, session="bench", prefs=Prefs(welcomed=True))
        async with app.run_test(size=(140, 45)):
            while app.workbench is None or not app.workbench.start.ready:
                await asyncio.sleep(0.05)
            bench = app.workbench
            await bench.turns.make_edits((Replace(structure=imported),))
            while bench.turns.busy or bench.code.area.document.line_count < LINES - 50:
                await asyncio.sleep(0.05)
            area = bench.code.area
            area.focus()
            area.move_cursor((LINES // 2, 0))
            for i in range(keys):
                typed.append(await one_key(app, area, "abcdefgh "[i % 9]))
                await asyncio.sleep(0.03)
            for i in range(keys):
                started, used, done = time.perf_counter(), time.process_time(), asyncio.Event()
                area.scroll_page_down(animate=False) if i % 20 < 10 else area.scroll_page_up(animate=False)
                app.call_after_refresh(done.set)
                await done.wait()
                passed = 1000 * (time.perf_counter() - started)
                scrolled.append(Times(passed, 1000 * (time.process_time() - used)))
        await backend.close()
    return percentiles(typed), percentiles(scrolled)
