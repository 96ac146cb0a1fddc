"""What the tools answer, as plain data of a size that an assistant can read."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from c2s_engine.check.protocol import CheckReport
from c2s_engine.commands import show
from c2s_engine.structure.account import account
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.progress import Finished, Passage
from c2s_engine.structure.requirements import Requirement, Result, failures, tally


def structure(s: Structure, idle: Sequence[Unmet] = ()) -> dict[str, Any]:
    """S, and what of the text is not in it. `idle`: phrases of the text without which S would be the same."""
    components = [
        {
            "id": c.id, "description": c.description, "spec": c.spec.model_dump(mode="json", exclude_defaults=True),
            "assumed": [f"{a.field} = {a.value}: {a.reason}" for a in c.assumed],
            "not_expressible": [f"{u.text}: {u.reason}" for u in c.unmet],
        }
        for c in s.components
    ]  # fmt: skip
    clauses = [{"text": c.text, "status": c.status, "components": c.components, "unread": c.unread}
               for c in account(s, idle)]  # fmt: skip
    lost = [f"{u.text}: {u.reason}" for u in s.not_understood]
    return {
        "structure": components, "not_understood": lost, "account": clauses, "without_effect": [u.text for u in idle],
    }  # fmt: skip


def scenario(done: Finished, output: str | None, idle: Sequence[Unmet] = ()) -> dict[str, Any]:
    """A turn's end: the program, S and what the run showed; saved where that is wanted."""
    saved: list[str] = []
    kept: list[str] = []
    if output and done.program.text:
        from c2s_engine.saving import kept_beside, save

        folders = [done.details.get("folder")]
        saved = [str(p) for p in save(done.program, folders, Path(output), structure=done.structure)]
        kept = kept_beside(done.program, folders, Path(output))
    return {
        "ok": done.ok,
        "program": done.program.text,
        **structure(done.structure, idle),
        "problems": [_problem(d) for d in done.diagnostics],
        "events": show.events_as_dicts(done.facts),
        "required": required(done.requirements, done.results),
        "map": done.details.get("map"),
        "saved": saved,
        "kept_beside": kept,
    }


def report(found: CheckReport) -> dict[str, Any]:
    """A check: its stages, and what was found."""
    stages = [{"name": s.name, "ok": s.ok} for s in found.stages]
    return {"ok": found.ok, "stages": stages, "problems": [_problem(d) for s in found.stages for d in s.diagnostics]}


def _problem(d: Diagnostic) -> dict[str, Any]:
    told = {"stage": d.stage, "severity": d.severity, "component": d.component, "line": d.line, "message": d.message}
    return {k: v for k, v in {**told, "fix": d.fix}.items() if v}


def required(requirements: Sequence[Requirement], results: Sequence[Result]) -> dict[str, Any]:
    """How much of what S requires the runs showed, and a line for each thing that they did not."""
    seen, of = tally(results)
    return {"seen": seen, "of": of, "not_seen": list(failures(requirements, results))}


def passage(p: Passage) -> dict[str, Any]:
    """A passage that was found, with where it stands."""
    return p.model_dump(mode="json", exclude={"type", "ranks"}, exclude_defaults=True)
