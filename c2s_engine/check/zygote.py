"""A warm process that forks: it holds what its children share, and does nothing but fork on demand.

The server sends one byte and a socket; the child that is forked talks over that socket. The byte says whether its job
follows at once (NOW) or may be a while (SPARE). The zygote reports each child's end as a JSON line {"pid", "status"}
on its own control socket, and ends when that is closed.
"""

import contextlib
import ctypes
import json
import os
import select
import signal
import socket
import sys
from collections.abc import Callable, Iterable

from c2s_engine.check import prefault

Handler = Callable[[socket.socket], None]
NOW, SPARE = b"f", b"s"


def die_with_parent() -> None:
    """Ask Linux to kill this process when its parent is gone; elsewhere nothing."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(1, signal.SIGKILL, 0, 0, 0)


def serve(
    control: socket.socket,
    handle: Handler,
    rehearse: prefault.Rehearsal | None = None,
    settle: Callable[[], None] | None = None,
    children: Iterable[int] = (),
) -> None:
    """Fork a child for each socket that arrives; returns when the control socket is closed.

    `rehearse` does what a job is likely to do: a spare child copies beforehand the pages that this writes on. `settle`
    makes what children share but the first can do without: before the first spare child.
    `children` are the ids of processes that were forked already (0 for none).
    """
    wake_read, wake_write = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    signal.set_wakeup_fd(wake_write, warn_on_full_buffer=False)
    children = {pid for pid in children if pid}
    control.setblocking(True)
    while True:
        waiting: list = [control, wake_read]
        ready, _, _ = select.select(waiting, [], [])
        if wake_read in ready:
            with contextlib.suppress(BlockingIOError):
                os.read(wake_read, 4096)
            _reap(control, children)
        if control not in ready:
            continue
        try:
            message, fds, _, _ = socket.recv_fds(control, 1, 1)
        except OSError:
            message, fds = b"", []
        if not message:
            break
        if message == SPARE and settle is not None:
            settle()
            settle = None
        if message == SPARE and rehearse is not None:
            prefault.learn(rehearse)
            rehearse = None
        pid = os.fork()
        if pid == 0:
            if message == SPARE:
                prefault.populate(prefault.pages)
            _become_child(control, wake_read, wake_write, fds[0], handle)
        children.add(pid)
        os.close(fds[0])
    _finish(children)


def _finish(children: set[int]) -> None:
    """Let the children that are at work come to their end: the server watches and kills them itself."""
    for pid in children:
        with contextlib.suppress(ChildProcessError):
            os.waitpid(pid, 0)


def _become_child(control: socket.socket, wake_read: int, wake_write: int, fd: int, handle: Handler) -> None:
    code = 1
    try:
        signal.set_wakeup_fd(-1)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        os.setsid()
        die_with_parent()
        control.close()
        os.close(wake_read)
        os.close(wake_write)
        handle(socket.socket(fileno=fd))
        code = 0
    finally:
        os._exit(code)


def _reap(control: socket.socket, children: set[int]) -> None:
    while children:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return
        if pid == 0:
            return
        children.discard(pid)
        with contextlib.suppress(OSError):
            control.sendall(json.dumps({"pid": pid, "status": status}).encode() + b"\n")
