"""One task of the benchmark: a method on a record's text, and what came of it, as plain JSON."""

import hashlib
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import Any

import c2s_engine
from c2s_bench.records import Record
from c2s_engine.config import METHOD, load_settings
from c2s_engine.maps.library import MapLibrary
from c2s_engine.models.settings import settings_for
from c2s_engine.paths import shipped
from c2s_engine.structure.facts import RunFacts

# Parts of the engine that no outcome depends on.
NOT_THE_METHOD = ("cli.py", "session/sessions.py", "session/session.py", "session/store.py", "session/journal.py")


@dataclass(frozen=True)
class Setup:
    """How records are run: method, model (empty: none), map (None: the method's choice), K rollouts, first seed."""

    method: str = METHOD
    model: str = ""
    map: str | None = None
    runs: int = 5
    seed: int = 0

    @property
    def name(self) -> str:
        """A name for files and tables."""
        return f"{self.method}@{self.model}" if self.model else self.method


@dataclass(frozen=True)
class Task:
    """What a worker gets; `key` is the digest of all that the outcome depends on."""

    key: str
    id: str
    text: str
    setup: Setup

    def as_dict(self) -> dict[str, Any]:
        return asdict(self)

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "Task":
        return cls(data["key"], data["id"], data["text"], Setup(**data["setup"]))


@dataclass
class Outcome:
    """What a method made of a record's text. `seconds` from the text to the last version of the program."""

    key: str
    id: str
    program: str = ""
    stages: tuple[dict[str, Any], ...] = ()
    facts: tuple[dict[str, Any], ...] = ()
    required: tuple[dict[str, Any], ...] = ()  # what S requires: id, kind, holds (over most rollouts)
    seconds: float = 0.0
    tokens: float = 0.0
    folder: str = ""  # where the program's map lies
    share: float | None = None  # of the components that no fallback stands in for; None: no model was at work
    error: str = ""  # why there is no result; such an outcome is not kept

    def run_facts(self) -> Sequence[RunFacts]:
        return [RunFacts.model_validate(f) for f in self.facts]

    @property
    def reason(self) -> str:
        """In one line, why it did not run, where it did not."""
        for stage in self.stages:
            if not stage["ok"]:
                return f"{stage['name']}: {stage.get('message', '')}"
        broken = [f for f in self.facts if f["ended_by"] not in ("time", "terminated", "collision")]
        if broken:
            return f"run {broken[0]['ended_by']}: {broken[0].get('reason', '')}"
        return self.error or ("" if self.facts else "no rollout was made")


def tasks_for(records: Sequence[Record], setup: Setup) -> list[Task]:
    """The tasks of those records, each under the digest of text, setup, how a model is asked, engine and data."""
    state = [asdict(setup), _asking(setup.model), engine_digest()]
    return [Task(_digest([r.text, *state]), r.id, r.text, setup) for r in records]  # what is expected is only scored


def _asking(model: str) -> dict[str, Any]:
    """The settings that an answer depends on; raises BadSettings."""
    if not model:
        return {}
    wanted = {"num_ctx", "answer_tokens", "think", "temperature", "seed"}
    return settings_for(model, load_settings().ollama).model_dump(include=wanted)


@cache
def engine_digest() -> str:
    """The digest of the engine's code, of the shipped data and of the maps at hand."""
    root = Path(c2s_engine.__file__).parent
    found = hashlib.sha256()
    for base, pattern in ((root, "**/*.py"), (shipped(), "**/*")):
        for file in sorted(base.glob(pattern)):
            relative = file.relative_to(base).as_posix()
            if file.is_file() and "__pycache__" not in relative and not relative.startswith(NOT_THE_METHOD):
                found.update(relative.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    known = load_settings()
    for chart in MapLibrary(known.map_folders, known.carla_root).list():
        found.update(f"{chart.name} {chart.digest}\n".encode())
    return found.hexdigest()[:16]


def _digest(value: Any) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()[:24]
