"""The same scene with other drivers in ego's place: whether what S says of the others happens for them, too."""

import re

from pydantic import BaseModel, ConfigDict

from c2s_engine.require import evaluate, require
from c2s_engine.require.conflict import unaware
from c2s_engine.session import steps
from c2s_engine.session.places import map_choice
from c2s_engine.session.requiring import runs_of
from c2s_engine.session.steps import Tools
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.program import assemble
from c2s_engine.structure.requirements import Requirement
from c2s_engine.write.typed import TypedWriter

SLOWER = 0.8
"""Of the speeds at which ego is to drive."""
OF_OTHERS = ("start", "phase", "order", "place")
"""Kinds of requirements that are about what the others do."""


class OtherDriver(BaseModel):
    """How a scene went with another driver: how many of the requirements about the others were seen, and which not."""

    model_config = ConfigDict(frozen=True)

    name: str
    required: int
    missed: tuple[str, ...] = ()
    problem: str = ""


async def with_other_drivers(structure: Structure, tools: Tools, *, map_name: str, room: float = 1.0,
                             seed: int = 0) -> tuple[OtherDriver, ...]:  # fmt: skip
    """One that never reacts, and one that is slower; nothing where ego's code is not written from S.

    The others start and drive by the same code as with ego; so where they are timed to ego, they are timed to the ego
    of S and not to who drives in its place.
    """
    if structure.ego.origin != "rendered":
        return ()
    chosen = map_choice(tools.library, tools.library.find(map_name))
    writer = TypedWriter(chosen, room=room)
    blind = writer.write(unaware(structure), "E")
    drivers = {"never reacts": blind, "20 % slower": slower(structure.ego)}
    asked, found = require(structure), []
    concerned = {r.id: r.text for r in asked if _concerns_others(r)}
    for name, ego in drivers.items():
        program = assemble(structure.with_component(ego))
        report = await steps.check(program, tools, steps.silent, folder=str(chosen.path.parent), upto="run", seed=seed,
                                   runs=1, trajectories=True)  # fmt: skip
        ran = runs_of(report)
        if not ran or not ran[0].facts.objects:
            found.append(OtherDriver(name=name, required=len(concerned), problem="it did not run"))
            continue
        results = evaluate(asked, ran[0].facts, ran[0].trajectories)
        missed = tuple(concerned[r.requirement] for r in results if r.requirement in concerned and not r.holds)
        found.append(OtherDriver(name=name, required=len(concerned), missed=missed))
    return tuple(found)


def slower(ego: Component) -> Component:
    """Ego's fragment with a driver of its behaviours who keeps to `SLOWER` of its speed; the constant stays."""
    lines = [
        line if line.startswith(("EGO_SPEED", "#")) else re.sub(r"\bEGO_SPEED\b", f"({SLOWER:g} * EGO_SPEED)", line)
        for line in ego.code.splitlines(keepends=True)
    ]
    return ego.model_copy(update={"code": "".join(lines)})


def _concerns_others(requirement: Requirement) -> bool:
    return requirement.actor != EGO and requirement.kind in OF_OTHERS
