"""One form filled in by a model: asked under a schema, mended, validated, and asked once more with the fault."""

import json
from collections.abc import Callable
from functools import cache
from importlib import resources
from string import Template
from typing import Any

from c2s_engine.interpret.llm.answers import json_object
from c2s_engine.interpret.llm.mend import mend
from c2s_engine.interpret.llm.schema import accepts
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import (
    AnswerTruncated,
    AnswerUnusable,
    BadSettings,
    ModelError,
    ModelMissing,
    ModelNotSet,
    ModelRefused,
    ModelTimeout,
    ModelUnavailable,
    NotRecorded,
)
from c2s_engine.models.messages import Message, Question
from c2s_engine.models.probe import keeps_to_forms
from c2s_engine.structure.progress import Progress

FATAL = (BadSettings, ModelUnavailable, ModelMissing, ModelNotSet, ModelRefused, ModelTimeout, NotRecorded)
"""Faults after which asking for the other components would only take time."""

OnEvent = Callable[[Progress], None]


@cache
def _template(name: str) -> Template:
    text = resources.files("c2s_engine.interpret.llm").joinpath("prompts", f"{name}.md").read_text(encoding="utf-8")
    return Template(text.strip())


def prompt(name: str, **values: str) -> str:
    """A prompt of prompts/, filled in."""
    return _template(name).substitute(values)


class Asker:
    """Asks one client; after a fatal fault it asks no more and raises that fault again."""

    def __init__(self, client: OllamaClient, on_event: OnEvent | None = None) -> None:
        self.client = client
        self.on_event = on_event
        self.fatal: ModelError | None = None

    async def form(
        self,
        system: str,
        user: str,
        schema: dict[str, Any],
        *,
        purpose: str,
        component: str | None = None,
        build: Callable[[dict[str, Any]], Any] = lambda value: value,
    ) -> Any:
        """What `build` makes of the answer; raises ModelError. `build` may raise ValueError with its reason."""
        if self.fatal:
            raise self.fatal
        if not await self._keeps_to_forms():
            told = json.dumps(schema, separators=(",", ":"))
            system = f"{system}\n\n{prompt('form', schema=told)}"
        messages = [Message(role="system", content=system), Message(role="user", content=user)]
        for last in (False, True):
            asked = Question(messages=tuple(messages), schema_=schema, purpose=purpose, component=component)
            text = ""
            try:
                text = (await self.client.chat(asked, self.on_event)).text
                return self._judge(text, schema, build)
            except FATAL as error:
                self.fatal = error
                raise
            except (AnswerUnusable, AnswerTruncated) as error:
                if last:
                    raise
                messages = messages[:2]
                if text.strip():
                    messages.append(Message(role="assistant", content=text[:800]))
                fault = str(error).removeprefix("The model's answer cannot be used: ").rstrip(".")
                messages.append(Message(role="user", content=prompt("again", fault=fault)))
                purpose = f"{purpose.removesuffix(' again')} again"
        raise AssertionError("unreachable")

    async def _keeps_to_forms(self) -> bool:
        """Whether `format` is enough; a model that does not keep to it is told the schema in its prompt as well."""
        try:
            return await keeps_to_forms(self.client)
        except FATAL as error:
            self.fatal = error
            raise
        except (ModelError, OSError):
            return True

    @staticmethod
    def _judge(text: str, schema: dict[str, Any], build: Callable[[dict[str, Any]], Any]) -> Any:
        value = mend(schema, json_object(text))
        if fault := accepts(schema, value):
            raise AnswerUnusable(fault)
        try:
            return build(value)
        except ValueError as error:
            raise AnswerUnusable(_first_line(error)) from None


def _first_line(error: ValueError) -> str:
    details = getattr(error, "errors", None)
    if details:
        first = details()[0]
        return f"{'.'.join(map(str, first['loc']))}: {first['msg']}"
    return str(error).splitlines()[0]
