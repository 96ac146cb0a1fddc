"""What most jobs do, done for nobody: so that a process learns which memory they write on (prefault.py)."""

import marshal
import pickle
import socket
from collections.abc import Callable

from c2s_engine import driving
from c2s_engine.check import execute, library, pieces, reading
from c2s_engine.check.protocol import CheckRequest


def model(path: str, halfway: Callable[[], None]) -> None:
    """What most snapshots on a map do: run the world model."""
    namespace, _ = execute.begin({"params": {"map": path, "carla_map": None}})
    tree, _, _ = pieces.compile_text(f"model {reading.MODEL}\n{driving.IMPORT}\n", "model.scenic")
    halfway()
    execute.run_code(compile(tree, "model.scenic", "exec"), namespace)


def check(halfway: Callable[[], None]) -> None:
    """What most checks do: choose places; then compile and sample a few objects."""
    parts = [library.code(path.read_bytes(), str(path)) for path in library.REHEARSALS]
    job = CheckRequest(program="", filename=str(library.REHEARSALS[-1])).model_dump(mode="json")
    blob = pickle.dumps(([marshal.dumps(code) for code, _, _ in parts], *parts[-1][1:]))
    listener, conn = socket.socketpair()
    with listener, conn:
        rehearsed = execute.Check(conn, {**job, "settings": [], "count": 0}, blob)
        rehearsed.execute(1)
        halfway()
        rehearsed.run()
