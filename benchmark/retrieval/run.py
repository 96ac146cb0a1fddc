"""`make bench-retrieval`: quality of embedding, BM25 and both fused; abstention; latency and memory.

python -m c2s_bench.retrieval [--small] [--all-new] [--out FILE]

Times are of the clock and, as "CPU", of all threads together: the latter also stand on a machine that is busy.
"""

import argparse
import json
import resource
import tempfile
import time
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from statistics import mean, median
from typing import Any

import numpy as np

from c2s_bench.retrieval import metrics
from c2s_bench.retrieval.queries import Query, load, names
from c2s_engine.retrieve.library import Library, default_threads
from c2s_engine.retrieve.retriever import Found, Method, retrieve
from c2s_engine.retrieve.rows import Kind

METHODS: tuple[Method, ...] = ("embedding", "bm25", "fused")
Row = dict[str, float | str]


def quality(library: Library, queries: Iterable[Query]) -> list[Row]:
    """A row for each kind, wording and retriever, over the queries that have an answer."""
    rows: list[Row] = []
    asked = [q for q in queries if q.relevant]
    for kind in ("snippet", "doc"):
        of_kind = [q for q in asked if q.kind == kind]
        parts = {
            "all": of_kind,
            "plain": [q for q in of_kind if not q.reworded],
            "reworded": [q for q in of_kind if q.reworded],
            "reported half": [q for q in of_kind if q.reported],
        }
        for wording, chosen in parts.items():
            for method in METHODS:
                scores = [_scores(library, q, method) for q in chosen]
                rows.append({"kind": kind, "queries": f"{wording} ({len(chosen)})", "retriever": method,
                             **{name: round(mean(s[name] for s in scores), 3) for name in scores[0]}})  # fmt: skip
    return rows


def _scores(library: Library, query: Query, method: Method) -> dict[str, float]:
    shelf = library.opened().shelves[query.kind]
    found = library.find(query.text, query.kind, query.component, 10, method)
    grades, seen = [], set()
    for hit in found.hits:
        title = shelf.row(hit.row).title
        key = title if query.kind == "doc" else hit.item
        grades.append(0 if key in seen else query.grade(hit.item, title))  # a section's second chunk gains nothing
        seen.add(key)
    ideal = _ideal(library, query)
    return {"hit@3": metrics.hit(grades, 3), "recall@10": metrics.recall(grades, len(ideal), 10),
            "MRR": metrics.reciprocal(grades), "nDCG@10": metrics.ndcg(grades, ideal, 10)}  # fmt: skip


def _ideal(library: Library, query: Query) -> list[int]:
    """The grades of all that is relevant in the index."""
    if query.kind == "snippet":
        return list(query.relevant.values())
    titles = set(library.opened().shelves["doc"].table.column("title").to_pylist())
    unknown = [w for w in query.relevant if not any(names(w, t) for t in titles)]
    if unknown:
        raise SystemExit(f"{query.text!r} names passages that are not in the index: {', '.join(unknown)}")
    return [g for g in (query.grade("", t) for t in titles) if g]


def abstention(library: Library, queries: Iterable[Query]) -> list[Row]:
    """F1 of saying that there is no answer, on the half that the thresholds were fitted on and on the other."""
    rows: list[Row] = []
    queries = list(queries)
    for part, reported in (("fitted on", False), ("reported", True)):
        chosen = [q for q in queries if q.reported == reported]
        said = {q.text: not _found(library, q).answerable for q in chosen}
        right = sum(1 for q in chosen if said[q.text] and not q.relevant)
        actual = sum(1 for q in chosen if not q.relevant)
        rows.append({"part": part, "queries": len(chosen), "without answer": actual, "abstained": sum(said.values()),
                     "right": right, "F1": round(metrics.f1(right, sum(said.values()), actual), 3)})  # fmt: skip
    return rows


def _found(library: Library, query: Query) -> Found:
    return library.find(query.text, query.kind, query.component, 10, None)


def latency(library: Library, queries: list[Query]) -> Row:
    """Milliseconds of a warm query with an uncached vector, in the worker's process."""
    for q in queries[:5]:
        _found(library, q)
    times = [_timed(partial(library.search, q.text + " please", q.kind, q.component)) for q in queries[::3]]
    return _latency(times)


def _timed(ask: Callable[[], object]) -> tuple[float, float]:
    """Milliseconds of the clock, and of the processors, that a query takes."""
    start, used = time.perf_counter(), time.process_time()
    ask()
    return (time.perf_counter() - start) * 1000, (time.process_time() - used) * 1000


def _latency(times: list[tuple[float, float]]) -> Row:
    clock, cpu = zip(*times, strict=True)
    return {"median ms": round(median(clock), 1), "95 % ms": round(float(np.percentile(clock, 95)), 1),
            "median CPU ms": round(median(cpu), 1), "95 % CPU ms": round(float(np.percentile(cpu, 95)), 1),
            "peak memory MB": round(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)}  # fmt: skip


def large(library: Library, queries: list[Query], count: int = 100_000) -> Row:
    """The same over 100,000 generated chunks: texts of the index's own words, random unit vectors."""
    from c2s_bench.retrieval.generated import shelf_of

    shelf = shelf_of(library.opened().shelves["doc"], count)
    kind: Kind = "doc"

    def ask(text: str) -> object:
        return retrieve(shelf, kind, text, library.embedder.embed([text])[0], "fused", 5)

    for q in queries[:5]:
        ask(q.text)
    return {"chunks": count, **_latency([_timed(partial(ask, q.text)) for q in queries[:60]])}


def table(rows: list[Row]) -> str:
    """Rows as a Markdown table."""
    names = list(rows[0])
    lines = ["| " + " | ".join(names) + " |", "| " + " | ".join("---" for _ in names) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(r[n]) for n in names) + " |" for r in rows])


def main() -> None:
    """Build an index in a folder of its own and measure on it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--small", action="store_true", help="leave out the 100,000 generated chunks")
    parser.add_argument("--index", type=Path, help="use (and keep) an index in this folder")
    parser.add_argument("--all-new", action="store_true", help="embed everything, take no shipped vectors")
    parser.add_argument("--out", type=Path, help="write the figures as JSON, too")
    options = parser.parse_args()
    queries = load()
    with tempfile.TemporaryDirectory() as folder:
        library = Library(options.index or Path(folder), None, default_threads(), not options.all_new)
        load_ms, load_cpu = _timed(library.embedder.load)
        built: dict[str, Any] = {}
        build_ms, build_cpu = _timed(lambda: built.update(library.build()))
        library.remember([q.text for q in queries])
        figures: dict[str, list[Row]] = {
            "quality": quality(library, queries),
            "abstention": abstention(library, queries),
            "latency": [latency(library, queries)],
            "build": [{"model load s": round(load_ms / 1000, 1), "load CPU s": round(load_cpu / 1000, 1),
                       "build s": round(build_ms / 1000, 1), "build CPU s": round(build_cpu / 1000, 1),
                       "new vectors": built["embedded"], **built["counts"],
                       "MB on disk": round(library.store.size() / 1e6, 1)}],
        }  # fmt: skip
        steps: list[tuple[str, Callable[[], list[Row]]]] = []
        if not options.small:
            steps.append(("large", lambda: [large(library, queries)]))
        for name, step in steps:
            figures[name] = step()
    for name, rows in figures.items():
        print(f"\n{name}\n\n{table(rows)}")
    if options.out:
        options.out.write_text(json.dumps(figures, indent=1))


if __name__ == "__main__":
    main()
