"""What a forked child does: run a preamble, a program or expressions, and report over its socket."""

import contextlib
import functools
import importlib
import io
import itertools
import marshal
import os
import pickle
import socket
import sys
import time
import warnings
from collections.abc import Iterable, Iterator
from typing import Any

from c2s_engine.check import (
    beside,
    caching,
    confine,
    diagnose,
    draws,
    library,
    networks,
    prefault,
    reading,
    sampling,
    warm,
    wire,
    zygote,
)
from c2s_engine.check.naming import Names
from c2s_engine.structure.diagnostics import Diagnostic, StageResult

MAP_MEMORY = 6 << 30
"""Bytes of address space in which a map is read."""
_prepared: dict[str, Any] = {}
"""In a snapshot: the namespace in which the preamble was run, the options, how many modules there were by then."""


def handle(conn: socket.socket) -> None:
    """Do the one job that arrives over the socket."""
    wire.send(conn, {"pid": os.getpid()})
    try:
        job, blob = wire.receive(conn)
    except wire.Closed:
        return
    _silence()
    if job["kind"] == "reader":
        confine.limit(memory=6 << 30)
        reading.serve(conn)
    elif job["kind"] == "map":
        _load_map(conn, job)
    elif job["kind"] == "preamble":
        _preamble(conn, job, blob)
    elif job["kind"] == "places":
        from c2s_engine.check import places

        places.answer(conn, job, _prepared)
    elif job["kind"] == "ahead":
        Check(conn, job, blob).ahead()
    else:
        Check(conn, job, blob).run()


def _silence() -> None:
    """Native libraries that print must not reach the protocol."""
    null = os.open(os.devnull, os.O_RDWR)
    for fd in (0, 1, 2):
        os.dup2(null, fd)
    os.close(null)
    sys.stdin = io.StringIO()
    sys.stdout = sys.stderr = _Counted()
    warnings.simplefilter("ignore")


class OutputLimit(Exception):
    """The program printed more than it may."""


class _Counted(io.TextIOBase):
    """Swallows what a program prints, up to a limit (characters)."""

    limit = 1 << 20

    def write(self, text: str) -> int:
        self.limit -= len(text)
        if self.limit < 0:
            raise OutputLimit
        return len(text)


def _load_map(conn: socket.socket, job: dict[str, Any]) -> None:
    """Load a map and stay, so that programs on it start from here. What must be saved is, meanwhile."""
    from scenic.core.errors import ScenicError
    from scenic.domains.driving.roads import Network

    from c2s_engine.check import rehearse
    from c2s_engine.maps.opendrive import BrokenMap

    confine.limit(memory=MAP_MEMORY)
    networks.save_later = True
    try:
        network = Network.fromFile(job["path"])
        saving = networks.save_apart()
        networks.prepare(network)
        library.load()
    except Exception as error:
        known = isinstance(error, ScenicError | BrokenMap)
        wire.send(conn, {"failed": str(error) if known else f"{type(error).__name__}: {error}"[:200]})
        return
    networks.save_later = False
    wire.send(conn, {"ready": True})
    zygote.serve(conn, handle, functools.partial(rehearse.model, job["path"]), _settle, children={saving})


def _preamble(conn: socket.socket, job: dict[str, Any], blob: bytes) -> None:
    """Run the statements up to `model` and stay, so that programs with the same ones start from here.

    Tells which params were read: others may have any value in the programs that start from here, which set them again.
    """
    from scenic.syntax import veneer

    from c2s_engine.check import rehearse

    namespace, options = begin(job)
    try:
        with _params_read() as read:
            for code in pickle.loads(blob)[0][: job["count"]]:
                run_code(marshal.loads(code), namespace)
    except BaseException as error:
        wire.send(conn, {"failed": str(error)})
        return
    if facts := namespace.get("map_facts"):  # read once for all programs that start from here
        with contextlib.suppress(Exception):
            facts()
    _prepared.update(namespace=namespace, options=options, veneer=veneer, modules=_scenic_modules(sys.modules))
    wire.send(conn, {"ready": True, "read": sorted(read)})
    zygote.serve(conn, handle, rehearse.check, _settle)


def _settle() -> None:
    """Make what runs share, now that the first check is over."""
    for path, network in networks.known():
        with contextlib.suppress(Exception):
            warm.prepare(network, path)


@contextlib.contextmanager
def _params_read() -> Iterator[set[str]]:
    """The names of the global parameters that are read meanwhile."""
    from scenic.syntax import veneer

    read: set[str] = set()
    table: Any = veneer.ParameterTableProxy

    class Recorded(table):
        def __getitem__(self, name: str) -> Any:
            read.add(name)
            return super().__getitem__(name)

        def __iter__(self) -> Iterator[str]:
            read.update(self._internal_map)
            return super().__iter__()

    veneer.ParameterTableProxy = Recorded
    try:
        yield read
    finally:
        veneer.ParameterTableProxy = table


def _scenic_modules(names: Iterable[str]) -> list[str]:
    from scenic.syntax.translator import ScenicModule

    return [name for name in names if isinstance(sys.modules[name], ScenicModule)]


def _unload(names: list[str]) -> None:
    """Scenic's purgeModulesUnsafeToCache for modules that are known by name: to look through all costs 4 ms here."""
    for name in names:
        parent, _, child = name.rpartition(".")
        if parent in sys.modules:
            vars(sys.modules[parent]).pop(child, None)
        del sys.modules[name]


def begin(job: dict[str, Any]) -> tuple[dict[str, Any], Any]:
    """Scenic's start of a top-level module: the namespace and the options."""
    from scenic.syntax import translator, veneer

    options = translator.CompileOptions(
        mode2D=True, modelOverride=job.get("model"), paramOverrides=dict(job.get("params") or {})
    )
    namespace: dict[str, Any] = {"__name__": "__main__"}
    veneer.activate(options, namespace)
    exec(compile(translator.preamble, "<veneer>", "exec"), namespace)
    namespace[translator.namespaceReference] = namespace
    return namespace, options


def run_code(code: Any, namespace: dict[str, Any]) -> None:
    """Execute compiled statements as Scenic does."""
    from scenic.syntax import translator

    translator.executeCodeIn(code, namespace)


class Check:
    """One program in this process."""

    def __init__(self, conn: socket.socket, job: dict[str, Any], blob: bytes) -> None:
        self.conn = conn
        self.done = -1  # how many of the statements; none of the settings either
        self.modules = len(sys.modules)
        self._take(job, blob)
        self.names = Names(self.program)

    def _take(self, job: dict[str, Any], blob: bytes) -> None:
        self.job, self.limits = job, job["limits"]
        self.codes, self.requirements, self.digest = pickle.loads(blob)
        self.program = diagnose.Program(job["program"], job["filename"], job["spans"])

    def run(self) -> None:
        self._enter()
        warm.reseed(self.job["seed"])
        self._check()

    def ahead(self) -> None:
        """Do the program's first statements, and go on with the program that begins with them, if its seed lets it."""
        self._enter()
        with draws.Draws() as drawn:
            self.execute(self.job["until"])
        if not drawn.known:
            return
        prefault.populate(prefault.later)
        self._send({"ready": True})
        self._take(*wire.receive(self.conn))
        self.names.program = self.program
        fit = drawn.repeat(self.job["seed"])
        self._send({"fit": fit})
        if fit:
            self._check()

    def _enter(self) -> None:
        self.isolation = confine.confine(self.job)
        _Counted.limit = self.limits["output"]
        caching.may_write = bool(self.job.get("trust"))
        if self.job.get("modules"):
            beside.take(self.job["modules"])

    def _check(self) -> None:
        self._send({"isolation": self.isolation})
        scenario = self._stage("compile", self._compile)
        if scenario is not None and self.job["upto"] != "compile":
            self._scenes(scenario)
        self._send({"end": True})

    def _stage(self, name: Any, work: Any) -> Any:
        started = time.perf_counter()
        self._send({"begin": name})
        result: Any = None
        found: tuple[Diagnostic, ...] = ()
        try:
            result = work()
        except BaseException as error:
            if isinstance(error, SystemExit | KeyboardInterrupt):
                error = RuntimeError(f"the program tried to end the process ({type(error).__name__})")
            found = (diagnose.diagnose(error, name, self.program),)
        self._finish(name, started, found)
        return result

    def _finish(self, name: Any, started: float, found: tuple[Diagnostic, ...]) -> None:
        ok = not any(d.severity == "error" for d in found)
        stage = StageResult(name=name, ok=ok, seconds=time.perf_counter() - started, diagnostics=found)
        self._send({"stage": stage.model_dump(mode="json")})

    def _send(self, message: dict[str, Any]) -> None:
        wire.send(self.conn, message)

    def execute(self, until: int) -> None:
        """Execute the statements up to that one which have not been executed yet."""
        if self.done < 0 and _prepared:
            for i in self.job["settings"]:
                self._statement(i)
            self.done = self.job["count"]
        elif self.done < 0:
            _prepared.update(zip(("namespace", "options"), begin(self.job), strict=True))
            self.done = 0
        for i in range(self.done, until):
            self._statement(i)
        self.done = until

    def _statement(self, i: int) -> None:
        with self.names.watching():
            run_code(marshal.loads(self.codes[i]), _prepared["namespace"])

    def _compile(self) -> Any:
        from scenic.syntax import translator, veneer

        try:
            self.execute(len(self.codes))
            with self.names.watching():
                namespace, options = _prepared["namespace"], _prepared["options"]
                translator.storeScenarioStateIn(namespace, self.requirements, self.digest, options)
        finally:
            veneer.deactivate()
            new = itertools.islice(reversed(sys.modules), len(sys.modules) - self.modules)
            _unload(_prepared.get("modules", []) + _scenic_modules(new))
        with self.names.watching():
            scenario = translator.constructScenarioFrom(namespace, self.job.get("scenario"))
        self.names.gather(namespace, scenario)
        return scenario

    def _scenes(self, scenario: Any) -> None:
        run = self._runner() if self.job["upto"] == "run" else None
        sampler = sampling.Sampler(scenario, self.program, self.limits, self.names)
        started, found, seconds = time.perf_counter(), [], 0.0
        ran: list[Diagnostic] = []
        self._send({"begin": "sample"})
        for k in range(max(1, self.job["runs"])):
            seed = self.job["seed"] + k
            begun = time.perf_counter()
            scene, iterations, trouble = sampler.sample(seed)
            seconds += time.perf_counter() - begun
            self._send({"iterations": iterations})
            found.extend(trouble)
            if scene is None:
                break
            self._send({"scene": self.names.positions(scenario, scene)})
            if run is not None:
                self._send({"begin": "run"})
                ran.extend(self._rollout(run, scenario, scene, seed))
                self._send({"begin": "sample"})
        self._finish("sample", time.perf_counter() - seconds, tuple(found))
        if run is not None and not found:
            self._finish("run", started + seconds, tuple(ran))

    def _runner(self) -> Any:
        module, _, name = self.job["runner"].partition(":")
        return getattr(importlib.import_module(module), name)

    def _rollout(self, run: Any, scenario: Any, scene: Any, seed: int) -> list[Diagnostic]:
        names, components = self.names.of(scenario, scene)
        try:
            facts, tracks = run(
                scene, names=names, components=components, seed=seed, seconds=self.job["seconds"],
                trajectories=self.job["trajectories"], map_path=str(scene.params.get("map", "")),
            )  # fmt: skip
        except BaseException as error:
            return [diagnose.diagnose(error, "run", self.program)]
        found = diagnose.ending(facts, self.program)
        if found and not facts.ran:  # said as it is said in the stage, and not as Python says it
            facts = facts.model_copy(update={"reason": found[0].message})
        self._send({"facts": facts.model_dump(mode="json")})
        if tracks is not None:
            self._send({"trajectories": tracks.model_dump(mode="json")})
        return found


with contextlib.suppress(ImportError):
    import resource  # noqa: F401
