"""What a dossier is made of: a text, its S, the program, and one run of it with the tracks."""

from pydantic import BaseModel, ConfigDict

from c2s_engine.session.other_drivers import OtherDriver
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.facts import RunFacts, Trajectories
from c2s_engine.structure.program import Program
from c2s_engine.structure.requirements import Result


class ReportError(ValueError):
    """No dossier can be made of that; the message says what would do."""


class Material(BaseModel):
    """One scenario. `facts` and `ways` are None where nothing ran: `problem` says why, in a sentence."""

    model_config = ConfigDict(frozen=True)

    id: str
    text: str = ""
    matters: str = ""  # what matters most to who wrote the text, in their words
    changes: tuple[str, ...] = ()  # what was asked for after the text, in its order
    origin: str = ""  # where S comes from: a method, a session, an imported program
    structure: Structure = Structure()
    idle: tuple[Unmet, ...] = ()  # phrases of the text without which S would be the same
    program: Program = Program(text="")
    faults: tuple[Diagnostic, ...] = ()
    facts: RunFacts | None = None
    ways: Trajectories | None = None
    results: tuple[Result, ...] = ()  # of what S requires, as the engine judged it with ego's reaction switched off too
    drivers: tuple[OtherDriver, ...] = ()  # how it went with others in ego's place, where that was asked for
    seed: int = 0
    map_name: str = ""
    map_digest: str = ""
    problem: str = ""

    @property
    def imported(self) -> bool:
        """Whether S was recognised in a program rather than read from a text."""
        return any(c.origin == "imported" for c in self.structure.components)


def problem_of(faults: tuple[Diagnostic, ...], facts: RunFacts | None) -> str:
    """Why there is no whole run, in a sentence; empty where there is one."""
    errors = [d for d in faults if d.severity == "error"]
    if facts is None:
        return f"It did not run: {errors[0].message}" if errors else "It was not run."
    if not facts.ran:
        why = f": {facts.reason}" if facts.reason else ""
        after = f"after {facts.duration:.1f} s ({facts.ended_by}{why})"
        return f"The run stopped early, {after}: what follows was not judged."
    return ""
