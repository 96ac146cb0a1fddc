"""Notices a behaviour that computes on and on without taking an action: one timer for a run.

Scenic's own alarm is set and cleared around every step of every behaviour, which takes longer than many a step, and
goes by the clock, so that on a busy machine it strikes at behaviours that merely wait for their turn.
"""

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

from scenic.core import dynamics
from scenic.core.dynamics.utils import StuckBehaviorWarning

LOOK = 0.5
"""s of processor time between two looks."""


class Watch:
    """`begun` is when the behaviour that is computing began its step (s of processor time; None: none is)."""

    def __init__(self, limit: float) -> None:
        self.limit = limit
        self.begun: float | None = None

    def look(self, *_: object) -> None:
        """Raises StuckBehaviorWarning in the behaviour where it is over the limit (s)."""
        if self.begun is not None and time.process_time() - self.begun > self.limit:
            self.begun = None
            raise StuckBehaviorWarning(f"no action within {self.limit} s")


@contextmanager
def watching(limit: float) -> Iterator[Watch]:
    """A watch that looks while this lasts, in place of Scenic's alarm (in the main thread; elsewhere none looks)."""
    watch = Watch(limit)
    before, dynamics.stuckBehaviorWarningTimeout = dynamics.stuckBehaviorWarningTimeout, 0
    main = threading.current_thread() is threading.main_thread()
    if main:
        handler = signal.signal(signal.SIGPROF, watch.look)
        signal.setitimer(signal.ITIMER_PROF, LOOK, LOOK)
    try:
        yield watch
    finally:
        if main:
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.signal(signal.SIGPROF, handler)
        dynamics.stuckBehaviorWarningTimeout = before
