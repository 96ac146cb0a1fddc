"""Files and addresses of the user to blocks: PDF, HTML, Markdown, text. Each bad input raises BadDocument."""

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from c2s_engine.retrieve.blocks import Block
from c2s_engine.retrieve.errors import BadDocument
from c2s_engine.retrieve.markdown import read_markdown, read_text

MEGABYTE = 1 << 20
LIMITS = {"html": 20, "text": 20, "pdf": 200}  # MB
MARKDOWN = {".md", ".markdown", ".mdown"}
HTML = {".html", ".htm", ".xhtml"}
TEXT = {".txt", ".rst", ".text", ".csv"}
SUFFIXES = MARKDOWN | HTML | TEXT | {".pdf", ".scenic"}


@dataclass(frozen=True)
class Document:
    """A document that was read: its title and blocks."""

    title: str
    blocks: list[Block]


def read_file(path: Path) -> Document:
    """The document in a file; raises BadDocument with a sentence."""
    try:
        size = path.stat().st_size
        if size == 0:
            raise BadDocument(f"{path.name} is empty.")
        data = path.read_bytes() if size <= LIMITS["pdf"] * MEGABYTE else b""
    except FileNotFoundError:
        raise BadDocument(f"There is no file {path}.") from None
    except OSError as error:
        raise BadDocument(f"{path} cannot be read ({error.strerror}).") from None
    if not data:
        raise BadDocument(f"{path.name} has {size // MEGABYTE} MB; files up to {LIMITS['pdf']} MB are read: split it.")
    return read_bytes(data, path.name, path.suffix.lower())


def read_bytes(data: bytes, name: str, suffix: str) -> Document:
    """The document that some bytes hold; `suffix` says of what kind they claim to be."""
    if data[:5] == b"%PDF-" or suffix == ".pdf":
        return read_pdf(data, name)
    kind = "html" if suffix in HTML else "text"
    if len(data) > LIMITS[kind] * MEGABYTE:
        raise BadDocument(
            f"{name} has {len(data) // MEGABYTE} MB; such a file is read up to {LIMITS[kind]} MB: "
            "split it, or add the part that matters."
        )
    text = decode(data, name)
    if suffix in HTML:
        return read_html(text, name)
    blocks = (
        read_markdown(text) if suffix in MARKDOWN else [Block("code", text)] if suffix == ".scenic" else read_text(text)
    )
    if not blocks:
        raise BadDocument(f"{name} has no text in it.")
    top = next((b.text for b in blocks if b.kind == "heading" and b.level == 1), "")
    if suffix in MARKDOWN and top:
        blocks = [b for b in blocks if not (b.kind == "heading" and b.level == 1 and b.text == top)]
        return Document(top, blocks)
    return Document(Path(name).stem, blocks)


def decode(data: bytes, name: str) -> str:
    """Bytes to text; raises BadDocument for what is no text."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return data.decode("utf-16", errors="replace")
    if b"\0" in data[:65536]:
        raise BadDocument(f"{name} is a binary file, not text: add a PDF, HTML, Markdown or text file.")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1252", errors="replace")
    strange = sum(1 for c in text[:20000] if c == "\ufffd" or (ord(c) < 32 and c not in "\t\r\n\f"))
    if strange > len(text[:20000]) * 0.01:
        raise BadDocument(f"{name} is a binary file, not text: add a PDF, HTML, Markdown or text file.")
    return text


def read_pdf(data: bytes, name: str) -> Document:
    """The text of a PDF by pages, without the lines that head or foot most of its pages."""
    import logging
    from io import BytesIO

    from pypdf import PdfReader

    logging.getLogger("pypdf").setLevel(logging.CRITICAL)
    try:
        reader = PdfReader(BytesIO(data))
        if reader.is_encrypted and not reader.decrypt(""):
            raise BadDocument(f"{name} is protected by a password: save it without one.")
        pages = [page.extract_text() or "" for page in reader.pages]
        title = str(reader.metadata.get("/Title") or "").strip() if reader.metadata else ""
    except BadDocument:
        raise
    except Exception as error:  # pypdf raises many kinds for damaged files
        reason = str(error).splitlines()[0][:80] if str(error) else type(error).__name__
        raise BadDocument(f"{name} is no PDF that can be read ({reason}).") from None
    if not pages:
        raise BadDocument(f"{name} has no pages.")
    if sum(len(p.strip()) for p in pages) < 10 * len(pages):
        raise BadDocument(
            f"{name} has {len(pages)} page{'s' if len(pages) > 1 else ''} but hardly any text on them (a scan?): "
            "run OCR over it first, for example with ocrmypdf."
        )
    furniture = _furniture(pages)
    blocks: list[Block] = []
    for number, page in enumerate(pages, 1):
        kept = "\n".join(line for line in page.splitlines() if _plain(line) not in furniture)
        blocks.extend(read_text(kept, number))
    return Document(title if len(title) > 3 else Path(name).stem, blocks)


_PAGE_NUMBER = re.compile(r"\W*(?:page|p\.|seite)?\W*\d+(?:\s*(?:of|/|von)\s*\d+)?\W*", re.I)


def _plain(line: str) -> str:
    """A line to compare over pages: page numbers count as the same, all else as it stands."""
    line = line.strip()
    return "#" if line and _PAGE_NUMBER.fullmatch(line) else line


def _furniture(pages: list[str]) -> set[str]:
    """Running heads and feet: first or last lines that stand on over half of the pages."""
    if len(pages) < 4:
        return set()
    seen: Counter[str] = Counter()
    for page in pages:
        lines = [_plain(line) for line in page.splitlines() if line.strip()]
        seen.update(set(lines[:2] + lines[-2:]))
    return {line for line, count in seen.items() if count > len(pages) / 2}


def read_html(text: str, name: str) -> Document:
    """The main text of an HTML page, without navigation, scripts and forms."""
    from bs4 import BeautifulSoup

    soup = BeautifulSoup(text, "html.parser")
    for tag in soup(["script", "style", "noscript", "nav", "header", "footer", "aside", "form", "template", "svg"]):
        tag.decompose()
    title = soup.title.get_text(" ", strip=True) if soup.title else ""
    root = soup.find("main") or soup.find("article") or soup.body or soup
    blocks: list[Block] = []
    taken: set[int] = set()
    loose: list[str] = []
    for tag in root.find_all(
        [
            "h1",
            "h2",
            "h3",
            "h4",
            "h5",
            "h6",
            "p",
            "ul",
            "ol",
            "table",
            "pre",
            "dl",
            "blockquote",
            "div",
            "section",
            "td",
            "li",
        ]
    ):
        if any(id(parent) in taken for parent in tag.parents):
            continue
        if tag.name in ("div", "section", "td", "li"):
            own = " ".join(s.strip() for s in tag.find_all(string=True, recursive=False) if s.strip())
            if own:
                blocks.append(Block("paragraph", own))
            continue
        taken.add(id(tag))
        if block := _html_block(tag):
            blocks.append(block)
    if not blocks:
        loose = [line.strip() for line in root.get_text("\n").splitlines() if line.strip()]
        blocks = [Block("paragraph", " ".join(loose))] if loose else []
    if not any(b.kind != "heading" for b in blocks):
        raise BadDocument(f"{name} has no text in it.")
    return Document(title or Path(name).stem, blocks)


def _html_block(tag) -> Block | None:
    if tag.name == "pre":
        return Block("code", tag.get_text().strip("\n")) if tag.get_text(strip=True) else None
    if tag.name in ("ul", "ol"):
        items = ["- " + re.sub(r"\s+", " ", li.get_text(" ", strip=True)) for li in tag.find_all("li", recursive=False)]
        return Block("list", "\n".join(items)) if items else None
    if tag.name == "table":
        rows = [
            "| "
            + " | ".join(re.sub(r"\s+", " ", c.get_text(" ", strip=True)) for c in row.find_all(["td", "th"]))
            + " |"
            for row in tag.find_all("tr")
        ]
        return Block("table", "\n".join(rows)) if rows else None
    text = re.sub(r"\s+", " ", tag.get_text(" ", strip=True))
    if not text:
        return None
    return Block("heading", text, int(tag.name[1])) if re.fullmatch(r"h[1-6]", tag.name) else Block("paragraph", text)
