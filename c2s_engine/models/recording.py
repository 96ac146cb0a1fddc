"""Recorded answers by the digest of their question: an experiment can be repeated without a model."""

import json
import os
from pathlib import Path

from pydantic import ValidationError

from c2s_engine.models.messages import Reply


class Recording:
    """A folder of answers, one file each; writing is atomic, a damaged file counts as absent."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def _path(self, digest: str) -> Path:
        return self.folder / digest[:2] / f"{digest}.json"

    def get(self, digest: str) -> Reply | None:
        """The recorded answer, marked as replayed."""
        try:
            data = json.loads(self._path(digest).read_text(encoding="utf-8"))
            return Reply.model_validate(data["reply"]).model_copy(update={"replayed": True})
        except (OSError, ValueError, KeyError, ValidationError):
            return None

    def put(self, digest: str, model: str, purpose: str, reply: Reply) -> None:
        """Keep an answer."""
        path = self._path(digest)
        path.parent.mkdir(parents=True, exist_ok=True)
        data = {"model": model, "purpose": purpose, "reply": reply.model_dump()}
        fresh = path.with_suffix(f".{os.getpid()}.tmp")
        fresh.write_text(json.dumps(data, indent=1), encoding="utf-8")
        fresh.replace(path)
