"""What the results pane shows, as text: outcome, requirements, events by actor, plots, a series of runs."""

from collections.abc import Mapping, Sequence

from textual.content import Content

from c2s_engine.structure.account import requirements_met
from c2s_engine.structure.event_words import USUAL, ended, event_phrase
from c2s_engine.structure.facts import EGO, ObjectFacts, RunFacts, Trajectories
from c2s_engine.structure.measures import Measures, SeedResult
from c2s_engine.structure.requirements import Requirement, Result
from c2s_tui.desk import Desk
from c2s_tui.look.kinds import ascii_only, colour, mark, mentions
from c2s_tui.results.plot import MARGIN, Curve, plot

PLOT_ROWS = 7
NEAREST = 6
"""Actors whose distances are listed and plotted, the nearest first."""


def report(desk: Desk, gaps: Mapping[str, Sequence[float]], width: int) -> Content:
    """The whole pane for the desk's first run. `gaps`: m to ego at each step, by the other's name."""
    parts = [outcome(desk)]
    if desk.planned:
        parts.append(seeds(desk.seeds, desk.planned, width))
    if desk.facts:
        facts = desk.facts[0]
        failed = [r for r in desk.results if not r.holds]
        parts.append(requirements("Requirements that are not met", desk.requirements, failed))
        parts.append(timeline(facts, width))
        if desk.trajectories:
            parts += plots(facts, desk.trajectories[0], gaps, width)
        met = [r for r in desk.results if r.holds]
        parts.append(requirements("Requirements that are met", desk.requirements, met))
    return Content("\n\n").join([p for p in parts if p.plain])


def heading(text: str) -> tuple[str, str]:
    return f"{text}\n", "bold $text-primary"


def outcome(desk: Desk) -> Content:
    """Collisions, how the run ended, how near the actors came."""
    if not desk.facts and desk.making:
        return Content.styled("A new program is being made: what its run shows comes here.", "$muted")
    if not desk.facts:
        failed = next((s for s in desk.stages if not s.ok), None)
        if failed is not None:
            return Content.styled(f"There is no run: {failed.name} failed. F8 goes to the finding.", "$text-error")
        return Content.styled("There is no run yet: describe a scenario, or press F5 to run the program.", "$muted")
    facts = desk.facts[0]
    parts: list = [heading("Outcome")]
    for hit in desk.collisions:
        sign, style = ("clean", "$text-success") if hit.said else ("error", "bold $text-error")
        parts.append((f"{mark(sign)} {hit}\n", style))
    if not desk.collisions:
        parts.append((f"{mark('clean')} no collision\n", "$text-success"))
    parts.append(f"The run ended after {facts.duration:.1f} s ({ended(facts)}); seed {facts.seed}.\n")
    parts += _nearness(next(iter(desk.measures), Measures()), facts)
    if desk.results:
        parts.append(f"{requirements_met(desk.structure, desk.results, desk.idle)}\n")
    return Content.assemble(*parts).rstrip()


def _nearness(found: Measures, facts: RunFacts) -> list:
    parts: list = []
    for p in sorted(found.pairs, key=lambda p: p.gap_m)[:NEAREST]:
        parts += ["ego and ", (p.other, _style(p.other, facts)), f": at least {p.gap_m:.1f} m apart (bumper to bumper)"]
        if p.ttc_s is not None:
            parts.append(f", minimum TTC {p.ttc_s:.1f} s at {p.ttc_at_s:.1f} s")
        if p.pet_s is not None:
            parts.append(f", PET {p.pet_s:.1f} s")
        parts.append("\n")
    return parts


def requirements(title: str, required: Sequence[Requirement], results: Sequence[Result]) -> Content:
    """Each requirement with what was said and what the run showed."""
    if not results:
        return Content("")
    parts: list = [heading(f"{title}: {len(results)}")]
    known = {r.id: r for r in required}
    for result in results:
        asked = known.get(result.requirement)
        if asked is None:
            continue
        name = "clean" if result.holds else "unknown" if result.holds is None else "failed"
        style = {"clean": "$text-success", "unknown": "$muted", "failed": "$text-error"}[name]
        named = asked.component in asked.text or asked.component == "E" and "ego" in asked.text.lower()
        whose = "" if named else f"{asked.component}: "
        parts += [(f"{mark(name)} ", style), (whose, f"bold {colour(asked.component)}"), mentions(asked.text)]
        values = [f"required: {result.said}"] if result.said else []
        values += [f"the run: {result.seen}"] if result.seen else [result.why] if result.why else []
        parts.append((f"  {'; '.join(values)}\n", "$muted"))
    return Content.assemble(*parts).rstrip()


def timeline(facts: RunFacts, width: int) -> Content:
    """A line of time for each actor with a mark at each event, then its events in words."""
    parts: list = [heading("Events")]
    room, line, dot = max(8, width - 14), "-" if ascii_only() else "─", "*" if ascii_only() else "●"
    shown = [o for o in facts.objects if _notable(o)]
    for thing in shown:
        style = _style(thing.name, facts)
        cells = [line] * room
        for event in _notable(thing):
            cells[min(room - 1, int(event.time / max(facts.duration, 0.1) * (room - 1)))] = dot
        parts += [(f"{thing.name[:12]:<13}", f"bold {style}"), ("".join(cells), style), "\n"]
        for event in _notable(thing):
            parts += [(f"{event.time:>11.1f} s ", "$muted"), f"{event_phrase(event)}\n"]
    if not shown:
        parts.append(("There were no events.\n", "$muted"))
    return Content.assemble(*parts).rstrip()


def _notable(thing: ObjectFacts) -> list:
    """The events to show, in the order of time: the usual ones only where there is nothing else."""
    return sorted((e for e in thing.events if e.event not in USUAL and e.time > 0), key=lambda e: e.time)


def plots(facts: RunFacts, ways: Trajectories, gaps: Mapping[str, Sequence[float]], width: int) -> list[Content]:
    """Speeds of all that move, and the gaps between ego and the nearest others."""
    moving = [t for t in ways.tracks if t.kind != "prop" and max(t.speed, default=0) > 0.3]
    moving.sort(key=lambda t: t.name == EGO)
    seconds = max((len(t.speed) - 1) * ways.step for t in ways.tracks) if ways.tracks else 0.0
    speeds = [Curve([v * 3.6 for v in t.speed], _style(t.name, facts)) for t in moving]
    near = sorted((n for n in gaps if len(gaps[n])), key=lambda n: min(gaps[n]))[:NEAREST]
    curves = [Curve(gaps[n], _style(n, facts)) for n in reversed(near)]
    found = []
    for title, names, drawn, unit in (("Speeds", [t.name for t in reversed(moving)], speeds, "km/h"),
                                      ("Gaps to ego, bumper to bumper", near, curves, "m")):  # fmt: skip
        picture = plot(drawn, seconds, width, PLOT_ROWS, unit)
        if picture.plain:
            legend = [(f"  {n}", f"bold {_style(n, facts)}") for n in names]
            found.append(Content.assemble((title, "bold $text-primary"), *legend, "\n") + picture)
    return found


def seeds(rows: Sequence[SeedResult], planned: int, width: int) -> Content:
    """A series of runs as a table that fills: passed or failed, requirements met, nearest, what was missed."""
    passed = sum(r.passed for r in rows)
    parts: list = [heading(f"Seeds: {len(rows)} of {planned} run, {passed} passed, {len(rows) - passed} failed")]
    parts.append((f"  {'seed':<6}{'met':<9}{'gap':<9}{'TTC':<8}first requirement not met\n", "$muted"))
    for row in rows:
        style = "$text-success" if row.passed else "$text-error"
        met = f"{row.met}/{row.required}" if row.required else ""
        gap = "" if row.gap_m is None else f"{row.gap_m:.1f} m"
        ttc = "" if row.ttc_s is None else f"{row.ttc_s:.1f} s"
        why = next(iter((*row.collisions, *row.unmet)), "" if row.ran else row.ended)
        room = max(10, width - 36)
        parts += [
            (f"{mark('clean' if row.passed else 'failed')} ", style), f"{row.seed:<6}{met:<9}{gap:<9}{ttc:<8}",
            f"{why if len(why) <= room else why[: room - 1] + '…'}\n",
        ]  # fmt: skip
    return Content.assemble(*parts).rstrip()


def _style(name: str, facts: RunFacts) -> str:
    """The colour of an actor's component."""
    if name == EGO:
        return colour("E")
    return colour(next((o.component for o in facts.objects if o.name == name and o.component), "O"))


__all__ = ["MARGIN", "report"]
