"""The retrieval worker: `python -m c2s_engine.retrieve.worker FOLDER [MODEL]`. JSON lines on stdin and stdout.

A request is `{"id", "method", "params"}`; answers are `{"id", "begun"}`, `{"id", "progress": [stage, done, total]}`
and, last, `{"id", "result"}` or `{"id", "error", "kind"}`. `{"cancel": id}` stops a writing request. The end of stdin
ends the worker.
"""

import json
import os
import sys
import threading
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

WRITING = {"build", "add", "add_snippets", "remove"}


class _Cancelled(Exception):
    pass


class Worker:
    """Serves a library: searches in one lane, writing calls in another, so that a build does not hold up a search."""

    def __init__(self, folder: Path, model: str | None, out: Any):
        self._folder, self._model, self._out = folder, model, out
        self._library: Any = None
        self._making = threading.Lock()
        self._sending = threading.Lock()
        self._cancelled: set[int] = set()
        self._lanes = {name: ThreadPoolExecutor(1, thread_name_prefix=name) for name in ("read", "write")}

    @property
    def library(self) -> Any:
        """The library, made (and its packages imported) with the first request."""
        with self._making:
            if self._library is None:
                from c2s_engine.retrieve.library import Library, default_threads

                self._library = Library(self._folder, self._model, default_threads())
            return self._library

    def send(self, message: dict) -> None:
        """Write one message."""
        data = (json.dumps(message, ensure_ascii=False) + "\n").encode()
        with self._sending:
            self._out.write(data)
            self._out.flush()

    def serve(self, lines: Any) -> None:
        """Take requests until the input ends; then the process ends, whatever is being done."""
        for line in lines:
            try:
                message = json.loads(line)
            except ValueError:
                continue
            if "cancel" in message:
                self._cancelled.add(message["cancel"])
                continue
            lane = "write" if message.get("method") in WRITING else "read"
            self._lanes[lane].submit(self._handle, message)
        os._exit(0)

    def _handle(self, message: dict) -> None:
        from c2s_engine.retrieve.errors import RetrievalError

        id: Any = message.get("id")
        try:
            if id in self._cancelled:
                raise _Cancelled
            self.send({"id": id, "begun": True})
            self.send({"id": id, "result": self._call(id, message["method"], message.get("params") or {})})
        except RetrievalError as error:
            self.send({"id": id, "error": str(error), "kind": type(error).__name__})
        except _Cancelled:
            self.send({"id": id, "error": "cancelled", "kind": "Cancelled"})
        except MemoryError:
            self.send({"id": id, "error": "There was not enough memory for this.", "kind": "RetrievalError"})
        except BaseException as error:  # the worker lives on; the front gets a sentence, the log the traceback
            traceback.print_exc()
            self.send({"id": id, "error": f"{type(error).__name__}: {error}", "kind": "RetrievalError"})
        finally:
            self._cancelled.discard(id)

    def _call(self, id: int, method: str, params: dict) -> Any:
        def progress(stage: str, done: int, total: int) -> None:
            if id in self._cancelled:
                raise _Cancelled
            self.send({"id": id, "progress": [stage, done, total]})

        library = self.library
        if method == "search":
            library.opened(progress)
            return [p.model_dump() for p in library.search(**params)]
        if method == "embed":
            return library.embed(params["texts"]).tolist()
        if method == "warm":
            library.embedder.load()
            library.opened(progress)
            return True
        if method in WRITING - {"remove"}:
            return getattr(library, method)(**params, progress=progress)
        if method == "list":
            return library.contents()
        if method in ("remove", "verify"):
            return getattr(library, method)(**params)
        from c2s_engine.retrieve.errors import RetrievalError

        raise RetrievalError(f"The retrieval worker knows no {method!r}.")


def main() -> None:
    """Serve on stdin and stdout; what libraries print goes to stderr."""
    out = os.fdopen(os.dup(1), "wb", buffering=0)
    os.dup2(2, 1)
    os.environ.setdefault("LANCE_LOG", "error")
    os.environ.setdefault("RUST_LOG", "error")
    os.environ.setdefault("TOKENIZERS_PARALLELISM", "false")
    os.environ.setdefault("HF_HUB_OFFLINE", "1")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one product a query: a second thread would be waited for
    folder = Path(sys.argv[1])
    Worker(folder, sys.argv[2] if len(sys.argv) > 2 and sys.argv[2] else None, out).serve(sys.stdin.buffer)


if __name__ == "__main__":
    main()
