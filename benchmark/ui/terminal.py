"""What only a process of its own in a pseudo-terminal can show: the first paint, and idle processor time."""

import contextlib
import fcntl
import os
import pty
import select
import signal
import statistics
import struct
import sys
import tempfile
import termios
import time
from collections.abc import Iterator

SIZE = (45, 140)  # rows, columns
TYPED = b"zqzq"


@contextlib.contextmanager
def running(
    folder: str, session: str = "bench", size: tuple[int, int] = SIZE, **more: str
) -> Iterator[tuple[int, int, float]]:
    """The app in a pseudo-terminal of (rows, columns), with more in its environment: its process id, the terminal's
    other end, when it was started (s)."""
    environment = {
        **os.environ, "TERM": "xterm-256color", "XDG_CACHE_HOME": f"{folder}/cache", "XDG_DATA_HOME": f"{folder}/data",
        "XDG_CONFIG_HOME": f"{folder}/config", **more,
    }  # fmt: skip
    started = time.perf_counter()
    pid, end = pty.fork()
    if pid == 0:
        fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", *size, 0, 0))
        os.execve(sys.executable, [sys.executable, "-m", "c2s_tui.entry", "app", session], environment)
    try:
        yield pid, end, started
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGTERM)
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline and os.waitpid(pid, os.WNOHANG)[0] == 0:
            _drain(end, 0.1)
        os.close(end)


def first_paint(starts: int) -> tuple[float, float, float]:
    """Median times from the start of the process, s: to the first frame on the terminal, the processor time of that,
    and until what was typed upon that frame is shown. The first start is warm-up.
    """
    painted, used, typed = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(starts + 1):
            with running(folder) as (pid, end, started):
                painted.append(_until(end, b"c2s", started))
                used.append(_processor_time(pid))
                time.sleep(0.05)  # the terminal stops echoing right after the frame
                os.write(end, TYPED)
                typed.append(_until(end, TYPED, started))
    return statistics.median(painted[1:]), statistics.median(used[1:]), statistics.median(typed[1:])


def idle_cpu(seconds: float) -> float:
    """Processor time of the app and its helpers while nothing happens, percent of one processor."""
    with tempfile.TemporaryDirectory() as folder, running(folder) as (pid, end, _started):
        _drain(end, 40.0)  # until the check server has booted
        before = _processor_time(pid)
        _drain(end, seconds)
        return 100 * (_processor_time(pid) - before) / seconds


def _processor_time(pid: int) -> float:
    """User and system time of a process and all its descendants, s."""
    found, total = [pid], 0.0
    while found:
        one = found.pop()
        with contextlib.suppress(OSError, IndexError):
            with open(f"/proc/{one}/stat") as stat:
                fields = stat.read().rpartition(")")[2].split()
            total += (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
            for task in os.listdir(f"/proc/{one}/task"):
                with open(f"/proc/{one}/task/{task}/children") as children:
                    found += [int(c) for c in children.read().split()]
    return total


def _until(end: int, wanted: bytes, started: float) -> float:
    """When the terminal has been sent some bytes, s since the start of the process."""
    seen = b""
    while wanted not in seen and time.perf_counter() - started < 60:
        seen += read(end, 1.0)
    return time.perf_counter() - started


def read(end: int, seconds: float) -> bytes:
    if not select.select([end], [], [], seconds)[0]:
        return b""
    try:
        return os.read(end, 1 << 16)
    except OSError:
        return b""


def _drain(end: int, seconds: float) -> None:
    until = time.monotonic() + seconds
    while (left := until - time.monotonic()) > 0:
        if not read(end, left) and left > 0.05:
            time.sleep(min(0.05, left))
