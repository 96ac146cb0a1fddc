"""The line to the terminal. It is watched, because not every hang-up comes as a signal: where a multiplexer or `make`
stands between, only they may be told, and the app would go on without anybody.
"""

import os
import signal
import termios
import threading
import time

LOOK_SECONDS = 1.0
GONE_SECONDS = 5.0
"""How long the app may take to go when its terminal is gone."""


def watch(terminal: int = 0) -> None:
    """From now on, tell this process (SIGHUP) when the terminal of that file descriptor is gone; end it at last."""
    threading.Thread(target=_watch, args=(terminal,), name="line", daemon=True).start()


def end_soon() -> None:
    """End this process after a while, whatever it hangs in."""
    timer = threading.Timer(GONE_SECONDS, os._exit, (1,))
    timer.daemon = True
    timer.start()


def _watch(terminal: int) -> None:
    while not gone(terminal):
        time.sleep(LOOK_SECONDS)
    end_soon()
    os.kill(os.getpid(), signal.SIGHUP)


def gone(terminal: int) -> bool:
    """Whether nothing is at the other end of a terminal any more."""
    try:
        termios.tcgetattr(terminal)
    except (termios.error, OSError):
        return True
    return False
