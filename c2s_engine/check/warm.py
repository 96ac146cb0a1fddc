"""What is loaded once before anything is checked: Scenic and what it imports; and the hooks that keep the rest."""

import functools
import gc
import importlib
import os
import random
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from c2s_engine import driving
from c2s_engine.check import landlock, library, networks, quick_parser

_prepare: Callable[[Any, str], None] | None = None


def warm(standins: Path, runner: str | None = None) -> None:
    """Import everything that checks share. Call it once, in a process without threads."""
    gc.disable()
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ[name] = "1"
    if standins.is_dir():
        sys.path.insert(0, str(standins))
        sys.path.append(str(standins / "spare"))
    sys.path.insert(0, str(driving.path().parent))  # before the folder that c2s was started in, which may hold a copy
    import scenic.syntax.translator as translator
    from scenic.core import regions, type_support
    from scenic.domains.driving import roads

    translator.compileStream = _compile_stream
    type_support.saveErrorLocation = _error_location
    quick_parser.install()
    regions.polygonUnion = networks.union(regions.polygonUnion)
    roads.Network.fromFile = classmethod(networks.from_file(roads.Network.fromFile.__func__))
    for name in (
        "scenic.domains.driving.actions", "scenic.domains.driving.simulators", "scenic.domains.driving.workspace",
        "scenic.simulators.carla.actions", "scenic.simulators.carla.blueprints", "scenic.simulators.carla.sensors",
        "scenic.simulators.carla.simulator", "scenic.simulators.utils.colors", "scenic.core.pruning", "scipy.spatial",
    ):  # fmt: skip
        importlib.import_module(name)
    landlock.always()
    if runner:
        global _prepare
        _prepare = getattr(importlib.import_module(runner.partition(":")[0]), "prepare", None)
        prepare()
    gc.collect()
    gc.freeze()


def prepare(network: Any = None, path: str = "") -> None:
    """Let the runner make what its runs share: once at the start, and for each map that is loaded to be kept."""
    if _prepare is not None:
        _prepare(network, path)


def reseed(seed: int) -> None:
    """Set every random state that Scenic draws from."""
    import numpy

    random.seed(seed)
    numpy.random.seed(seed % (1 << 32))


def random_state() -> tuple:
    """The random states that `reseed` sets, to be compared."""
    import numpy

    kind, keys, *rest = numpy.random.get_state()
    return random.getstate(), kind, tuple(keys), *rest


def _error_location() -> Any:
    """Scenic's saveErrorLocation without reading sources: the innermost frame outside Scenic's core."""
    import traceback

    frame = sys._getframe(1)
    while frame is not None:
        name = frame.f_code.co_filename
        if not (_is_hidden(name)):
            return traceback.FrameSummary(name, frame.f_lineno, frame.f_code.co_name, lookup_line=False)
        frame = frame.f_back  # type: ignore[assignment]
    return None


@functools.cache
def _is_hidden(filename: str) -> bool:
    from scenic.core import errors

    parents = Path(filename).parents
    return filename in errors.hiddenFolders or any(folder in parents for folder in errors.hiddenFolders)


def _compile_stream(stream: Any, namespace: dict, options: Any, filename: str) -> tuple[Any, str]:
    """Scenic's compileStream with the parsing and compiling left out where the source is known."""
    from scenic.syntax import translator, veneer

    veneer.activate(options, namespace)
    try:
        exec(compile(translator.preamble, "<veneer>", "exec"), namespace)
        namespace[translator.namespaceReference] = namespace
        code, requirements, digest = library.code(stream.read(), filename)
        translator.executeCodeIn(code, namespace)
        translator.storeScenarioStateIn(namespace, requirements, digest, options)
    finally:
        veneer.deactivate()
    return code, ""
