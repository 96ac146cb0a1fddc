"""One GGUF model in llama.cpp (the package xllamacpp), asked over the HTTP server that it brings, on a private port."""

import hashlib
import http.client
import json
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

CACHE = 512
"""Memory for prompts that were seen before, MiB (llama.cpp's own default, 8192, is much for a small machine)."""


class Refused(Exception):
    """The request cannot be carried out; `status` is HTTP's."""

    def __init__(self, status: int, reason: str) -> None:
        super().__init__(reason)
        self.status = status


class Llama:
    """The model. `context`: its largest context, tokens; `threads` of the processor. It gives one answer at a time."""

    def __init__(self, gguf: Path, context: int, threads: int) -> None:
        import xllamacpp

        params = xllamacpp.CommonParams()
        params.model.path = str(gguf)
        params.n_ctx, params.n_parallel, params.verbosity = context, 1, 0
        params.cpuparams.n_threads = params.cpuparams_batch.n_threads = threads
        params.port, params.hostnames = 0, ["127.0.0.1"]
        params.cache_ram_mib = CACHE
        self.context = context
        self._grammar = xllamacpp.json_schema_to_grammar
        self._server = xllamacpp.Server(params)  # listens as long as it is kept
        self._address = urlsplit(self._server.listening_address)
        about = self._ask("GET", "/v1/models")["data"][0].get("meta") or {}
        self.parameters, self.size = int(about.get("n_params") or 0), gguf.stat().st_size
        self.quantization = str(self._ask("GET", "/props").get("model_ftype", ""))
        with gguf.open("rb") as file:
            self.digest = hashlib.file_digest(file, "sha256").hexdigest()

    def tokens(self, messages: list[dict[str, Any]]) -> list[int]:
        """The prompt of messages, by the model's own template."""
        prompt = self._ask("POST", "/apply-template", {"messages": messages})["prompt"]
        asked = {"content": prompt, "add_special": True, "parse_special": True}
        return self._ask("POST", "/tokenize", asked)["tokens"]

    def grammar(self, schema: Any) -> str:
        """llama.cpp's grammar for a JSON schema (for "json": any object)."""
        try:
            return self._grammar({"type": "object"} if schema == "json" else schema)
        except (RuntimeError, ValueError) as error:
            raise Refused(500, f"invalid JSON schema in format: {error}") from None

    def complete(
        self, tokens: list[int], options: dict[str, Any], gone: Callable[[], bool]
    ) -> Iterator[dict[str, Any]]:
        """llama.cpp's pieces of an answer, the last one with its counts. Stops within a moment once `gone`."""
        body = {**options, "prompt": tokens, "stream": True, "cache_prompt": True}
        connection = http.client.HTTPConnection(self._address.hostname or "", self._address.port)
        over = threading.Event()

        def watch() -> None:
            while not over.wait(0.05):
                if gone():
                    with suppress(OSError, AttributeError):
                        connection.sock.shutdown(socket.SHUT_RDWR)
                    return

        try:
            connection.request("POST", "/completion", json.dumps(body), {"Content-Type": "application/json"})
            threading.Thread(target=watch, daemon=True).start()
            answer = connection.getresponse()
            if answer.status != 200:
                raise Refused(500, _reason(answer.read()))
            for line in answer:
                if line.startswith(b"error:"):
                    raise Refused(500, _reason(line[6:]))
                if line.startswith(b"data:"):
                    yield json.loads(line[5:])
        finally:
            over.set()
            connection.close()

    def _ask(self, verb: str, path: str, body: Any = None) -> Any:
        connection = http.client.HTTPConnection(self._address.hostname or "", self._address.port)
        try:
            connection.request(verb, path, body and json.dumps(body), {"Content-Type": "application/json"})
            answer = connection.getresponse()
            data = answer.read()
            if answer.status != 200:
                raise Refused(500, _reason(data))
            return json.loads(data)
        finally:
            connection.close()


def _reason(data: bytes) -> str:
    try:
        found = json.loads(data)
        return str((found.get("error") or found).get("message", found))
    except (ValueError, AttributeError):
        return data.decode(errors="replace")[:300]
