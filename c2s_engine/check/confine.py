"""What confines a check: limits on resources everywhere, and on x86-64 Linux a filter of system calls and of files."""

import contextlib
import platform
import resource
import sys
from typing import Any

from c2s_engine.check import landlock, seccomp

OPEN_FILES = 64
UNTRUSTED = "own process; limits on CPU time, memory and open files"


def limit(*, memory: int | None = None, cpu: float | None = None) -> None:
    """Limit this process: address space in bytes, CPU time in s, no core files, no files written."""
    wanted = [(resource.RLIMIT_CORE, 0, 0)]
    if memory:
        wanted.append((resource.RLIMIT_AS, memory, memory))
    if cpu:
        wanted.append((resource.RLIMIT_CPU, int(cpu) + 1, int(cpu) + 2))
    for kind, soft, hard in wanted:
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(kind, (soft, hard))


def supported() -> bool:
    return sys.platform == "linux" and platform.machine() == "x86_64"


def confine(job: dict[str, Any]) -> str:
    """Confine this process for a job; says in words by what, and what could not be had."""
    limits = job["limits"]
    limit(memory=limits["memory"], cpu=limits["cpu"])
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_NOFILE, (OPEN_FILES, OPEN_FILES))
    if job.get("trust"):
        return UNTRUSTED + "; trusted by the user: files and network are open to it"
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
    if not supported():
        return UNTRUSTED + "; no filter of system calls on this platform: it runs without"
    said = [UNTRUSTED]
    if landlock.restrict(landlock.readable(job)):
        said.append("reads only Scenic and maps (Landlock)")
    else:
        said.append("the kernel has no Landlock: it may read what the user may")
    if seccomp.install():
        said.append("no sockets, no other processes, no writing (seccomp)")
    else:
        said.append("the kernel refused the filter of system calls: it runs without")
    return "; ".join(said)
