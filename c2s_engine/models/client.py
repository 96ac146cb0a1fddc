"""The client of Ollama's API: streams, can be cancelled, tries again where that helps, keeps the ledger.

The `ollama` package (and httpx under it) is imported at the first call: the front must be on the screen before that.
"""

import asyncio
import time
from collections.abc import AsyncIterator, Callable
from contextlib import suppress
from typing import Any
from urllib.parse import urlsplit

from c2s_engine import paths
from c2s_engine.models import faults
from c2s_engine.models.errors import (
    AnswerRepeats,
    AnswerTruncated,
    ContextOverflow,
    ModelCutOff,
    ModelError,
    ModelMissing,
    ModelNotFetched,
    ModelNotSet,
    NotRecorded,
)
from c2s_engine.models.ledger import Ledger, Row
from c2s_engine.models.messages import Piece, Question, Reply, approximate_tokens
from c2s_engine.models.recording import Recording
from c2s_engine.models.repetition import repeats
from c2s_engine.models.settings import ModelSettings
from c2s_engine.models.ways import CHAT, Way, begin, pieces
from c2s_engine.structure.progress import Token, Usage

OnEvent = Callable[[Token | Usage], None]
REPEATS = "repeats"
"""The reason of an answer's end where the client stopped a model that went round in circles."""
COUNTED = (ContextOverflow, AnswerRepeats, AnswerTruncated)
"""Faults of an answer that came: its cost is known and entered, and asking the same again gives the same."""
SURELY_TOO_LONG = 1.5
"""A prompt estimated at over so many times `num_ctx` is not sent at all."""


class OllamaClient:
    """One model at one host. Use it as an async context manager, or call `close`."""

    def __init__(self, settings: ModelSettings | None = None, ledger: Ledger | None = None) -> None:
        self.settings = settings or ModelSettings()
        self.ledger = ledger or Ledger()
        folder = self.settings.record_folder or paths.data_folder() / "answers"
        self.recording = Recording(folder) if self.settings.record != "off" else None
        self._client: Any = None
        self._capabilities: frozenset[str] | None = None
        self._largest: int | None = None  # the model's own largest context, tokens; None: not told
        self.keeps_to_forms: bool | None = None  # found by the probe; None: not tried out yet
        self.way: Way = self.settings.way or CHAT  # where the settings name none, set by the probe

    async def __aenter__(self) -> "OllamaClient":
        return self

    async def __aexit__(self, *exc: object) -> None:
        await self.close()

    async def close(self) -> None:
        """Close the connections."""
        if self._client is not None:
            client, self._client = self._client, None
            await client.close()

    @property
    def api(self) -> Any:
        """The `ollama.AsyncClient`, made at the first use."""
        if self._client is None:
            import httpx
            import ollama

            limits = httpx.Timeout(self.settings.timeout, connect=self.settings.connect_timeout)
            local = urlsplit(self.settings.host if "//" in self.settings.host else f"//{self.settings.host}").hostname
            proxied = local not in ("127.0.0.1", "localhost", "::1", "0.0.0.0")
            self._client = ollama.AsyncClient(host=self.settings.host, timeout=limits, trust_env=proxied)
        return self._client

    # What the host has

    async def models(self) -> list[dict[str, Any]]:
        """The models at the host: name, size (bytes), parameters, quantization."""
        with faults.translated(self.settings):
            answer = await self.api.list()
        return [
            {
                "name": m.model or "",
                "size": int(m.size or 0),
                "parameters": (m.details and m.details.parameter_size) or "",
                "quantization": (m.details and m.details.quantization_level) or "",
                "digest": m.digest or "",
            }
            for m in answer.models
        ]

    async def installed(self, model: str) -> dict[str, Any] | None:
        """The entry of `models` for a model, named with or without `:latest`; None where the host lacks it."""
        return next((m for m in await self.models() if m["name"] in (model, f"{model}:latest")), None)

    async def version(self) -> str:
        """The server's version; empty where it does not tell."""
        try:
            with faults.translated(self.settings):
                answer = await self.api._request_raw("GET", "/api/version")  # the package has no call of its own
                return str(answer.json().get("version", ""))
        except (ModelMissing, ModelNotSet):  # 404
            return ""

    async def pull(self, model: str) -> AsyncIterator[tuple[str, int, int]]:
        """Fetch a model; yields (what is done, bytes so far, bytes in all). Raises ModelError."""
        import ollama

        with faults.translated(self.settings, model):
            try:
                async for step in await self.api.pull(model, stream=True):
                    yield step.status or "", int(step.completed or 0), int(step.total or 0)
            except ollama.ResponseError as error:
                raise ModelNotFetched(model, self.settings.host, str(error.error)) from None

    async def capabilities(self) -> frozenset[str]:
        """What Ollama says the model can do ("completion", "thinking", ...); asked once."""
        if not self.settings.model:
            raise ModelNotSet
        if self._capabilities is None:
            with faults.translated(self.settings):
                shown = await self.api.show(self.settings.model)
            self._capabilities = frozenset(shown.capabilities or ())
            told = (v for k, v in (shown.modelinfo or {}).items() if k.endswith(".context_length"))
            self._largest = next((v for v in told if isinstance(v, int) and v > 0), None)
        return self._capabilities

    # Asking

    async def chat(self, question: Question, on_event: OnEvent | None = None) -> Reply:
        """The whole answer to a question; raises ModelError. To `on_event` go its pieces, and each try's cost."""
        reply, known = None, len(self.ledger.rows)
        try:
            async for piece in self.stream(question):
                if on_event and piece.text:
                    on_event(Token(text=piece.text, component=question.component, thinking=piece.thinking))
                reply = piece.reply or reply
        finally:
            for row in self.ledger.rows[known:]:
                if on_event:
                    on_event(row.usage())
        if reply is None:
            raise ModelCutOff(self.settings.model)
        return reply

    async def stream(self, question: Question) -> AsyncIterator[Piece]:
        """The answer's pieces; the last one carries the whole. Faults that may pass are tried again with back-off."""
        digest = question.digest(self.settings.model, self.options(question))
        if self.recording and self.settings.record == "replay":
            reply = self.recording.get(digest)
            if reply is None:
                raise NotRecorded(question.purpose, str(self.recording.folder))
            self._judged(question, reply, 1)
            yield Piece(text=reply.text, reply=reply)
            return
        if not self.settings.model:
            raise ModelNotSet
        if question.tokens > SURELY_TOO_LONG * self.settings.num_ctx:
            raise ContextOverflow(question.tokens, self.settings.num_ctx)
        for attempt in range(self.settings.retries + 1):
            if attempt:
                await asyncio.sleep(self.settings.backoff * 2 ** (attempt - 1))
                yield Piece(restarted=True)
            began = time.monotonic()
            try:
                async for piece in self._once(question):
                    if piece.reply:
                        self._judged(question, piece.reply, attempt + 1)
                    yield piece
                return
            except COUNTED:
                raise
            except ModelError as error:
                self._enter_fault(question, error, time.monotonic() - began, attempt + 1)
                if not error.retry or attempt == self.settings.retries:
                    raise

    def options(self, question: Question) -> dict[str, Any]:
        """The options of every call: `num_ctx` is always named and always the same."""
        return {
            "num_ctx": self.settings.num_ctx,
            "num_predict": question.answer_tokens or self.settings.answer_tokens,
            "temperature": self.settings.temperature,
            "seed": self.settings.seed,
        }

    async def _asked(self, question: Question) -> tuple[Way, dict[str, Any], dict[str, Any]]:
        """The way, the `think` argument (left out for models that cannot think: Ollama refuses it), the options."""
        way = self.way if question.schema_ else self.way.model_copy(update={"endpoint": "chat"})
        options = self.options(question)
        if "thinking" not in await self.capabilities():
            return way, {}, options
        if way.think:  # thoughts count as the answer's tokens
            options["num_predict"] += self.settings.thinking_tokens
        return way, {"think": way.think}, options

    async def _once(self, question: Question) -> AsyncIterator[Piece]:
        settings = self.settings
        way, think, options = await self._asked(question)
        began = time.monotonic()
        text, thinking, watched, last = "", "", 0, None
        with faults.translated(settings):
            stream = await begin(
                self.api, way, question.messages, think, model=settings.model, format=question.schema_,
                options=options, keep_alive=settings.keep_alive,
            )  # fmt: skip
            try:
                async for chunk in stream:
                    last = chunk
                    said, thought = pieces(chunk)
                    if thought:
                        thinking += thought
                        yield Piece(text=thought, thinking=True)
                    if said:
                        text += said
                        yield Piece(text=said)
                    if len(text) + len(thinking) - watched >= 256:
                        watched = len(text) + len(thinking)
                        if repeats(text or thinking):
                            break
            finally:
                with suppress(RuntimeError):
                    await stream.aclose()
        endless = repeats(text or thinking)
        if last is None or not (last.done or endless):
            raise ModelCutOff(settings.model)
        if question.schema_ and not text.strip():  # some models put the form where their thoughts belong
            text = thinking
        reply = Reply(
            text=text,
            thinking=thinking,
            prompt_tokens=last.prompt_eval_count or (question.tokens if endless else 0),
            answer_tokens=last.eval_count or (approximate_tokens(text + thinking) if endless else 0),
            seconds=time.monotonic() - began,
            done_reason=REPEATS if endless else last.done_reason or "stop",
        )
        if self.recording:
            digest = question.digest(settings.model, self.options(question))
            self.recording.put(digest, settings.model, question.purpose, reply)
        yield Piece(reply=reply)

    def _judged(self, question: Question, reply: Reply, tries: int) -> None:
        """Enter an answer with what it cost, then raise what is wrong with it. (A replay raises the same.)"""
        fault = self._fault(question, reply)
        self._enter(question, reply, tries, type(fault).__name__ if fault else "ok")
        if fault:
            raise fault

    def _fault(self, question: Question, reply: Reply) -> ModelError | None:
        """What is wrong where the prompt was cut to the context, or the answer came to no end."""
        num_ctx, own = self.settings.num_ctx, self._largest
        if own and own < num_ctx:  # Ollama gives a model no more than its own
            num_ctx = own
        if reply.prompt_tokens >= num_ctx - 1 or (
            question.tokens > num_ctx and 0 < reply.prompt_tokens < 0.8 * question.tokens
        ):
            return ContextOverflow(max(question.tokens, reply.prompt_tokens), num_ctx, largest=num_ctx == own)
        if reply.done_reason == REPEATS:
            return AnswerRepeats(self.settings.model)
        if reply.done_reason == "length":
            return AnswerTruncated(self.settings.model, reply.answer_tokens)
        return None

    def _enter(self, question: Question, reply: Reply, tries: int, outcome: str = "ok") -> None:
        self.ledger.add(
            Row(
                scenario=self.ledger.scenario,
                purpose=question.purpose,
                component=question.component,
                model=self.settings.model,
                prompt_tokens=reply.prompt_tokens,
                answer_tokens=reply.answer_tokens,
                seconds=reply.seconds,
                tries=tries,
                outcome=outcome,
            )
        )

    def _enter_fault(self, question: Question, error: ModelError, seconds: float, tries: int) -> None:
        """A failed try costs too: its tokens are estimated, since the model did not count them."""
        spent = Reply(text="", prompt_tokens=question.tokens, seconds=seconds)
        self._enter(question, spent, tries, type(error).__name__)
