"""Methods by name, behind one face: a text is interpreted to S, and S is written as a program.

reader (the learned reader), typed, mixed, prompted (C11 with repair; rendered where that fails),
chat2scenic:C1 ... chat2scenic:C12 (the paper's, without repair; with it: chat2scenic:C1+repair), chatscene,
nl2scenic:zero, nl2scenic:few (also nl2scenic), nl2scenic:cot.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from c2s_engine.config import WITHOUT_MODEL
from c2s_engine.interpret.llm.typed import Reading
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelNotSet
from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Progress
from c2s_engine.structure.regenerate import regenerate
from c2s_engine.write.baselines import ChatScene, NL2Scenic
from c2s_engine.write.baselines.nl2scenic import VARIANTS, Embed, Variant
from c2s_engine.write.mixed import MixedMethod
from c2s_engine.write.prompted import PromptedMethod
from c2s_engine.write.prompted.checking import Check, Fix
from c2s_engine.write.prompted.configuration import configuration, default
from c2s_engine.write.prompted.configuration import names as configurations
from c2s_engine.write.prompted.header import Ground
from c2s_engine.write.prompted.repair import Search
from c2s_engine.write.typed import TypedWriter
from c2s_engine.write.typed_method import Resolve, TypedMethod
from c2s_engine.write.whole import WholeOrRendered

OnEvent = Callable[[Progress], None]


class UnknownMethod(ValueError):
    """No method of that name; the message names those that there are."""


@dataclass(frozen=True)
class MethodTools:
    """What methods work with. `writer` is needed by those that render specs, and only when they write."""

    reader: Any
    client: OllamaClient | None = None
    search: Search | None = None
    embed: Embed | None = None
    check: Check | None = None
    fix: Fix | None = None
    resolve: Resolve | None = None
    writer: TypedWriter | None = None

    @property
    def ground(self) -> Ground:
        """The map that generated headers name: the writer's."""
        chosen = self.writer.map if self.writer else None
        return Ground(chosen.path.name, chosen.carla_map) if chosen else Ground()


class Method(Protocol):
    """A way from text to program."""

    name: str

    async def interpret(self, text: str, on_event: OnEvent | None = None) -> Reading: ...

    async def write(self, structure: Structure, on_event: OnEvent | None = None) -> Structure: ...


class ReaderMethod:
    """No model that has to be served: the learned reader."""

    name = "reader"

    def __init__(self, tools: MethodTools) -> None:
        self.tools = tools

    async def interpret(self, text: str, on_event: OnEvent | None = None) -> Reading:
        found = self.tools.reader(text)
        return Reading(structure=found.structure, notes=(found.note,) if found.note else ())

    async def write(self, structure: Structure, on_event: OnEvent | None = None) -> Structure:
        assert self.tools.writer is not None, "a method that renders specs needs its writer"
        return regenerate(structure, [], self.tools.writer)[0]


class _Plainly:
    """A method whose interpretation is an S, as a Method."""

    def __init__(self, inner: PromptedMethod | ChatScene | NL2Scenic, name: str) -> None:
        self.inner, self.name = inner, name

    async def interpret(self, text: str, on_event: OnEvent | None = None) -> Reading:
        return Reading(structure=await self.inner.interpret(text, on_event))

    async def write(self, structure: Structure, on_event: OnEvent | None = None) -> Structure:
        return await self.inner.write(structure, on_event)


def names() -> list[str]:
    """Every method's name."""
    prompted = [f"chat2scenic:{c}" for c in configurations()]
    return ["reader", "typed", "mixed", "prompted", *prompted, "chatscene",
            "nl2scenic:zero", "nl2scenic:few", "nl2scenic:cot"]  # fmt: skip


def needs_model(name: str) -> bool:
    """Whether a method cannot do without a model."""
    return name not in WITHOUT_MODEL


def retrieves(name: str) -> bool:
    """Whether a method looks for snippets or documentation."""
    kind, _, rest = name.partition(":")
    config, _, extra = rest.partition("+")
    if kind == "chat2scenic" and not extra:
        return any(configuration(config).has(block) for block in ("CodeICL", "DocICL"))
    return kind in ("prompted", "mixed", "chatscene", "chat2scenic") or kind == "nl2scenic" and rest != "zero"


def method(name: str, tools: MethodTools) -> Method:
    """The method of that name; raises UnknownMethod, or ModelNotSet where it needs a model and none is set."""
    kind, _, rest = name.partition(":")
    config, _, extra = rest.partition("+")
    known = name in names() or name == "nl2scenic" or (extra == "repair" and f"{kind}:{config}" in names())
    if not known:
        raise UnknownMethod(f"There is no method {name}; there are {', '.join(names())}.")
    client = tools.client if tools.client is not None and tools.client.settings.model else None
    if client is None and needs_model(name):
        raise ModelNotSet
    if kind == "reader":
        return ReaderMethod(tools)
    if kind == "chatscene":
        assert tools.search is not None, "chatscene needs a retriever"
        return _Plainly(ChatScene(client, tools.search, tools.reader, tools.ground), name)
    assert client is not None
    if kind == "typed":
        return TypedMethod(client, tools.reader, tools.resolve, tools.writer, tools.check)
    if kind == "nl2scenic":
        variant: Variant = next((v for v in VARIANTS if v == rest), "few")
        return _Plainly(NL2Scenic(client, tools.embed, variant, tools.ground, tools.check), name)
    repaired = kind in ("prompted", "mixed") or extra == "repair"
    prompted = PromptedMethod(
        config or default(), client, tools.search, tools.check if repaired else None,
        reader=tools.reader, fix=tools.fix, ground=tools.ground,
    )  # fmt: skip
    if kind == "prompted":
        return WholeOrRendered(prompted, tools.check, tools.writer)
    if kind == "mixed":
        return MixedMethod(
            TypedMethod(client, tools.reader, tools.resolve, tools.writer, tools.check), prompted, tools.check
        )
    return _Plainly(prompted, name)
