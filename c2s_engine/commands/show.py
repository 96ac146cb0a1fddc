"""How results look on a terminal: S, stages, diagnostics, what was said and what was seen."""

from collections.abc import Iterable, Mapping, Sequence
from difflib import unified_diff
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from c2s_engine.commands.console import out
from c2s_engine.session import no_effect
from c2s_engine.session.seeds import verdict
from c2s_engine.session.why import KEPT
from c2s_engine.structure.account import count_lost_clauses, requirements_met, unread_words
from c2s_engine.structure.components import Structure, Unmet, given_up, unrecognised
from c2s_engine.structure.diagnostics import Diagnostic, StageResult
from c2s_engine.structure.event_words import ended, event_phrase
from c2s_engine.structure.facts import EventFact, RunFacts
from c2s_engine.structure.measures import Measures, SeedResult, collisions
from c2s_engine.structure.offers import verdict as contradicting
from c2s_engine.structure.requirements import Requirement, Result, failures


def structure(s: Structure, to: Console = out) -> None:
    """S, a component a row, with what was assumed and what could not be said."""
    table = Table(show_header=False, box=None, pad_edge=False)
    for c in s.components:
        table.add_row(Text(c.id, style="bold"), Text(c.description or "-"))
        if c.by_hand == "apart":
            table.add_row("", Text(KEPT, style="yellow"))
        for a in c.assumed:
            table.add_row("", Text(f"assumed {a.called} = {a.value}: {a.reason}", style="dim"))
        for u in c.unmet:
            table.add_row("", Text(f'not expressible: "{u.text}": {u.reason}', style="yellow"))
    for u in s.not_understood:
        table.add_row("", Text(f'not understood: "{u.text}": {u.reason}', style="yellow"))
    if words := unread_words(s.text[a:b] for a, b in s.unread):
        table.add_row("", Text(words, style="dim"))
    for u in s.background:
        table.add_row("", Text(f'background: "{u.text}": {u.reason}', style="dim"))
    to.print(table)


def stages(results: Iterable[StageResult], to: Console = out) -> None:
    line = Text()
    for s in results:
        line.append("✓ " if s.ok else "✗ ", style="green" if s.ok else "red")
        line.append(f"{s.name} {s.seconds * 1000:.0f} ms   ")
    to.print(line)


def diagnostics(found: Iterable[Diagnostic], to: Console = out) -> None:
    for d in found:
        style = {"error": "red", "warning": "yellow"}.get(d.severity, "")
        where = " ".join(w for w in (d.component, f"line {d.line}" if d.line else "") if w)
        to.print(Text(f"{d.stage}{' ' + where if where else ''}: {d.message}", style=style))
        if d.text:
            to.print(Text(f"    {d.text.strip()}", style="dim"))
        if d.fix:
            to.print(Text(f"    fix: {d.fix}"))


def cost(details: Mapping[str, Any], to: Console = out) -> None:
    """What a model's turn cost, and how much of S is the model's own."""
    if details.get("tokens"):
        share = details.get("share")
        own = f"; {share:.0%} of the components without fallback" if share is not None else ""
        to.print(Text(f"{details['tokens']:,} tokens{own}", style="dim"))


def outcome(
    s: Structure, facts: Sequence[RunFacts], requirements: Sequence[Requirement], results: Sequence[Result],
    measures: Sequence[Measures], to: Console = out, idle: Sequence[Unmet] = (),
) -> None:  # fmt: skip
    """What the runs showed, what of it S requires, what of the text was given up, and `idle`: its words without which
    S would be the same."""
    if facts:
        _runs(facts, requirements, measures, bool(s.text), to)
        _required(s, requirements, results, idle, to)
    if left := given_up(s):
        to.print(Text(f"Changed from the text: {', '.join(left)}", style="yellow"))
    without_effect(idle, to)


def conflicts(s: Structure, session: str, to: Console = out) -> None:
    """Where code by hand says otherwise than S: what would be written instead, and how to take it."""
    for component in s.components:
        if component.conflict:
            lines = list(unified_diff(component.code.splitlines(), component.conflict.splitlines(), lineterm="", n=0))
            changed = "\n".join(f"    {line}" for line in lines[2:] if not line.startswith("@@"))
            to.print(Text(f"{component.id}: your code is in conflict with its fields, by which it would be\n{changed}\n"
                          f"    (`c2s edit {session} --code {component.id}=` takes that)", style="yellow"))  # fmt: skip


def without_effect(found: Sequence[Unmet], to: Console = out) -> None:
    """Words of the text without which S would be the same."""
    if found:
        to.print(Text(no_effect.phrases_sentence(found), style="yellow"))


def contradictions(details: Mapping[str, Any], to: Console = out) -> None:
    """Which numbers of the text contradict one another, where that was looked for."""
    if "contradictions" in details:
        to.print(Text(contradicting(details["contradictions"]), style="yellow"))


def _runs(
    facts: Iterable[RunFacts], requirements: Sequence[Requirement], measures: Sequence[Measures], in_text: bool,
    to: Console,
) -> None:  # fmt: skip
    """The timeline of events of each rollout, its collisions, and how near the actors came."""
    numbers = iter(measures)
    for f in facts:
        to.print(Text(f"run with seed {f.seed}: {f.duration:.1f} s; the end: {ended(f)}", style="bold"))
        events = sorted((e.time, o.name, e.event, e.other) for o in f.objects for e in o.events)
        table = Table(show_header=False, box=None, pad_edge=False)
        for time, name, event, other in events:
            told_of = event_phrase(EventFact(event=event, time=time, other=other))
            table.add_row(f"{time:5.1f} s", Text(name), Text(told_of))
        to.print(table)
        for hit in collisions(f, requirements, in_text):
            to.print(Text(str(hit), style="" if hit.said else "bold red"))
        if f.objects and (found := next(numbers, None)):
            _nearness(found, to)
    to.print(Text('Seen in the dry run, which is not CARLA: see docs/guide.md, "The dry run".', style="dim"))


def _nearness(found: Measures, to: Console) -> None:
    for p in sorted(found.pairs, key=lambda p: p.gap_m)[:6]:
        ttc = f", time to collision at least {p.ttc_s:.1f} s" if p.ttc_s is not None else ""
        pet = f", post-encroachment time {p.pet_s:.1f} s" if p.pet_s is not None else ""
        to.print(Text(f"ego and {p.other}: at least {p.gap_m:.1f} m apart, bumper to bumper{ttc}{pet}"))


def seeds(rows: Sequence[SeedResult], to: Console = out) -> None:
    """The end of a series of runs: its verdict."""
    to.print(Text(verdict(rows), style="green" if all(r.passed for r in rows) else "yellow"))


def seed(row: SeedResult, to: Console = out) -> None:
    """One row of a series of runs."""
    mark, style = ("✓ passed", "green") if row.passed else ("✗ failed", "red")
    near = "" if row.gap_m is None else f"  gap {row.gap_m:.1f} m"
    soon = "" if row.ttc_s is None else f"  TTC {row.ttc_s:.1f} s"
    met = f"  {row.met} of {row.required} met" if row.required else ""
    why = f"  {row.collisions[0]}" if row.collisions else f"  {row.unmet[0]}" if row.unmet else ""
    end = "" if row.ran else f"  {row.ended}"
    to.print(Text(f"{mark}  seed {row.seed:<4}{met}{near}{soon}{end}{why}", style=style), soft_wrap=True)


def _required(
    s: Structure, requirements: Sequence[Requirement], results: Sequence[Result], idle: Sequence[Unmet], to: Console
) -> None:
    """How much of what S requires was seen, and of the text is not in S; a line for each failure."""
    if not results:
        return
    whole = all(r.holds for r in results) and not count_lost_clauses(s, idle)
    to.print(Text(requirements_met(s, results, idle), style="green" if whole else "yellow"))
    for line in failures(requirements, results):
        to.print(Text(line, style="yellow"))
    if partly := unrecognised(s):
        words = ", ".join(partly)
        to.print(Text(f"Of {words} only what was recognised in the code is required.", style="dim"))


def events_as_dicts(facts: Iterable[RunFacts]) -> list[dict[str, Any]]:
    """The events of each rollout, as plain data; times in s."""
    return [
        {"seed": f.seed, "time": e.time, "object": o.name, "event": e.event, "other": e.other}
        for f in facts
        for o in f.objects
        for e in o.events
    ]


def required_as_dicts(requirements: Sequence[Requirement], results: Sequence[Result]) -> list[dict[str, Any]]:
    """Each requirement with its result, as plain data."""
    found = {r.requirement: r.model_dump(mode="json", exclude={"requirement"}) for r in results}
    return [{**r.model_dump(mode="json"), "result": found.get(r.id)} for r in requirements]
