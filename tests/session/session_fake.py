"""An engine with the facade's face whose turns are told by their text."""

import asyncio

from hypothesis import HealthCheck, settings
from hypothesis.stateful import RuleBasedStateMachine, run_state_machine_as_test

from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, EditError, apply
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished, Say, StructureChanged
from c2s_engine.structure.specs import ObjectSpec


class FakeEngine:
    """`say` adds an object with the text as its name; "wait" in it waits until `go` is set, "fail" raises."""

    def __init__(self):
        self.go = asyncio.Event()
        self.waiting = asyncio.Event()
        self.stopped = 0

    async def without_effect(self, text, structure, before=None):
        return ()

    async def say(self, structure: Structure, text: str, **options):
        yield Say(text=f"heard {text}")
        if "wait" in text:
            try:
                self.waiting.set()
                await self.go.wait()
            except BaseException:
                self.stopped += 1
                raise
        if "fail" in text:
            raise RuntimeError("out of order")
        if "refuse" in text:
            details = {"turn": "edit", "unchanged": True}
            yield Finished(ok=True, structure=structure, program=assemble(structure), details=details)
            return
        edits = [] if text.endswith("?") else [AddObject(spec=ObjectSpec(name=text), description=text)]
        async for event in self.apply(structure, edits, **options):
            yield event

    async def apply(self, structure: Structure, edits, **options):
        for edit in edits:
            try:
                structure = apply(structure, edit)
            except EditError as error:
                yield Say(text=str(error), severity="error")
        for component in structure.components:
            if component.origin == "rendered" and not component.key:
                written = component.model_copy(
                    update={"key": "k", "code": f"## {component.id}: {component.description}"}
                )
                structure = structure.with_component(written)
        yield StructureChanged(structure=structure)
        yield Finished(ok=True, structure=structure, program=assemble(structure))


def run_machine(machine: type[RuleBasedStateMachine], examples: int, steps: int) -> None:
    """Random runs of a machine, the same ones each time."""
    run_state_machine_as_test(
        machine,
        settings=settings(
            max_examples=examples, stateful_step_count=steps, database=None, derandomize=True,
            suppress_health_check=list(HealthCheck),
        ),
    )  # fmt: skip
