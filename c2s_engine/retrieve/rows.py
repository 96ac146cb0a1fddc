"""What the stores hold: rows of chunks of documents, rows of snippets (one for each phrase that describes it)."""

import hashlib
from dataclasses import asdict, dataclass, field
from typing import Literal

from c2s_engine.retrieve.wording import plain

Kind = Literal["doc", "snippet"]
TABLES: dict[Kind, str] = {"doc": "documents", "snippet": "snippets"}
SCHEMA = 2
"""Raised with every change of the tables, the chunking or the tokeniser: an older index is built anew."""


@dataclass(frozen=True, slots=True)
class Row:
    """`embedded` is what the vector is of, `lexical` what BM25 reads, `text` what is shown.

    An item may have several rows (phrases of a snippet; heading and sentences of a chunk): its nearest one counts. Only
    rows with a `lexical` text are known to BM25. `terms`: the words of the vocabulary that a snippet is about, apart by
    blanks; empty where they are not known."""

    item: str
    source_id: str
    title: str
    text: str
    embedded: str
    lexical: str
    source: str
    clause: str = ""
    page: int = 0
    component: str = ""
    terms: str = ""

    @property
    def key(self) -> str:
        """The digest of what was embedded: a row whose key is known needs no new vector."""
        return hashlib.sha256(plain(self.embedded).encode()).hexdigest()[:32]


@dataclass(frozen=True)
class Source:
    """Something that was indexed: where it is, its digest, and how many items it gave."""

    id: str
    location: str
    title: str
    kind: Kind
    origin: Literal["shipped", "scenic", "user"]
    digest: str
    items: int = 0

    def as_dict(self) -> dict:
        return asdict(self)


@dataclass
class Batch:
    """A source with its rows."""

    source: Source
    rows: list[Row] = field(default_factory=list)


def digest(*parts: str | bytes) -> str:
    """A short digest of texts."""
    total = hashlib.sha256()
    for part in parts:
        total.update(part.encode() if isinstance(part, str) else part)
        total.update(b"\0")
    return total.hexdigest()[:16]


def source_id(location: str) -> str:
    """The id of what is at a location: short, and the same in every build."""
    return digest(location)[:10]
