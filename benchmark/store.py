"""Outcomes kept under the digest of what they depend on, so that an interrupted run goes on where it stopped."""

import json
import os
from dataclasses import asdict
from pathlib import Path

from c2s_bench.tasks import Outcome
from c2s_engine.paths import cache_folder


class Store:
    """One file an outcome; a file appears whole or not at all."""

    def __init__(self, folder: Path | None = None):
        self.folder = folder or cache_folder() / "bench" / "outcomes"

    def get(self, key: str) -> Outcome | None:
        try:
            return Outcome(**json.loads(self._file(key).read_text(encoding="utf-8")))
        except (OSError, ValueError, TypeError):
            return None

    def put(self, outcome: Outcome) -> None:
        """Keep an outcome, unless it tells of a fault of the surroundings (no model, a process that died)."""
        if outcome.error:
            return
        file = self._file(outcome.key)
        file.parent.mkdir(parents=True, exist_ok=True)
        part = file.with_suffix(f".{os.getpid()}.part")
        part.write_text(json.dumps(asdict(outcome)), encoding="utf-8")
        part.replace(file)

    def _file(self, key: str) -> Path:
        return self.folder / key[:2] / f"{key}.json"
