"""One record's atoms, one by one: what held, how often, and what did not."""

from c2s_bench.assign import match
from c2s_bench.atoms import LAYERS, expectation
from c2s_bench.records import Record
from c2s_bench.results import Result
from c2s_engine.structure.facts import RunFacts


def explain(record: Record, result: Result) -> str:
    """The text, the verdict, every atom with the share of rollouts in which it held, what was seen, the program."""
    figures = ", ".join(f"{k} {v:.0f}" for k, v in result.score.layers.items() if v is not None)
    lines = [f"{record.id} ({record.source}, {record.reference})", record.text, ""]
    lines.append(f"ran, SQ {result.score.sq:.1f} ({figures})" if result.score.ran else f"did not run: {result.reason}")
    for layer in LAYERS:
        for atom in result.score.atoms:
            if atom.layer == layer:
                mark = "left out" if atom.excluded else "holds" if atom.holds else "FAILS"
                why = f" ({atom.excluded})" if atom.excluded else ""
                lines.append(f"  {layer}  {mark:<8} {100 * atom.share:3.0f} %  {atom.atom}{why}")
    if result.first:
        members = match(expectation(record.expect), result.first).members
        stands = [f"{name} is {' and '.join(o.name for o in found) or 'not there'}" for name, found in members.items()]
        lines += ["", f"The first rollout (seed {result.first.seed}): {'; '.join(stands)}", events(result.first)]
    return "\n".join([*lines, "", result.program.rstrip() or "(no program)"])


def events(facts: RunFacts) -> str:
    """A rollout's road, surroundings and events in words."""
    road = facts.road
    parts = [f"{road.lanes_same_direction} lanes in ego's direction", f"intersection: {road.intersection}"]
    parts += [w for w in ("oncoming_lane", "signalized", "curve", "straight") if getattr(road, w)]
    lines = [f"road: {', '.join(parts)}", f"weather: {', '.join((*facts.weather, *facts.time)) or 'unknown'}"]
    if there := (*facts.infrastructure, *facts.temporary):
        lines.append(f"on ego's way: {', '.join(there)}" + (f" (light {facts.light})" if facts.light else ""))
    for thing in facts.objects:
        start = thing.starts.get("ego")
        where = f", starts {'/'.join(start.lanes)} {'/'.join(start.relations)} at {start.gap:.0f} m" if start else ""
        speed = f", {thing.held_speed * 3.6:.0f} km/h" if thing.held_speed else ""
        shown = "; ".join(f"{e.time:.1f} s {e.event}{f' {e.other}' if e.other else ''}" for e in thing.events)
        lines.append(f"{thing.name} ({thing.types[0]}{speed}{where}): {shown or 'nothing'}")
    return "\n".join([*lines, f"ends after {facts.duration:.1f} s by {facts.ended_by}"])
