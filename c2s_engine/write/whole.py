"""The prompted method so that it ends in a program: where the whole does not pass, S's fields are rendered instead."""

from collections.abc import Callable

from c2s_engine.interpret.llm.typed import Reading
from c2s_engine.structure.components import Assumption, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Progress, Say
from c2s_engine.structure.regenerate import regenerate
from c2s_engine.write.prompted import PromptedMethod
from c2s_engine.write.prompted.checking import Check, first_error
from c2s_engine.write.prompted.influence import rests_on
from c2s_engine.write.typed import TypedWriter

OnEvent = Callable[[Progress], None]


class WholeOrRendered:
    """`check` and `writer` are needed to write; without them what the model wrote stands as it is."""

    name = "prompted"

    def __init__(self, prompted: PromptedMethod, check: Check | None, writer: TypedWriter | None) -> None:
        self.prompted, self.check, self.writer = prompted, check, writer

    async def interpret(self, text: str, on_event: OnEvent | None = None) -> Reading:
        return Reading(structure=await self.prompted.interpret(text, on_event))

    async def write(self, structure: Structure, on_event: OnEvent | None = None) -> Structure:
        """The model's program; else the rendered one, marked in `assumed`; where neither passes, the model's."""
        written = await self.prompted.write(structure, on_event)
        if self.check is None or self.writer is None or written == structure:
            return written
        problem = await self._problem(written)
        if problem is None:
            return written
        try:
            rendered = regenerate(_cleared(written, problem.message), [], self.writer)[0]
        except ValueError:  # the fields contradict each other
            return written
        if await self._problem(rendered) is not None:
            return written
        if on_event:
            text = (
                f"The model's program does not pass ({problem.message}): it was rendered from the fields of S instead."
            )
            on_event(Say(text=text, severity="warning"))
        return rendered

    async def _problem(self, structure: Structure) -> Diagnostic | None:
        """What stands against the assembled program; none where it samples."""
        assert self.check is not None
        program = assemble(structure)
        return first_error(await self.check(program.text, program.spans, "sample"))


def _cleared(structure: Structure, reason: str) -> Structure:
    """The structure with what the model wrote given to the typed writer."""
    mark = Assumption(field="*", value="rendered from its fields", reason=reason)
    for component in structure.components:
        if component.origin in ("generated", "rendered"):
            cleared = {
                "code": "", "key": "", "origin": "rendered", "assumed": (*component.assumed, mark),
                "links": rests_on(component, ()),
            }  # fmt: skip
            structure = structure.with_component(component.model_copy(update=cleared))
    return structure
