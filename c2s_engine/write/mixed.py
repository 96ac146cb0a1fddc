"""The mixed method: typed first; what the forms could not say (`unmet`) is written by the prompted generators."""

from collections.abc import Callable

from c2s_engine.interpret.llm.asking import FATAL
from c2s_engine.interpret.llm.typed import Reading
from c2s_engine.models.errors import ModelError
from c2s_engine.structure import names
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Progress, Say
from c2s_engine.structure.regenerate import interface, key_of
from c2s_engine.write.prompted import PromptedMethod
from c2s_engine.write.prompted.checking import Check, first_error
from c2s_engine.write.typed_method import TypedMethod


class MixedMethod:
    """A generated fragment is kept only where it defines what others use and the whole program passes with it."""

    name = "mixed"

    def __init__(self, typed: TypedMethod, prompted: PromptedMethod, check: Check | None) -> None:
        self.typed, self.prompted, self.check = typed, prompted, check

    async def interpret(self, text: str, on_event: Callable[[Progress], None] | None = None) -> Reading:
        return await self.typed.interpret(text, on_event)

    async def write(self, structure: Structure, on_event: Callable[[Progress], None] | None = None) -> Structure:
        """The typed program, with generated fragments where something was unmet; raises ResolveError."""
        structure = await self.typed.write(structure, on_event)
        for component in structure.components:
            if not component.unmet or component.id == "G" or component.origin != "rendered":
                continue
            try:
                structure = await self._generated(structure, component, on_event)
            except ModelError as error:
                if on_event:
                    on_event(Say(text=f"{component.id} stays as rendered. {error}", severity="warning"))
                if isinstance(error, FATAL):
                    break
        return structure

    async def _generated(
        self, structure: Structure, rendered: Component, on_event: Callable[[Progress], None] | None
    ) -> Structure:
        wanted = "; ".join(u.text for u in rendered.unmet)
        defined = ", ".join(n for n in interface(rendered) if not n.startswith("param "))
        asked = f"{rendered.description} It must also say: {wanted}." + (f" Define {defined}." if defined else "")
        told = structure.with_component(rendered.model_copy(update={"description": asked}))
        changed = await self.prompted.write_component(told, rendered.id, on_event)
        written = changed[rendered.id].model_copy(update={"description": rendered.description})
        kept = structure.with_component(written)
        problem = await self._problem(kept, rendered, written)
        if problem:
            if on_event:
                on_event(Say(text=f"{rendered.id} stays as rendered: {problem}.", severity="warning"))
            return structure
        return self._up_to_date(kept.with_component(written.model_copy(update={"unmet": ()})))

    def _up_to_date(self, structure: Structure) -> Structure:
        """All of it as the typed writer's own: what others use is still there, so nothing needs to be rendered anew."""
        assert self.typed.writer is not None
        for component in structure.components:
            key = key_of(structure, component.id, self.typed.writer)
            structure = structure.with_component(component.model_copy(update={"key": key}))
        return structure

    async def _problem(self, structure: Structure, rendered: Component, written: Component) -> str:
        """Why a generated fragment cannot take the rendered one's place; empty where it can."""
        if not written.code:
            return "the model wrote no code"
        used = frozenset().union(*(names.uses(c.code) for c in structure.components if c.id != rendered.id))
        if missing := sorted(n for n in interface(rendered) if n in used and n not in interface(written)):
            return f"the generated code lacks {missing[0]}, which others use"
        if self.check is None:
            return ""
        program = assemble(structure)
        found = first_error(await self.check(program.text, program.spans, "sample"))
        return found.message if found else ""
