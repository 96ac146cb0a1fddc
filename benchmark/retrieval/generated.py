"""A large generated shelf for timing."""

import random

import numpy as np
import pyarrow as pa

from c2s_engine.retrieve.bm25 import Postings
from c2s_engine.retrieve.store import Shelf
from c2s_engine.retrieve.tokens import tokenise


def shelf_of(source: Shelf, count: int, seed: int = 0) -> Shelf:
    """`count` chunks of 120 words, drawn from the source's words as often as they occur there, with random vectors."""
    draw = random.Random(seed)
    words = " ".join(source.table.column("lexical").to_pylist()).split()
    texts = [" ".join(draw.choices(words, k=120)) for _ in range(count)]
    vectors = np.random.default_rng(seed).standard_normal((count, source.vectors.shape[1])).astype(np.float32)
    vectors /= np.linalg.norm(vectors, axis=1, keepdims=True)
    empty = pa.array([""] * count, pa.large_string())
    columns: dict[str, pa.Array] = dict.fromkeys(
        ("source_id", "title", "embedded", "source", "clause", "component", "key"), empty
    )
    columns |= {
        "item": pa.array([f"generated/{i}" for i in range(count)], pa.large_string()),
        "text": pa.array(texts, pa.large_string()),
        "lexical": pa.array(texts, pa.large_string()),
        "page": pa.array([0] * count, pa.int32()),
        "vector": pa.FixedSizeListArray.from_arrays(pa.array(vectors.reshape(-1)), vectors.shape[1]),
    }
    return Shelf(pa.table(columns), Postings.build(tokenise(text) for text in texts))
