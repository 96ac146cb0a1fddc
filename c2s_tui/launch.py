"""Runs the app in a terminal."""

import asyncio
import sys
from pathlib import Path

from c2s_tui.early import Early


def launch(session: str | None = None, file: Path | None = None, painted: Early | None = None) -> int:
    """Run until the user leaves; the exit status. `painted`: the terminal with the first frame on it."""
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        print("c2s app needs a terminal; `c2s generate` and `c2s edit` work without one.", file=sys.stderr)
        return 2
    from c2s_engine.paths import cache_folder
    from c2s_tui.app import C2SApp
    from c2s_tui.guard import guarded
    from c2s_tui.line import watch

    log = cache_folder() / "app.log"
    with guarded(log):
        app = C2SApp(session=session, file=file)
        if painted is not None:
            painted.hand_over()
        watch()
        app.run()
        if app.backend is not None:
            print("c2s: closing", end="\r", flush=True, file=sys.__stdout__)
            asyncio.run(app.backend.close())
            print("\x1b[K", end="", flush=True, file=sys.__stdout__)
    if app.failed_by is not None:
        print(
            f"c2s: the app ended on an internal error: {type(app.failed_by).__name__}: {app.failed_by}. The session is "
            f"kept: `c2s app` opens it again. Please report it, with {log}.",
            file=sys.stderr,
        )
    return app.return_code or 0
