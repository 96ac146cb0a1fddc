"""Fetching a document from an address."""

import urllib.error
import urllib.parse
import urllib.request
from pathlib import PurePosixPath

from c2s_engine.retrieve.errors import BadDocument
from c2s_engine.retrieve.readers import MEGABYTE, Document, read_bytes

TIMEOUT = 30.0  # s
LIMIT = 50 * MEGABYTE


def is_address(location: str) -> bool:
    """Whether a location is an address on the web."""
    return location.startswith(("http://", "https://"))


def fetch(address: str) -> tuple[Document, bytes]:
    """The document at an address, and its bytes; raises BadDocument."""
    request = urllib.request.Request(
        address, headers={"User-Agent": "c2s", "Accept": "text/html,application/pdf,text/*"}
    )
    try:
        with urllib.request.urlopen(request, timeout=TIMEOUT) as answer:
            kind = answer.headers.get_content_type()
            data = answer.read(LIMIT + 1)
    except urllib.error.HTTPError as error:
        raise BadDocument(f"{address} answered {error.code} ({error.reason}).") from None
    except (urllib.error.URLError, OSError, ValueError) as error:
        reason = getattr(error, "reason", error)
        raise BadDocument(
            f"{address} could not be reached ({reason}): is there a network? Save the page and add the file."
        ) from None
    if len(data) > LIMIT:
        raise BadDocument(f"{address} has more than {LIMIT // MEGABYTE} MB: save it and add the part that matters.")
    name = PurePosixPath(urllib.parse.urlparse(address).path).name or urllib.parse.urlparse(address).netloc
    suffix = {"text/html": ".html", "application/xhtml+xml": ".html", "application/pdf": ".pdf", "text/markdown": ".md",
              "text/plain": PurePosixPath(name).suffix.lower() or ".txt"}.get(kind)  # fmt: skip
    if suffix is None:
        raise BadDocument(f"{address} is {kind}: PDF, HTML, Markdown and text can be indexed.")
    return read_bytes(data, name, suffix), data
