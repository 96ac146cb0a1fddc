"""The messages between the front and the check server. No Scenic here: the front imports this."""

from typing import Literal

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.facts import RunFacts, Trajectories
from c2s_engine.structure.program import FragmentSpan

Upto = Literal["parse", "safety", "compile", "sample", "run"]


class _Message(BaseModel):
    model_config = ConfigDict(extra="forbid")


class Limits(_Message):
    """What one check may use; beyond it the child is killed, with a diagnostic that says which limit it was."""

    wall: float = 60.0  # s
    cpu: float = 60.0  # s
    memory: int = 3 << 30  # bytes of address space
    output: int = 1 << 20  # bytes on stdout and stderr together
    iterations: int = 2000  # of the sampler
    sample_seconds: float = 20.0


class CheckRequest(_Message):
    """Check a program up to a stage. Stages stop at the first that fails."""

    program: str
    filename: str = "program.scenic"
    folder: str | None = None  # where relative map paths (localPath) are looked up
    spans: tuple[FragmentSpan, ...] = ()
    upto: Upto = "sample"
    seed: int = 0
    runs: int = 1  # rollouts: scene k is sampled with seed + k
    seconds: float = 20.0  # of simulated time a rollout, where the program does not end sooner
    trajectories: bool = False
    trust: bool = False  # skip the safety stage (the user's own file)
    model: str | None = None  # the world model that takes the place of the program's own
    scenario: str | None = None  # of several modular ones, the one that is meant
    allow: tuple[tuple[str, str], ...] = ()  # further (module, name) pairs that may be imported
    params: dict[str, str | float | int | bool] = {}  # global parameters that override the program's
    limits: Limits = Limits()


class CheckReport(_Message):
    stages: tuple[StageResult, ...]
    facts: tuple[RunFacts, ...] = ()
    trajectories: tuple[Trajectories, ...] = ()
    iterations: tuple[int, ...] = ()  # of the sampler, a scene
    scenes: tuple[dict[str, tuple[float, float, float]], ...] = ()  # name -> x (m), y (m), heading (rad) at the start
    isolation: str = ""  # in words: what the child was confined by, and what was not available
    ast_hash: str = ""

    @property
    def ok(self) -> bool:
        return all(s.ok for s in self.stages)


class ImportRequest(_Message):
    """Decompose a program into components."""

    text: str
    filename: str = "program.scenic"


class ImportResult(_Message):
    """S of an imported program. `upgraded`: its text in Scenic 3 where it was older, with the `diff`."""

    structure: Structure | None = None
    upgraded: str | None = None
    diff: str = ""
    diagnostics: tuple[Diagnostic, ...] = ()  # why there is no structure


class PlacesRequest(_Message):
    """Evaluate expressions over a map's network (the very ones that programs contain): how many, where."""

    map: str  # path of an .xodr
    expressions: dict[str, str]  # name -> Scenic expression over `network` that gives a list
    first: bool = False  # whether those after the first that gives any are left out


class PlacesReport(_Message):
    counts: dict[str, int]
    errors: dict[str, str] = {}
    at: dict[str, tuple[tuple[float, float], ...]] = {}  # name -> a position (m) of each, at most 50
