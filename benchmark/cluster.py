"""The same tasks on a Dask cluster: each of its workers keeps one engine."""

import atexit
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import Any

from c2s_bench.host import EngineHost
from c2s_bench.records import BenchmarkError
from c2s_bench.tasks import Outcome, Task

_HOSTS: dict[str, EngineHost] = {}


def work(task: dict[str, Any], engine: str) -> dict[str, Any]:
    """Run one task on a cluster's worker."""
    if engine not in _HOSTS:
        _HOSTS[engine] = EngineHost(engine)
        atexit.register(_HOSTS[engine].close)
    return asdict(_HOSTS[engine].run(Task.from_dict(task)))


def run_on_cluster(address: str, tasks: Sequence[Task], engine: str) -> Iterator[Outcome]:
    """The outcomes as the cluster at that scheduler delivers them."""
    try:
        from distributed import Client, as_completed
    except ImportError:
        raise BenchmarkError("--scheduler needs the package distributed: pip install 'c2s[cluster]'") from None
    try:
        client = Client(address, timeout=5)
    except (OSError, ValueError) as error:
        raise BenchmarkError(f"no Dask scheduler answers at {address}: {error}") from None
    with client:
        waiting = {client.submit(work, t.as_dict(), engine, key=f"c2s-{t.key}", pure=False): t for t in tasks}
        for future in as_completed(list(waiting)):
            if future.status == "finished":
                yield Outcome(**future.result())
            else:
                task = waiting[future]
                yield Outcome(task.key, task.id, error=f"on the cluster: {future.exception()}")
