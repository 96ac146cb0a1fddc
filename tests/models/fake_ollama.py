"""A scripted server that speaks Ollama's protocol over real HTTP, in a thread of its own: answers, streams, faults.

    with FakeOllama(lambda request: "Hello") as server:
        client = OllamaClient(ModelSettings(model="small", host=server.host))

Requests are held to the shape of the real API; what breaks it is answered 400 and kept in `violations`.
"""

import asyncio
import json
import threading
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import islice
from typing import Any, Literal

Fault = Literal["cut", "error", "broken_json", "no_done"]
CHAT_KEYS = {
    "model", "messages", "tools", "stream", "format", "options", "keep_alive", "think", "logprobs", "top_logprobs",
}  # fmt: skip
GENERATE_KEYS = CHAT_KEYS - {"messages", "tools"} | {"prompt", "system", "suffix", "template", "raw", "images"}
OPTION_KEYS = {
    "num_ctx", "num_predict", "temperature", "seed", "top_k", "top_p", "min_p", "stop", "repeat_penalty", "num_keep",
    "repeat_last_n", "presence_penalty", "frequency_penalty", "num_batch", "num_gpu", "main_gpu", "num_thread",
}  # fmt: skip
MESSAGE_KEYS = {"role", "content", "images", "thinking", "tool_calls", "tool_name"}


@dataclass
class Answer:
    """How one chat request is answered. `text` may be an endless iterator; `fault` strikes after `after` chunks."""

    text: str | Iterable[str] = ""
    thinking: str = ""
    chunk: int = 24
    status: int = 200
    error: str = ""
    fault: Fault | None = None
    after: int = 2
    done_reason: str = "stop"
    prompt_tokens: int | None = None
    hold: threading.Event | None = None  # after `after` chunks nothing more comes until it is set

    def chunks(self) -> Iterator[tuple[str, str]]:
        for i in range(0, len(self.thinking), self.chunk):
            yield "thinking", self.thinking[i : i + self.chunk]
        if isinstance(self.text, str):
            for i in range(0, len(self.text), self.chunk):
                yield "content", self.text[i : i + self.chunk]
        else:
            for piece in self.text:
                yield "content", piece


Respond = Callable[[dict[str, Any]], "Answer | str"]


@dataclass
class Installed:
    """A model that the server has."""

    name: str
    capabilities: tuple[str, ...] = ("completion",)
    size: int = 4_700_000_000
    digest: str = "845dbda0ea48"


def script(*answers: Answer | str) -> Respond:
    """Answers in turn; the last one is repeated."""
    rest = list(answers)

    def respond(request: dict[str, Any]) -> Answer | str:
        return rest.pop(0) if len(rest) > 1 else rest[0]

    return respond


@dataclass
class FakeOllama:
    """The server. `requests` are those of /api/chat and /api/generate in order, each with "endpoint" and `messages`;
    `disconnected` is set when a client goes in mid-stream."""

    respond: Respond = field(default=lambda request: "Hello.")
    models: list[Installed] = field(
        default_factory=lambda: [Installed("small"), Installed("thinker", ("completion", "thinking"))]
    )
    pullable: tuple[str, ...] = ("fresh",)
    version: str | None = "0.30.7"  # None: a server of before that path
    requests: list[dict[str, Any]] = field(default_factory=list)
    violations: list[str] = field(default_factory=list)
    sent: int = 0

    def __post_init__(self) -> None:
        self.streaming = threading.Event()
        self.disconnected = threading.Event()
        self._ready = threading.Event()
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self.port = 0

    @property
    def host(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def __enter__(self) -> "FakeOllama":
        self._thread.start()
        assert self._ready.wait(10)
        return self

    def __exit__(self, *exc: object) -> None:
        self._loop.call_soon_threadsafe(self._stop.set)
        self._thread.join(10)

    def _serve(self) -> None:
        asyncio.set_event_loop(self._loop)
        self._loop.run_until_complete(self._main())
        self._loop.close()

    async def _main(self) -> None:
        self._stop = asyncio.Event()
        tasks: set[asyncio.Task] = set()

        async def client(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            tasks.add(asyncio.current_task())
            try:
                await self._client(reader, writer)
            except (ConnectionError, asyncio.IncompleteReadError, asyncio.CancelledError):
                pass
            finally:
                writer.close()

        server = await asyncio.start_server(client, "127.0.0.1", 0)
        self.port = server.sockets[0].getsockname()[1]
        self._ready.set()
        await self._stop.wait()
        server.close()
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    async def _client(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        while line := await reader.readline():
            method, path, _ = line.decode().split(" ", 2)
            length = 0
            while (header := await reader.readline()) not in (b"\r\n", b""):
                name, _, value = header.decode().partition(":")
                if name.lower() == "content-length":
                    length = int(value)
            body = json.loads(await reader.readexactly(length)) if length else {}
            reply = Responder(reader, writer)
            handler = {
                ("GET", "/api/tags"): self._tags,
                ("GET", "/api/ps"): self._ps,
                ("GET", "/api/version"): self._version,
                ("POST", "/api/show"): self._show,
                ("POST", "/api/pull"): self._pull,
                ("POST", "/api/chat"): self._chat,
                ("POST", "/api/generate"): self._generate,
            }.get((method, path))
            if handler is None:
                await reply.json({"error": f"no such path {path}"}, 404)
            elif not await handler(body, reply):
                return

    def _find(self, name: str) -> Installed | None:
        return next((m for m in self.models if m.name in (name, f"{name}:latest")), None)

    async def _tags(self, body: dict, reply: "Responder") -> bool:
        details = {"family": "toy", "parameter_size": "7B", "quantization_level": "Q4_K_M", "format": "gguf"}
        rows = [
            {"name": m.name, "model": m.name, "size": m.size, "digest": m.digest, "details": details}
            for m in self.models
        ]
        return await reply.json({"models": rows})

    async def _ps(self, body: dict, reply: "Responder") -> bool:
        used = self.requests[-1:] or []
        rows = [{"name": r["model"], "model": r["model"], "context_length": r["options"]["num_ctx"]} for r in used]
        return await reply.json({"models": rows})

    async def _version(self, body: dict, reply: "Responder") -> bool:
        if self.version is None:
            return await reply.json({"error": "no such path"}, 404)
        return await reply.json({"version": self.version})

    async def _show(self, body: dict, reply: "Responder") -> bool:
        model = self._find(body.get("model", ""))
        if model is None:
            return await reply.json({"error": f"model '{body.get('model')}' not found"}, 404)
        return await reply.json({"capabilities": list(model.capabilities), "model_info": {}, "details": {}})

    async def _pull(self, body: dict, reply: "Responder") -> bool:
        name = body.get("model", "")
        if name not in self.pullable:
            await reply.begin()
            await reply.line({"status": "pulling manifest"})
            await reply.line({"error": "pull model manifest: file does not exist"})
            return await reply.end()
        await reply.begin()
        await reply.line({"status": "pulling manifest"})
        for done in (0, 500, 1000):
            await reply.line(
                {"status": "pulling 845dbda0ea48", "digest": "sha256:845dbda0ea48", "completed": done, "total": 1000}
            )
        await reply.line({"status": "success"})
        self.models.append(Installed(name))
        return await reply.end()

    async def _generate(self, body: dict, reply: "Responder") -> bool:
        """As _chat, for one prompt; the pieces are told in `response` and `thinking`."""
        if unknown := set(body) - GENERATE_KEYS:
            self.violations.append(f"unknown fields {sorted(unknown)}")
            return await reply.json({"error": self.violations[-1]}, 400)
        told = [("system", body.get("system")), ("user", body.get("prompt"))]
        messages = [{"role": role, "content": content} for role, content in told if content]
        rest = {k: v for k, v in body.items() if k in CHAT_KEYS}
        return await self._chat({**rest, "messages": messages}, reply, "generate")

    async def _chat(self, body: dict, reply: "Responder", endpoint: str = "chat") -> bool:
        wrong = shape_of(body)
        model = self._find(body.get("model", ""))
        if wrong:
            self.violations.append(wrong)
            return await reply.json({"error": wrong}, 400)
        if model is None:
            return await reply.json({"error": f"model '{body['model']}' not found"}, 404)
        if body.get("think") and "thinking" not in model.capabilities:
            self.violations.append("think for a model that cannot")
            return await reply.json({"error": f'"{body["model"]}" does not support thinking'}, 400)
        body = {**body, "endpoint": endpoint}
        self.requests.append(body)
        answer = self.respond(body)
        if isinstance(answer, str):
            answer = Answer(answer)
        if answer.status != 200:
            return await reply.json({"error": answer.error or "refused"}, answer.status)
        return await self._stream(body, answer, reply)

    async def _stream(self, body: dict, answer: Answer, reply: "Responder") -> bool:
        frame = {"model": body["model"], "created_at": "2025-01-01T00:00:00Z"}
        room = body["options"].get("num_predict", -1)
        pieces = answer.chunks()
        if room > 0:  # four characters a token
            pieces = _within(pieces, 4 * room)
        written, reason = 0, answer.done_reason
        await reply.begin()
        gone = asyncio.ensure_future(reply.gone())
        try:
            for count, (kind, text) in enumerate(pieces):
                if count == answer.after:
                    if answer.hold:
                        self.streaming.set()
                        waiting = asyncio.ensure_future(asyncio.to_thread(answer.hold.wait, 10))
                        await asyncio.wait({waiting, gone}, return_when=asyncio.FIRST_COMPLETED)
                        answer.hold.set() if gone.done() else None
                        await waiting
                    if answer.fault:
                        return await self._fail(answer.fault, reply)
                if gone.done():
                    self.disconnected.set()
                    return False
                if kind == "cut":
                    reason = "length"
                    continue
                written += len(text)
                await reply.line({**frame, **_piece(body, kind, text), "done": False})
                self.sent += 1
            if answer.fault:
                return await self._fail(answer.fault, reply)
            count = answer.prompt_tokens
            if count is None:
                count = min(sum(len(m["content"]) for m in body["messages"]) // 4, body["options"]["num_ctx"])
            await reply.line(
                {**frame, **_piece(body, "content", ""), "done": True, "done_reason": reason,
                 "prompt_eval_count": count, "eval_count": max(1, written // 4), "total_duration": 1}
            )  # fmt: skip
            gone.cancel()
            return await reply.end()
        finally:
            if gone.done() and not gone.cancelled():
                self.disconnected.set()
            gone.cancel()

    async def _fail(self, fault: Fault, reply: "Responder") -> bool:
        if fault == "error":
            await reply.line({"error": "llama runner process has terminated"})
            return await reply.end()
        if fault == "broken_json":
            await reply.raw(b'{"model": "small", "mess\n')
            return await reply.end()
        if fault == "no_done":
            return await reply.end()
        return False  # "cut": the socket is closed without an end


def _piece(body: dict[str, Any], kind: str, text: str) -> dict[str, Any]:
    """A piece as the endpoint tells it; `kind`: content or thinking."""
    if body["endpoint"] == "chat":
        return {"message": {"role": "assistant", "content": "", kind: text}}
    return {"response": "", ("response" if kind == "content" else kind): text}


def _within(pieces: Iterator[tuple[str, str]], room: int) -> Iterator[tuple[str, str]]:
    for kind, text in pieces:
        if room <= 0:
            yield "cut", ""
            return
        yield kind, text[:room]
        room -= len(text)
        if room < 0:
            yield "cut", ""
            return


def shape_of(body: dict[str, Any]) -> str:
    """What is wrong with a chat request by the real API's shape; empty where nothing is."""
    if unknown := set(body) - CHAT_KEYS:
        return f"unknown fields {sorted(unknown)}"
    options = body.get("options")
    if not isinstance(options, dict) or "num_ctx" not in options:
        return "num_ctx is not set"
    if unknown := set(options) - OPTION_KEYS:
        return f"unknown options {sorted(unknown)}"
    messages = body.get("messages")
    if not isinstance(messages, list) or not messages:
        return "messages must be a list"
    for message in messages:
        if set(message) - MESSAGE_KEYS or message.get("role") not in ("system", "user", "assistant", "tool"):
            return f"bad message {message}"
        if not isinstance(message.get("content"), str):
            return "content must be a string"
    schema = body.get("format")
    if schema is not None and schema != "json" and not (isinstance(schema, dict) and "type" in schema):
        return "format must be 'json' or a schema with a type"
    if body.get("think") not in (None, True, False, "low", "medium", "high"):
        return "think must be a boolean or a level"
    return ""


class Responder:
    """Writes one HTTP/1.1 response."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.reader, self.writer = reader, writer

    async def json(self, value: Any, status: int = 200) -> bool:
        body = json.dumps(value).encode()
        head = f"HTTP/1.1 {status} X\r\nContent-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n"
        self.writer.write(head.encode() + body)
        await self.writer.drain()
        return True

    async def begin(self) -> None:
        self.writer.write(
            b"HTTP/1.1 200 OK\r\nContent-Type: application/x-ndjson\r\nConnection: close\r\n"
            b"Transfer-Encoding: chunked\r\n\r\n"
        )
        await self.writer.drain()

    async def raw(self, data: bytes) -> None:
        self.writer.write(f"{len(data):x}\r\n".encode() + data + b"\r\n")
        await self.writer.drain()

    async def line(self, value: Any) -> None:
        await self.raw(json.dumps(value).encode() + b"\n")

    async def end(self) -> bool:
        self.writer.write(b"0\r\n\r\n")
        await self.writer.drain()
        return False

    async def gone(self) -> None:
        """Returns when the client has closed its side (streams are the last answer on their connection)."""
        await self.reader.read()


def said(request: dict[str, Any]) -> str:
    """All that a request's messages say, for a script to look at."""
    return "\n".join(m["content"] for m in request["messages"])


def endless(piece: str) -> Iterator[str]:
    """The same piece for ever (bounded far beyond what any client should read)."""
    return islice(iter(lambda: piece, None), 2_000_000)
