"""Vectors of the shipped data, made beforehand: the first index is there in seconds instead of a minute.

They are used for rows whose key (the digest of what is embedded) is among them, and only with the model that made them;
everything else is embedded when the index is built. `python -m c2s_engine.retrieve.vectors` makes them anew.
"""

import numpy as np

from c2s_engine.paths import shipped

FILE = "vectors.npz"


def known(model: str) -> dict[str, np.ndarray]:
    """Key to unit vector, of the shipped file; nothing where it is missing or was made by another model."""
    try:
        with np.load(shipped(FILE), allow_pickle=False) as data:
            if str(data["model"]) != model:
                return {}
            vectors = data["vectors"].astype(np.float32)
            keys = [bytes(row).hex() for row in data["keys"]]
    except (OSError, ValueError, KeyError):
        return {}
    vectors /= np.linalg.norm(vectors, axis=1, keepdims=True)
    return dict(zip(keys, vectors, strict=True))


def make() -> int:
    """Write the file for the data as they are now; how many vectors it holds."""
    from c2s_engine.retrieve import sources
    from c2s_engine.retrieve.embedder import Embedder
    from c2s_engine.retrieve.wording import plain

    embedder = Embedder()
    texts = {r.key: plain(r.embedded) for batch in sources.shipped_batches() for r in batch.rows}
    found = known(embedder.name)
    missing = [key for key in texts if key not in found]
    found.update(zip(missing, embedder.embed([texts[k] for k in missing]), strict=True))
    keys = sorted(texts)
    np.savez_compressed(
        shipped(FILE),
        model=np.asarray(embedder.name),
        keys=np.frombuffer(bytes.fromhex("".join(keys)), np.uint8).reshape(len(keys), -1),
        vectors=np.stack([found[k] for k in keys]).astype(np.float16),
    )
    return len(keys)


if __name__ == "__main__":
    print(f"{make()} vectors")
