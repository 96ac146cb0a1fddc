"""The library: the index with its embedder, as the worker serves it."""

import os
import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from c2s_engine.retrieve import snippet_files, sources, vectors
from c2s_engine.retrieve.embedder import Embedder
from c2s_engine.retrieve.errors import BadDocument, RetrievalError, storage_error
from c2s_engine.retrieve.lock import exclusive
from c2s_engine.retrieve.retriever import Found, Method, retrieve
from c2s_engine.retrieve.rows import TABLES, Batch, Kind, Row, Source, digest, source_id
from c2s_engine.retrieve.store import Generation, Manifest, Store
from c2s_engine.retrieve.wording import plain
from c2s_engine.structure.progress import Passage

Progress = Callable[[str, int, int], None]
REMEMBERED = 512  # queries whose vectors are kept


def _silent(stage: str, done: int, total: int) -> None:
    pass


class Library:
    """Everything that can be done with the index in a folder. Searching and one writing call may run at once."""

    def __init__(self, folder: Path, model: str | None = None, threads: int | None = None, ready_made: bool = True):
        """`ready_made`: take the shipped vectors for what is shipped."""
        self.ready_made = ready_made
        self.store = Store(folder)
        self.embedder = Embedder(model, threads)
        self._opened: Generation | None = None
        self._queries: OrderedDict[str, np.ndarray] = OrderedDict()
        self._opening = threading.Lock()
        self._writing = threading.Lock()
        self._shipped: str | None = None

    def shipped(self) -> str:
        """The digest of the shipped data, taken once."""
        if self._shipped is None:
            self._shipped = sources.shipped_digest()
        return self._shipped

    def stale(self) -> str:
        """Why the index must be built before it can be searched; empty where it need not."""
        manifest = self.store.manifest()
        if manifest is None:
            return "there is no index yet" if self.store.current_name() is None else "the index is of an older version"
        return "the shipped data or Scenic have changed" if manifest.shipped != self.shipped() else ""

    def opened(self, progress: Progress = _silent) -> Generation:
        """The generation in force, built first where it must be; raises RetrievalError."""
        opened = self._opened
        if opened is not None and opened.name == self.store.current_name():
            return opened  # what was looked at when it was opened cannot have changed under the same name
        with self._opening:
            if self.stale():
                self.build(progress, only_if_stale=True)
            manifest = self.store.manifest()
            if manifest and manifest.model != self.embedder.name:
                raise RetrievalError(
                    f"The index was made with {manifest.model}, the model is now {self.embedder.name}: "
                    "run `c2s index build`."
                )
            if self._opened is None or self._opened.name != self.store.current_name():
                self._opened = self.store.open()
            if self._opened is None:
                raise RetrievalError(f"There is no index in {self.store.folder}: run `c2s index build`.")
            return self._opened

    def embed(self, texts: Sequence[str]) -> np.ndarray:
        """Unit vectors of texts, as they are."""
        return self.embedder.embed(texts)

    def vector(self, query: str) -> np.ndarray:
        """The vector of a query; the latest are remembered."""
        if query not in self._queries:
            self.remember([query])
            while len(self._queries) > REMEMBERED:
                self._queries.popitem(last=False)
        return self._queries[query]

    def remember(self, queries: Sequence[str]) -> None:
        """Embed queries beforehand, all at once."""
        self._queries.update(zip(queries, self.embedder.embed([plain(q) for q in queries]), strict=True))

    def find(self, query: str, kind: Kind, component: str | None, limit: int, method: Method | None,
             terms: Sequence[str] = ()) -> Found:  # fmt: skip
        """The hits of a query. Snippets are ranked by cosine, documents by fusion, unless `method` says so."""
        generation = self.opened()
        chosen = method or ("embedding" if kind == "snippet" else "fused")
        return retrieve(generation.shelves[kind], kind, query, self.vector(query), chosen, limit, component, terms)

    def search(self, query: str, kind: Kind = "doc", component: str | None = None, limit: int = 5,
               abstain: bool = True, method: Method | None = None,
               terms: Sequence[str] = ()) -> list[Passage]:  # fmt: skip
        """The passages that answer a query, best first; none where nothing fits (and `abstain` holds). `terms`: see
        retriever.retrieve."""
        if not query.strip():
            return []
        if component:
            component = component[0].upper()
        found = self.find(query, kind, component, limit, method, terms)
        if abstain and not found.answerable:
            return []
        shelf = self.opened().shelves[kind]
        passages = []
        for hit in found.hits:
            row = shelf.row(hit.row)
            passages.append(
                Passage(kind=kind, title=row.title, text=row.text, score=round(hit.cosine, 4), source=row.source,
                        clause=row.clause, component=row.component, id=row.item, page=row.page or None, ranks=hit.ranks)
            )  # fmt: skip
        return passages

    def build(self, progress: Progress = _silent, only_if_stale: bool = False) -> dict:
        """Build the index anew from the shipped data and what the user added; known vectors are kept."""
        progress("reading", 0, 1)
        batches = sources.shipped_batches()
        lost: list[str] = []
        with self._writing, exclusive(self.store.folder):
            if only_if_stale and not self.stale():  # another thread or process has built it meanwhile
                return {"embedded": 0, "lost": [], "counts": self._counts()}
            current = self._current()
            if current:
                batches += _user_batches(current)
            else:
                for source in self.store.old_sources():
                    try:
                        batches.append(sources.user_batch(source.location))
                    except BadDocument as error:
                        lost.append(str(error))
            made = self._write(batches, current, progress)
        return {"embedded": made, "lost": lost, "counts": self._counts()}

    def add(self, location: str, progress: Progress = _silent) -> dict:
        """Index a file, a folder or an address; says what was added and, a sentence each, what was not."""
        added, refused = [], []
        names = sources.locations(location)
        for i, name in enumerate(names):
            progress("reading", i, len(names))
            try:
                added.append(sources.user_batch(name))
            except BadDocument as error:
                if len(names) == 1:
                    raise
                refused.append(str(error))
        self._add(added, progress)
        return {"added": [{"id": b.source.id, "title": b.source.title, "location": b.source.location,
                           "items": len({r.item for r in b.rows})} for b in added], "refused": refused}  # fmt: skip

    def add_snippets(self, location: str, title: str, snippets: Sequence[dict], progress: Progress = _silent) -> dict:
        """Index component snippets of a user's program (`component`, `description`, `code` each)."""
        id = source_id(f"{location}#snippets")
        parts = [snippet_files.Snippet(id=f"{id}/{i}", **s) for i, s in enumerate(snippets)]
        source = Source(id, location, title, "snippet", "user", digest(*(p.model_dump_json() for p in parts)))
        self._add([Batch(source, snippet_files.rows(parts, id, location))], progress)
        return {"id": id, "title": title, "location": location, "items": len(parts)}

    def _add(self, batches: list[Batch], progress: Progress) -> None:
        if not batches:
            return
        self.opened(progress)
        with self._writing, exclusive(self.store.folder):
            current = self._current()
            if current is None:
                raise RetrievalError(f"There is no index in {self.store.folder}: run `c2s index build`.")
            fresh = {b.source.id for b in batches}
            kept = [b for b in _all_batches(current) if b.source.id not in fresh]
            self._write([*kept, *batches], current, progress)

    def remove(self, id: str) -> dict:
        """Remove one of the user's sources, by its id or location; raises RetrievalError for what is not theirs."""
        with self._writing, exclusive(self.store.folder):
            current = self._current()
            known = current.manifest.sources if current else []
            wanted = [
                s for s in known if id in (s.id, s.location) or str(Path(id).expanduser().absolute()) == s.location
            ]
            if not wanted:
                raise RetrievalError(
                    f"There is nothing with the id {id} in the index: `c2s index list` shows what there is."
                )
            if any(s.origin != "user" for s in wanted):
                raise RetrievalError(f"{wanted[0].title} is shipped with the program and stays in the index.")
            assert current
            gone = {s.id for s in wanted}
            self._write([b for b in _all_batches(current) if b.source.id not in gone], current, _silent)
        return {"removed": [s.as_dict() for s in wanted]}

    def contents(self) -> dict:
        """What is indexed, and what the index is made of."""
        manifest = self.store.manifest()
        if manifest is None:
            return {"sources": [], "stale": self.stale()}
        return {"sources": [s.as_dict() for s in manifest.sources], "model": manifest.model, "counts": manifest.counts,
                "bytes": self.store.size(), "folder": str(self.store.folder), "stale": self.stale()}  # fmt: skip

    def verify(self) -> dict:
        """Whether the index is whole and up to date; each finding is a sentence."""
        findings = []
        if reason := self.stale():
            findings.append(f"It must be built: {reason} (`c2s index build`).")
        generation = self.store.open()
        if generation is None:
            return {"ok": False, "findings": findings}
        manifest = generation.manifest
        if manifest.model != self.embedder.name:
            findings.append(
                f"It was made with {manifest.model}, the model is now {self.embedder.name} (`c2s index build`)."
            )
        for kind, shelf in generation.shelves.items():
            norms = np.linalg.norm(shelf.vectors, axis=1)
            if len(shelf) and not np.allclose(norms, 1.0, atol=1e-3):
                findings.append(f"{int((abs(norms - 1) > 1e-3).sum())} vectors of the {TABLES[kind]} are damaged.")
            if len(set(shelf.items)) != manifest.counts.get(kind):
                findings.append(f"The number of {TABLES[kind]} is not what the manifest says.")
        for source in manifest.sources:
            if source.origin == "user" and source.kind == "doc" and not source.location.startswith("http"):
                path = Path(source.location)
                if not path.is_file():
                    findings.append(f"{source.location} is no longer there (its text is still in the index).")
                elif digest(path.read_bytes()) != source.digest:
                    findings.append(f"{source.location} has changed: add it again.")
        return {"ok": not findings, "findings": findings, "counts": manifest.counts, "model": manifest.model}

    def _current(self) -> Generation | None:
        """The generation in force to build upon; a damaged one counts as none."""
        try:
            return self.store.open()
        except RetrievalError:
            return None

    def _counts(self) -> dict:
        manifest = self.store.manifest()
        return manifest.counts if manifest else {}

    def _write(self, batches: list[Batch], current: Generation | None, progress: Progress) -> int:
        """Write a generation of these sources; returns how many rows needed a new vector."""
        model = self.embedder.name
        tables: dict[Kind, list[Row]] = {kind: [] for kind in TABLES}
        for batch in batches:
            tables[batch.source.kind].extend(batch.rows)
        known: dict[str, np.ndarray] = vectors.known(model) if self.ready_made else {}
        if current and current.manifest.model == model:
            for shelf in current.shelves.values():
                known.update(zip(shelf.table.column("key").to_pylist(), shelf.vectors, strict=True))
        texts = {r.key: r.embedded for rows in tables.values() for r in rows}
        missing = [key for key in texts if key not in known]
        if missing:
            made = self.embedder.embed([plain(texts[k]) for k in missing], lambda d, n: progress("embedding", d, n))
            known.update(zip(missing, made, strict=True))
        dimensions = len(next(iter(known.values()))) if known else 384
        filled = {
            kind: (rows, np.stack([known[r.key] for r in rows]) if rows else np.zeros((0, dimensions), np.float32))
            for kind, rows in tables.items()
        }
        listed = []
        for batch in batches:
            items = len({r.item for r in batch.rows})
            listed.append(Source(**{**batch.source.as_dict(), "items": items}))
        try:
            self.store.write(filled, Manifest(model, dimensions, self.shipped(), listed), progress)
        except OSError as error:
            raise storage_error(error, self.store.folder) from None
        progress("done", 1, 1)
        return len(missing)


def _all_batches(generation: Generation) -> list[Batch]:
    """The sources of a generation with their rows, as they were indexed."""
    batches = {s.id: Batch(s) for s in generation.manifest.sources}
    for shelf in generation.shelves.values():
        for row in shelf.rows():
            if row.source_id in batches:
                batches[row.source_id].rows.append(row)
    return list(batches.values())


def _user_batches(generation: Generation) -> list[Batch]:
    return [b for b in _all_batches(generation) if b.source.origin == "user"]


def default_threads() -> int:
    """Threads of the embedding model: all cores but never more than four."""
    return min(4, os.cpu_count() or 1)
