"""The index on disk: generations, each a LanceDB database with its postings and a manifest.

A build writes a new generation beside the current one and then swaps one small file (`current`), so that a reader sees
the old index or the new one, and a build that is killed leaves the old one as it was.
"""

import json
import os
import shutil
import uuid
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import lancedb
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from c2s_engine.retrieve.bm25 import Postings
from c2s_engine.retrieve.errors import RetrievalError, storage_error
from c2s_engine.retrieve.rows import SCHEMA, TABLES, Kind, Row, Source
from c2s_engine.retrieve.tokens import tokenise

TEXT_COLUMNS = ("item", "source_id", "title", "text", "embedded", "lexical", "source", "clause", "component",
                "terms", "key")  # fmt: skip
KEEP = 2  # generations: the current one, and the one that a reader in another process may still be opening
Progress = Callable[[str, int, int], None]


@dataclass
class Manifest:
    """What a generation was made of."""

    model: str
    dimensions: int
    shipped: str  # digest of the shipped data and the installed Scenic
    sources: list[Source] = field(default_factory=list)
    counts: dict[str, int] = field(default_factory=dict)
    schema: int = SCHEMA

    def dump(self) -> str:
        return json.dumps({**self.__dict__, "sources": [s.as_dict() for s in self.sources]}, indent=1)

    @classmethod
    def parse(cls, text: str) -> "Manifest":
        data = json.loads(text)
        return cls(**{**data, "sources": [Source(**s) for s in data["sources"]]})


class Shelf:
    """One table of a generation, in memory for searching: its rows, unit vectors, and the postings of those rows that
    have a lexical text."""

    def __init__(self, table: pa.Table, postings: Postings):
        self.table = table.drop_columns(["vector"])
        self.postings = postings
        vectors = table.column("vector").combine_chunks()
        width = vectors.type.list_size
        self.vectors = vectors.values.to_numpy(zero_copy_only=False).reshape(-1, width)
        self.items = table.column("item").to_pylist()
        self.lexical_rows = np.flatnonzero(pc.not_equal(table.column("lexical"), "").to_numpy())
        self.clauses = table.column("clause").to_pylist()
        self.components = np.asarray(table.column("component").to_pylist(), dtype=object)
        self.terms = [terms.split() for terms in table.column("terms").to_pylist()]
        if len(self.lexical_rows) != postings.size:
            raise ValueError("the postings do not fit the table")

    def __len__(self) -> int:
        return len(self.items)

    def row(self, index: int) -> Row:
        """The row at an index."""
        return _row(self.table.slice(index, 1).to_pylist()[0])

    def rows(self) -> list[Row]:
        """All rows."""
        return [_row(r) for r in self.table.to_pylist()]


def _row(record: dict) -> Row:
    return Row(**{name: record[name] for name in Row.__slots__ if name != "page"}, page=int(record["page"]))


@dataclass
class Generation:
    """An opened generation."""

    name: str
    manifest: Manifest
    shelves: dict[Kind, Shelf]


class Store:
    """The index folder. Reading needs no lock; whoever writes holds `lock.exclusive`."""

    def __init__(self, folder: Path):
        self.folder = folder

    def current_name(self) -> str | None:
        """The name of the generation in force, if there is one."""
        try:
            name = (self.folder / "current").read_text().strip()
        except OSError:
            return None
        return name if name and (self.folder / name / "manifest.json").is_file() else None

    def manifest(self) -> Manifest | None:
        """The manifest in force; None where there is no index, or one of another schema."""
        name = self.current_name()
        if name is None:
            return None
        try:
            manifest = Manifest.parse((self.folder / name / "manifest.json").read_text())
        except (OSError, ValueError, TypeError, KeyError):
            return None
        return manifest if manifest.schema == SCHEMA else None

    def old_sources(self) -> list[Source]:
        """The user's sources as far as any manifest, even of another schema, still tells."""
        name = self.current_name()
        try:
            data = json.loads((self.folder / (name or "") / "manifest.json").read_text())
            return [Source(**s) for s in data["sources"] if s.get("origin") == "user"]
        except (OSError, ValueError, TypeError, KeyError):
            return []

    def open(self) -> Generation | None:
        """The generation in force, read into memory; raises RetrievalError where it is damaged."""
        for attempt in range(2):
            name, manifest = self.current_name(), self.manifest()
            if name is None or manifest is None:
                return None
            try:
                database = lancedb.connect(str(self.folder / name / "lance"))
                shelves = {}
                for kind, table in TABLES.items():
                    shelves[kind] = Shelf(
                        database.open_table(table).to_arrow(), Postings.load(self.folder / name / f"{table}.npz")
                    )
                return Generation(name, manifest, shelves)
            except Exception as error:  # LanceDB raises what its Rust core gives: all of it means "not readable"
                if attempt and self.current_name() == name:
                    raise RetrievalError(
                        f"The index in {self.folder} is damaged: run `c2s index build` ({str(error)[:120]!r})."
                    ) from None
        return None

    def write(
        self,
        tables: Mapping[Kind, tuple[Sequence[Row], np.ndarray]],
        manifest: Manifest,
        progress: Progress | None = None,
    ) -> None:
        """Write a whole new generation and put it in force; raises RetrievalError, and then nothing has changed."""
        name = f"generation-{uuid.uuid4().hex[:12]}"
        building = self.folder / f"{name}.building"
        try:
            self.sweep()
            building.mkdir(parents=True)
            database = lancedb.connect(str(building / "lance"))
            for i, (kind, (rows, vectors)) in enumerate(tables.items()):
                if progress:
                    progress("writing", i, len(tables))
                database.create_table(TABLES[kind], _arrow(rows, vectors, manifest.dimensions))
                Postings.build(tokenise(r.lexical) for r in rows if r.lexical).save(building / f"{TABLES[kind]}.npz")
                manifest.counts[kind] = len({r.item for r in rows})
            (building / "manifest.json").write_text(manifest.dump())
            _sync(building)
            building.rename(self.folder / name)
            pointer = self.folder / f"current.{os.getpid()}"
            pointer.write_text(name)
            _sync_file(pointer)
            os.replace(pointer, self.folder / "current")
            self.sweep()
        except (OSError, RuntimeError, ValueError) as error:
            raise storage_error(error, self.folder) from None
        finally:
            shutil.rmtree(building, ignore_errors=True)

    def sweep(self) -> None:
        """Remove what killed builds left, and generations that are no longer in force. Called under the lock."""
        current = self.current_name()
        for path in self.folder.glob("*.building"):
            shutil.rmtree(path, ignore_errors=True)
        for path in self.folder.glob("current.*"):
            path.unlink(missing_ok=True)
        old = [p for p in self.folder.glob("generation-*") if p.name != current]
        old.sort(key=lambda p: p.stat().st_mtime, reverse=True)
        for path in old[KEEP - 1 :]:
            shutil.rmtree(path, ignore_errors=True)

    def size(self) -> int:
        """Bytes on disk of the generation in force."""
        name = self.current_name()
        return sum(p.stat().st_size for p in (self.folder / name).rglob("*") if p.is_file()) if name else 0


def _arrow(rows: Sequence[Row], vectors: np.ndarray, dimensions: int) -> pa.Table:
    columns: dict[str, pa.Array] = {n: pa.array([getattr(r, n) for r in rows], pa.large_string()) for n in TEXT_COLUMNS}
    columns["page"] = pa.array([r.page for r in rows], pa.int32())
    flat = pa.array(np.ascontiguousarray(vectors, np.float32).reshape(-1), pa.float32())
    columns["vector"] = pa.FixedSizeListArray.from_arrays(flat, dimensions)
    return pa.table(columns)


def _sync(folder: Path) -> None:
    """Have everything in a folder on the disk before it is put in force."""
    for path in _files(folder):
        _sync_file(path)


def _files(folder: Path) -> Iterable[Path]:
    return (p for p in folder.rglob("*") if p.is_file())


def _sync_file(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
