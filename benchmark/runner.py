"""Running tasks: from the store what is there, the rest in parallel worker processes."""

import json
import queue
import subprocess
import sys
import threading
from collections.abc import Iterator, Sequence
from pathlib import Path

from c2s_bench.host import REAL, EngineHost
from c2s_bench.records import BenchmarkError
from c2s_bench.store import Store
from c2s_bench.tasks import Outcome, Task
from c2s_bench.worker import READY
from c2s_engine.paths import cache_folder

LIMIT = 1800.0  # s a task: a slow model may write for long, but nothing may hang for ever


def run(
    tasks: Sequence[Task],
    store: Store,
    *,
    jobs: int = 1,
    scheduler: str = "",
    engine: str = REAL,
    fresh: bool = False,
    limit: float = LIMIT,
) -> Iterator[Outcome]:
    """The outcomes as they come: first the stored ones, then those of `jobs` processes (0: of this one) or of Dask."""
    todo = []
    for task in tasks:
        known = None if fresh else store.get(task.key)
        if known:
            yield known if known.id == task.id else Outcome(**{**known.__dict__, "id": task.id})
        else:
            todo.append(task)
    if not todo:
        return
    if scheduler:
        from c2s_bench.cluster import run_on_cluster

        source = run_on_cluster(scheduler, todo, engine)
    elif jobs == 0:
        source = _here(todo, engine)
    else:
        source = _in_processes(todo, min(jobs, len(todo)), engine, limit)
    for outcome in source:
        store.put(outcome)
        yield outcome


def _here(tasks: Sequence[Task], engine: str) -> Iterator[Outcome]:
    host = EngineHost(engine)
    try:
        yield from map(host.run, tasks)
    finally:
        host.close()


def _in_processes(tasks: Sequence[Task], jobs: int, engine: str, limit: float) -> Iterator[Outcome]:
    waiting: queue.SimpleQueue[Task] = queue.SimpleQueue()
    done: queue.SimpleQueue[Outcome | BenchmarkError] = queue.SimpleQueue()
    for task in tasks:
        waiting.put(task)
    workers = [_Worker(waiting, done, engine, limit) for _ in range(max(1, jobs))]
    for worker in workers:
        worker.start()
    try:
        for _ in tasks:
            outcome = done.get()
            if isinstance(outcome, BenchmarkError):
                raise outcome
            yield outcome
    finally:
        for worker in workers:
            worker.stop()


class _Worker(threading.Thread):
    """Feeds one worker process; a process that dies or takes too long costs its task only."""

    def __init__(self, waiting: queue.SimpleQueue, done: queue.SimpleQueue, engine: str, limit: float):
        super().__init__(daemon=True)
        self.waiting, self.done, self.engine, self.limit = waiting, done, engine, limit
        self.process: subprocess.Popen[str] | None = None
        self.stopped = False

    def run(self) -> None:
        while not self.stopped:
            try:
                task = self.waiting.get_nowait()
            except queue.Empty:
                break
            try:
                self.done.put(self._ask(task))
            except BenchmarkError as error:
                self.done.put(error)
                break
        self._end()

    def stop(self) -> None:
        """Take no more tasks; a process that is at work is ended."""
        self.stopped = True
        if self.process and self.is_alive():
            self.process.kill()
        self.join()

    def _ask(self, task: Task) -> Outcome:
        if self.process is None:
            self.process = self._start()
        assert self.process.stdin and self.process.stdout
        late = threading.Event()
        process = self.process

        def end() -> None:
            late.set()
            process.kill()

        timer = threading.Timer(self.limit, end)
        timer.start()
        try:
            self.process.stdin.write(json.dumps(task.as_dict()) + "\n")
            self.process.stdin.flush()
            answer = self.process.stdout.readline()
        except OSError:
            answer = ""
        finally:
            timer.cancel()
        if answer:
            return Outcome(**json.loads(answer))
        process.kill()
        process.wait()
        self.process = None
        why = f"it took over {self.limit:g} s" if late.is_set() else f"its process died (see {_log()})"
        return Outcome(task.key, task.id, error=why)

    def _start(self) -> subprocess.Popen[str]:
        _log().parent.mkdir(parents=True, exist_ok=True)
        with _log().open("a", encoding="utf-8") as log:
            process = subprocess.Popen(
                [sys.executable, "-m", "c2s_bench.worker", self.engine],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                encoding="utf-8",
            )
        assert process.stdout
        if process.stdout.readline() != READY and not self.stopped:
            process.wait()
            last = _log().read_text(encoding="utf-8", errors="replace").strip().splitlines()[-1:]
            raise BenchmarkError(f"the engine cannot be started: {''.join(last) or 'no reason given'} (see {_log()})")
        return process

    def _end(self) -> None:
        if self.process and self.process.stdin:
            self.process.stdin.close()
            self.process.wait()


def _log() -> Path:
    return cache_folder() / "bench" / "worker.log"
