"""`python -m c2s_bench.ui.screenshot docs/app.svg`: the app with a scenario that it made and ran, as a picture."""

import argparse
import asyncio
from pathlib import Path
from tempfile import TemporaryDirectory

TEXT = (
    "At dusk ego drives at 50 km/h on a road with two lanes. A cyclist rides out from the right in front of ego, "
    "and ego brakes."
)
SIZE = (160, 46)


async def take(target: Path) -> None:
    """Describe, run, open the picture of the run at its middle, and write the screen as SVG."""
    from c2s_tui.app import C2SApp
    from c2s_tui.backend import Backend
    from c2s_tui.prefs import Prefs

    with TemporaryDirectory() as folder:
        backend = Backend(folder=Path(folder))
        app = C2SApp(backend=backend, session="cyclist", prefs=Prefs(welcomed=True, graphics="blocks"))
        async with app.run_test(size=SIZE) as pilot:
            while app.workbench is None or not app.workbench.start.ready:
                await pilot.pause(0.05)
            bench = app.workbench
            await bench.turns.say(TEXT)
            while not bench.turns.busy:
                await pilot.pause(0.01)
            while bench.turns.busy:
                await pilot.pause(0.05)
            if not bench.picture.available:
                raise SystemExit("the scenario did not run; nothing was written")
            await bench.run_command("picture")
            await pilot.pause()
            bench.picture.go(35)
            bench.room.visit("O1")
            await pilot.pause()
            app.clear_notifications()
            await pilot.pause()
            target.write_text(app.export_screenshot(title="c2s"), encoding="utf-8")
        await backend.close()


def main() -> None:
    """Write the picture to the file that is named."""
    parser = argparse.ArgumentParser(prog="python -m c2s_bench.ui.screenshot", description=__doc__)
    parser.add_argument("file", type=Path, nargs="?", default=Path("docs/app.svg"))
    asyncio.run(take(parser.parse_args().file))


if __name__ == "__main__":
    main()
