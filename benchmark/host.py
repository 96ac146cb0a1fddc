"""An engine that lives in a thread of this process and works through tasks."""

import asyncio
import importlib
import threading
import time
from contextlib import AbstractAsyncContextManager
from typing import Any

from c2s_bench.tasks import Outcome, Setup, Task
from c2s_engine.structure.progress import Finished, ProgramChanged, Say, Usage

WARM_UP = "The ego follows a car on a straight road."
REAL = "c2s_bench.host:real_engine"


def real_engine(setup: Setup) -> AbstractAsyncContextManager[Any]:
    """The facade, with the model that is asked for, and of the user's settings how to ask it and where maps are."""
    from c2s_engine.api import Engine
    from c2s_engine.config import Settings, load_settings

    known = load_settings()
    maps = {"map_folders": known.map_folders, "carla_root": known.carla_root}
    ollama = known.ollama if setup.model else {}
    return Engine(Settings(model=setup.model or None, ollama=ollama, offers=False, **maps))


def factory_of(name: str) -> Any:
    """The engine factory `module:function`."""
    module, _, attribute = name.partition(":")
    return getattr(importlib.import_module(module), attribute)


class EngineHost:
    """Starts the engine at the first task and keeps it; another model is another engine."""

    def __init__(self, factory: str = REAL):
        self._factory = factory_of(factory)
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="engine", daemon=True)
        self._thread.start()
        self._engines: dict[tuple[str, str | None], tuple[Any, Any]] = {}
        self._lock = threading.Lock()

    def run(self, task: Task) -> Outcome:
        """What the task's method makes of its text; a fault becomes the outcome's `error`."""
        with self._lock:
            try:
                return asyncio.run_coroutine_threadsafe(self._run(task), self._loop).result()
            except Exception as error:  # any fault of one task must not end the others
                known = type(error).__module__.startswith("c2s_engine.")  # its message is a sentence already
                return Outcome(task.key, task.id, error=str(error) if known else f"{type(error).__name__}: {error}")

    def close(self) -> None:
        """Stop the engines and the thread."""
        asyncio.run_coroutine_threadsafe(self._close(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    async def _engine(self, setup: Setup) -> Any:
        key = (setup.model, setup.map)
        if key not in self._engines:
            manager = self._factory(setup)
            engine = await manager.__aenter__()
            self._engines[key] = (manager, engine)
            await _warm(engine, setup)
        return self._engines[key][1]

    async def _run(self, task: Task) -> Outcome:
        setup = task.setup
        engine = await self._engine(setup)
        tokens, last, said = 0, 0.0, ""
        finished: Finished | None = None
        began = time.perf_counter()
        async for event in engine.generate(
            task.text, method=setup.method, map=setup.map, seed=setup.seed, run=True, runs=setup.runs
        ):
            match event:
                case ProgramChanged():
                    last = time.perf_counter() - began
                case Usage():
                    tokens += event.prompt_tokens + event.answer_tokens
                case Say(severity="error"):
                    said = event.text
                case Finished():
                    finished = event
        if finished is None:
            return Outcome(task.key, task.id, error=said or "the engine ended without a result")
        return Outcome(
            task.key,
            task.id,
            program=finished.program.text,
            stages=tuple(_stage(s) for s in finished.stages),
            facts=tuple(f.model_dump(mode="json", exclude_defaults=True) for f in finished.facts),
            required=_required(finished),
            seconds=last or finished.seconds,
            tokens=finished.details.get("tokens", tokens),
            folder=finished.details.get("folder") or "",
            share=finished.details.get("share") if setup.model else None,
            error=said if not finished.stages and not finished.ok else "",
        )

    async def _close(self) -> None:
        for manager, _ in self._engines.values():
            await manager.__aexit__(None, None, None)
        self._engines.clear()


async def _warm(engine: Any, setup: Setup) -> None:
    """Load what the first text would load, so that starting up counts for no record. Models are left alone."""
    from c2s_engine.write.methods import retrieves

    if hasattr(engine, "check_client"):
        await engine.check_client.ready()
        if retrieves(setup.method):
            await (await engine.retrieval()).ready()
        if not setup.model:
            async for _ in engine.generate(WARM_UP, method=setup.method, map=setup.map, run=False):
                pass


def _required(finished: Finished) -> tuple[dict[str, Any], ...]:
    kinds = {r.id: r.kind for r in finished.requirements}
    return tuple({"id": r.requirement, "kind": kinds[r.requirement], "holds": r.holds} for r in finished.results)


def _stage(stage: Any) -> dict[str, Any]:
    errors = [d for d in stage.diagnostics if d.severity == "error"]
    message = " ".join(errors[0].message.split()) if errors else ""
    return {"name": stage.name, "ok": stage.ok, "seconds": stage.seconds, "message": message}
