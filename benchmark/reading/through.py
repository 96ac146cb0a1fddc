"""What S by hand requires, judged on the run of what was read of the text: how much of it survives the reading."""

from itertools import count

from c2s_bench.reading.agreement import matching
from c2s_engine.api import Engine
from c2s_engine.interpret.llm.fallback import renumbered
from c2s_engine.report.gather import TextRecord, of_text
from c2s_engine.require import evaluate, require
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.requirements import Result
from c2s_engine.structure.specs import AnySpec, ObjectSpec


def in_the_terms_of(there: Structure, read: Structure) -> Structure:
    """S by hand with the ids and names of the objects as read; those that were not read have ids of nobody."""
    free = count(len(read.objects) + len(there.objects) + 1)
    match = matching(read, there)
    ids = {own: other or f"O{next(free)}" for own, other in match.items()}

    def told(component: Component) -> Component:
        spec: AnySpec = renumbered(component.spec, {"ego": "ego", **ids})
        other = match.get(component.id)
        if isinstance(spec, ObjectSpec):
            of = read[other].spec if other is not None else None
            spec = spec.model_copy(update={"name": of.name if isinstance(of, ObjectSpec) else f"no_{spec.name}"})
        return component.model_copy(update={"id": ids.get(component.id, component.id), "spec": spec})

    parts = {name: told(getattr(there, name)) for name in ("settings", "place", "ego", "restrictions")}
    return there.model_copy(update={**parts, "objects": tuple(map(told, there.objects))})


async def seen(engine: Engine, name: str, read: Structure, there: Structure) -> tuple[Result, ...]:
    """What S by hand requires, as the run of S as read shows it; nothing where that does not run. What needs a second
    run without ego's reaction is not judged."""
    material = await of_text(engine, TextRecord(name, read.text or there.text, "", read))
    if material.facts is None or material.ways is None:
        return ()
    results = evaluate(require(in_the_terms_of(there, read)), material.facts, material.ways)
    return tuple(r for r in results if r.holds is not None or "switched off" not in r.why)
