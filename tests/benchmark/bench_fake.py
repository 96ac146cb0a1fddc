"""An engine with the facade's face that needs no Scenic: the text says what its facts are to be."""

import os
from pathlib import Path

from bench_scenes import run, thing

from c2s_engine.structure.components import Structure
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import Finished, ProgramChanged, Usage


class FakeEngine:
    """Counts its calls in the file that FAKE_CALLS names, a character each."""

    async def __aenter__(self):
        return self

    async def __aexit__(self, *_):
        return None

    async def generate(self, text, *, method, map, seed, run: bool, runs):
        with Path(os.environ["FAKE_CALLS"]).open("a") as calls:
            calls.write("x")
        if "die" in text:
            os._exit(3)
        if "raise" in text:
            raise RuntimeError("out of order")
        program = Program(text=f"# {method}: {text}\n")
        yield Usage(purpose="write", prompt_tokens=100, answer_tokens=20)
        yield ProgramChanged(program=program)
        ok = "refuse" not in text
        words = tuple(w for w in ("rain", "fog") if w in text)
        facts = tuple(_facts(words, seed + k) for k in range(runs)) if ok else ()
        why = Diagnostic(stage="compile", message="no such lane")
        stage = StageResult(name="run", ok=True) if ok else StageResult(name="compile", ok=False, diagnostics=(why,))
        yield Finished(ok=ok, structure=Structure(), program=program, stages=(stage,), facts=facts, seconds=2.0)


def _facts(words, seed):
    return run(thing("lead", does=("stop",)), weather=words, seed=seed)


def engine(setup):
    return FakeEngine()
