"""What is indexed: the shipped notes and snippets, the installed Scenic's reference, and the user's documents."""

import os
import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from c2s_engine.paths import shipped
from c2s_engine.retrieve import scenic_reference, snippet_files, web
from c2s_engine.retrieve.blocks import Chunk, chunks
from c2s_engine.retrieve.errors import BadDocument
from c2s_engine.retrieve.markdown import read_markdown
from c2s_engine.retrieve.readers import SUFFIXES, Document, read_file
from c2s_engine.retrieve.rows import SCHEMA, Batch, Row, Source, digest, source_id

MOST_FILES = 5000


def shipped_digest() -> str:
    """The digest of all that a build reads of what is installed."""
    parts: list[str | bytes] = [str(SCHEMA), scenic_reference.scenic_version()]
    for path in _shipped_files():
        parts += [path.name, path.read_bytes()]
    return digest(*parts)


def _shipped_files() -> list[Path]:
    notes = sorted(shipped("docs").glob("*.md"))
    return notes + [p for f in snippet_files.FOLDERS for p in sorted(shipped("snippets", f).glob("*.scenic"))]


def shipped_batches() -> list[Batch]:
    """The shipped notes and snippets and the installed Scenic's reference, as rows."""
    batches = []
    for path in sorted(shipped("docs").glob("*.md")):
        blocks = read_markdown(path.read_text())
        title = next((b.text for b in blocks if b.kind == "heading" and b.level == 1), path.stem)
        blocks = [b for b in blocks if not (b.kind == "heading" and b.level == 1)]
        source = Source(
            source_id(f"docs/{path.name}"), f"docs/{path.name}", title, "doc", "shipped", digest(path.read_bytes())
        )
        batches.append(Batch(source, document_rows(chunks(blocks, title), source, sentences=True)))
    location = f"scenic {scenic_reference.scenic_version()}"
    reference = Source(
        source_id("scenic"), location, f"Reference of the installed {location}", "doc", "scenic", location
    )
    batches.append(Batch(reference, document_rows(scenic_reference.reference(), reference)))
    snippets = list(snippet_files.shipped(shipped("snippets")))
    name = "c2s snippets"
    source = Source(
        source_id("snippets"), "snippets", name, "snippet", "shipped", digest(*(s.model_dump_json() for s in snippets))
    )
    batches.append(Batch(source, snippet_files.rows(snippets, source.id, name)))
    return batches


def document_rows(found: Iterable[Chunk], source: Source, sentences: bool = False) -> list[Row]:
    """The rows of chunks: title path and text together, the heading alone, and (`sentences`) each sentence.

    A short question is nearer to a heading or a sentence than to a whole chunk."""
    rows = []
    for number, chunk in enumerate(found):
        title = " › ".join(chunk.path)
        below = " › ".join(chunk.path[1:]) or chunk.path[0]
        whole = Row(
            item=f"{source.id}/{number}", source_id=source.id, title=title, text=chunk.text,
            embedded=f"{below}\n{chunk.text}",
            lexical=f"{title}\n{chunk.clause}\n{chunk.text}", source=source.title, clause=chunk.clause, page=chunk.page,
        )  # fmt: skip
        rows.append(whole)
        facets = [chunk.path[-1]]
        if sentences:
            facets += [s for s in re.split(r"(?<=[.:;!?])\s+", chunk.text) if 25 <= len(s) <= 400]
        rows += [replace(whole, embedded=facet, lexical="") for facet in dict.fromkeys(facets)]
    return rows


def user_batch(location: str) -> Batch:
    """A file or address of the user's as rows; raises BadDocument."""
    if web.is_address(location):
        document, data = web.fetch(location)
    else:
        path = Path(location)
        document, data = read_file(path), path.read_bytes()
    return _batch(document, location, digest(data))


def _batch(document: Document, location: str, content: str) -> Batch:
    source = Source(source_id(location), location, document.title, "doc", "user", content)
    rows = document_rows(chunks(document.blocks, document.title), source)
    if not rows:
        raise BadDocument(f"{location} has no text under its headings.")
    return Batch(source, rows)


def locations(location: str) -> list[str]:
    """The files of a folder that can be indexed, or the location itself, absolute; raises BadDocument."""
    if web.is_address(location):
        return [location]
    path = Path(location).expanduser().absolute()
    if not path.is_dir():
        if path.exists() and path.suffix.lower() not in SUFFIXES and path.suffix:
            kinds = ", ".join(sorted(SUFFIXES))
            raise BadDocument(f"{path.name} is of no kind that can be indexed ({kinds}).")
        return [str(path)]
    found = []
    for folder, folders, names in os.walk(path):
        folders[:] = sorted(f for f in folders if not f.startswith((".", "__")))
        found += [
            str(Path(folder, n)) for n in sorted(names) if Path(n).suffix.lower() in SUFFIXES and not n.startswith(".")
        ]
    if not found:
        raise BadDocument(f"{path} has no PDF, HTML, Markdown, text or .scenic file in it.")
    if len(found) > MOST_FILES:
        raise BadDocument(f"{path} has {len(found)} files; up to {MOST_FILES} are added at once: add its parts.")
    return found
