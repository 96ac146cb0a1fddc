"""What methods with a model or a retriever work with: the engine's check server, maps, retrieval worker and Ollama."""

from collections.abc import Callable, Sequence
from typing import Any

from c2s_engine.check.protocol import CheckReport, CheckRequest, Limits, Upto
from c2s_engine.config import Settings
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.settings import settings_for
from c2s_engine.session.places import resolve
from c2s_engine.session.steps import Emit, Tools
from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.program import FragmentSpan
from c2s_engine.structure.progress import Passage, Say
from c2s_engine.write.methods import MethodTools
from c2s_engine.write.typed import TypedWriter

FRAGMENT_LIMITS = Limits(wall=30.0, cpu=30.0, sample_seconds=10.0)
"""Of the checks of what a model wrote: many a round, and what has no scene in 10 s goes back to it anyway."""


def client_for(settings: Settings) -> OllamaClient:
    """A client for the settings' model; raises BadSettings."""
    return OllamaClient(settings_for(settings.model or "", settings.ollama))


def method_tools(
    tools: Tools, client: OllamaClient, emit: Emit, writer: TypedWriter | None = None, folder: str | None = None
) -> MethodTools:
    """The tools of `write.methods`; without a folder (of the map) nothing is checked."""
    from c2s_engine.check.fixes import apply_fixes
    from c2s_engine.interpret.learned import learned

    async def check(program: str, spans: Sequence[FragmentSpan], upto: Upto) -> CheckReport:
        return await tools.check.check(
            CheckRequest(
                program=program, spans=tuple(spans), upto=upto, folder=folder, allow=tools.settings.allow,
                limits=FRAGMENT_LIMITS,
            )
        )  # fmt: skip

    async def places(structure: Structure) -> Diagnostic | None:
        return (await resolve(structure, tools.library, tools.check, default=tools.settings.map)).diagnostic

    async def search(query: str, **how: Any) -> list[Passage]:
        return await (await ready(tools, emit)).search(query, **how)

    async def embed(texts: Sequence[str]) -> list[list[float]]:
        return await (await ready(tools, emit)).embed(list(texts))

    return MethodTools(
        reader=learned, client=client, search=search, embed=embed,
        check=check if folder else None, fix=apply_fixes, resolve=places, writer=writer,
    )  # fmt: skip


async def ready(tools: Tools, emit: Emit) -> Any:
    """The retrieval client with its index at hand; where it must be built first, that is said."""
    client = await tools.extra["retrieval"]()
    await client.ready(_told(emit))
    return client


def _told(emit: Emit) -> Callable[[str, int, int], None]:
    """A listener to the index's building that says when it begins and when half of it is done."""
    said: set[str] = set()

    def on_progress(stage: str, done: int, total: int) -> None:
        if stage == "reading" and "begun" not in said:
            said.add("begun")
            emit(Say(text="The search index is being built; that is done once."))
        if stage == "embedding" and 2 * done >= total > 0 and "half" not in said:
            said.add("half")
            emit(Say(text="Half of the search index is built."))

    return on_progress
