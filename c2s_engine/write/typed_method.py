"""The typed method: a model fills forms, what contradicts itself falls back, the typed writer renders."""

from collections.abc import Awaitable, Callable
from typing import Any

from c2s_engine.interpret.llm import fallback
from c2s_engine.interpret.llm.typed import Reading, TypedReader
from c2s_engine.models.client import OllamaClient
from c2s_engine.structure.components import Assumption, ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.objects import distinct_names, in_order
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Progress, Say
from c2s_engine.structure.regenerate import regenerate
from c2s_engine.write import by_hand
from c2s_engine.write.prompted.checking import Check, first_error
from c2s_engine.write.typed import TypedWriter, contradiction

OnEvent = Callable[[Progress], None]
Resolve = Callable[[Structure], Awaitable[Diagnostic | None]]
"""Whether S can be written on a map at hand: what stands against it, or nothing."""


class TypedMethod:
    """`resolve` says whether S has a place on a map; without it only contradictions between specs are found.

    With `check`, what was written is sampled, and a component that no scene can be found with falls back too.
    """

    name = "typed"

    def __init__(
        self,
        client: OllamaClient,
        reader: Any,
        resolve: Resolve | None = None,
        writer: TypedWriter | None = None,
        check: Check | None = None,
    ) -> None:
        self.client, self.reader, self.writer, self.check = client, reader, writer, check
        self.resolve = resolve or _contradiction

    async def interpret(self, text: str, on_event: OnEvent | None = None) -> Reading:
        """What was read with the model, made to resolve: a component that stands against the others falls back."""
        reading = await TypedReader(self.client, self.reader, on_event).read(text)
        settled = await self.settle(reading)
        if on_event and settled is not reading:
            on_event(Say(text=settled.notes[-1], severity="warning"))
        return settled

    async def settle(self, reading: Reading) -> Reading:
        """The reading with the fewest further fallbacks under which it resolves; at worst the learned reader's."""
        stand_in = fallback.StandIn(self.reader, reading.structure.text)
        settled, problem = reading, await self.resolve(reading.structure)
        while problem is not None:
            changed = await self._one_less(settled, problem, stand_in)
            if changed is None:
                return _whole(settled, stand_in.structure, problem)
            settled, problem = changed
        return settled

    async def _one_less(
        self, reading: Reading, problem: Diagnostic, stand_in: fallback.StandIn
    ) -> tuple[Reading, Diagnostic | None] | None:
        """The reading with one component replaced so that this problem is gone; none where no single one does it."""
        best = None
        for cid in _suspects(reading, problem):
            structure = _replaced(reading.structure, cid, stand_in, problem.message)
            found = await self.resolve(structure)
            if found is not None and found.message == problem.message:
                continue
            fallbacks = {**reading.fallbacks, cid: problem.message}
            note = f"{cid}: read by the learned reader instead of the model. {problem.message}."
            changed = Reading(structure=structure, fallbacks=fallbacks, notes=(*reading.notes, note))
            if found is None:
                return changed, None
            best = best or (changed, found)
        return best

    async def write(self, structure: Structure, on_event: OnEvent | None = None) -> Structure:
        """Render what is out of date, beside code by hand offer what would be rendered; raises ResolveError."""
        assert self.writer is not None, "a method that renders specs needs its writer"
        return self.writer.decided(by_hand.with_offers(await self._sampling(structure, on_event), self.writer))

    async def _sampling(self, structure: Structure, on_event: OnEvent | None) -> Structure:
        assert self.writer is not None
        written = regenerate(structure, [], self.writer)[0]
        if self.check is None or not structure.text or structure.ego.code:
            return written
        stand_in = fallback.StandIn(self.reader, structure.text)
        tried: set[ComponentId] = set()
        while (problem := await self._unsampled(written)) is not None:
            marked = {c.id for c in written.components if any(a.field == "*" for a in c.assumed)}
            reading = Reading(structure=written, fallbacks=dict.fromkeys(marked | tried, ""))
            culprit = next(iter(_suspects(reading, problem)), None)
            if culprit is None or len(tried) >= TRIES:
                return self._written(_whole(reading, stand_in.structure, problem).structure, problem, "All", on_event)
            tried.add(culprit)
            changed = _replaced(written, culprit, stand_in, problem.message)
            if contradiction(changed) is None:
                written = self._written(changed, problem, culprit, on_event)
        return written

    def _written(self, structure: Structure, problem: Diagnostic, which: str, on_event: OnEvent | None) -> Structure:
        if on_event:
            text = f"{which}: read by the learned reader instead of the model. {problem.message}."
            on_event(Say(text=text, severity="warning"))
        assert self.writer is not None
        return regenerate(structure, [], self.writer)[0]

    async def _unsampled(self, structure: Structure) -> Diagnostic | None:
        """Why no scene of the program can be sampled; none where one can."""
        assert self.check is not None
        program = assemble(structure)
        return first_error(await self.check(program.text, program.spans, "sample"))


TRIES = 3
"""Components that fall back one by one because no scene is found, before the learned reader reads the whole text."""


async def _contradiction(structure: Structure) -> Diagnostic | None:
    error = contradiction(structure)
    return Diagnostic(stage="resolve", message=str(error), text=", ".join(error.fields)) if error else None


def _suspects(reading: Reading, problem: Diagnostic) -> list[ComponentId]:
    """The components that the model filled in, those that the problem names first."""
    structure = reading.structure
    fields = problem.text.split(", ") if problem.stage == "resolve" else [problem.component or ""]
    named = [f.split(".")[0] for f in fields]
    objects = [o.id for o in structure.objects]
    first = [c for n in named for c in (objects if n == "O" else [n]) if c in structure]
    rest = [*reversed(objects), "R", "E", "T"]
    return [c for c in dict.fromkeys([*first, *rest]) if c not in reading.fallbacks]


def _replaced(structure: Structure, cid: ComponentId, stand_in: fallback.StandIn, reason: str) -> Structure:
    spec = stand_in.spec_among(cid, structure)
    mark = Assumption(field="*", value="learned reader", reason=reason)
    component = structure[cid]
    changed = component.model_copy(update={"spec": spec, "assumed": (*component.assumed, mark)})
    return in_order(distinct_names(structure.with_component(changed)))


def _whole(reading: Reading, structure: Structure, problem: Diagnostic) -> Reading:
    reason = problem.message
    mark = Assumption(field="*", value="learned reader", reason=reason)
    for component in structure.components:
        structure = structure.with_component(component.model_copy(update={"assumed": (*component.assumed, mark)}))
    structure = structure.model_copy(update={"text": reading.structure.text})
    note = f"The whole text was read by the learned reader instead of the model. {reason}."
    return Reading(structure=structure, fallbacks=dict.fromkeys(structure.ids, reason), notes=(*reading.notes, note))
