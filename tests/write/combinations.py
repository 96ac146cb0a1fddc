"""Do programs do what S says? `python -m tests.write.combinations [NAME...] [--seeds N]` runs combinations.yaml."""

import argparse
import asyncio
from collections import Counter
from pathlib import Path
from typing import Any

import yaml

from c2s_engine.api import Engine
from c2s_engine.paths import shipped
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec, SettingsSpec

FILE = Path(__file__).with_name("combinations.yaml")


def combinations() -> dict[str, dict[str, Any]]:
    """All rows by name."""
    return yaml.safe_load(FILE.read_text(encoding="utf-8"))


def structure(row: dict[str, Any]) -> Structure:
    """The structure of a row."""
    things = [ObjectSpec.model_validate({"component": "O", **one}) for one in row.get("O", ())]
    return Structure(
        settings=Component(id="G", spec=SettingsSpec.model_validate(row.get("G", {}))),
        place=Component(id="R", spec=PlaceSpec.model_validate(row.get("R", {}))),
        ego=Component(id="E", spec=EgoSpec.model_validate(row.get("E", {}))),
        objects=tuple(Component(id=f"O{i + 1}", spec=spec) for i, spec in enumerate(things)),
    )


async def missing(engine: Engine, row: dict[str, Any], seeds: int) -> Counter[str]:
    """What is not seen, and in how many of the runs; a program that does not run misses its stage in all."""
    last: Any = None
    async for event in engine.apply(structure(row), [], run=False):
        last = event
    for stage in last.stages:
        if not stage.ok:
            return Counter({f"{stage.name}: {stage.diagnostics[0].message}": seeds})
    found: Counter[str] = Counter()
    folder = str(shipped("maps"))
    report = await engine.check(last.program.text, spans=last.program.spans, upto="run", runs=seeds, folder=folder)
    for stage in report.stages:
        if not stage.ok:
            found[f"{stage.name}: {stage.diagnostics[0].message}"] = seeds
    for facts in report.facts:
        found.update(unseen(facts, row))
    return found


def unseen(facts: RunFacts, row: dict[str, Any]) -> list[str]:
    """What one run should show and does not."""
    of = {o.name: o.component for o in facts.objects} | {"ego": "ego"}
    out = []
    for cid, events in row.get("sees", {}).items():
        events_seen = [e for o in facts.objects if o.component == cid for e in o.events]
        shown = {(e.event, one) for e in events_seen for one in ("", of.get(e.other))}
        for event in events:
            name, _, other = event.partition(" ")
            if (name, other) not in shown:
                out.append(f"{cid} {event}")
    if "light" in row and facts.light != row["light"]:
        out.append(f"light {row['light']}")
    ego = next(o for o in facts.objects if o.component == "E")
    if "ego_kmh" in row and abs((ego.held_speed or 0) * 3.6 / row["ego_kmh"] - 1) > 0.1:
        out.append(f"ego at {row['ego_kmh']} km/h")
    return out


async def main(names: list[str], seeds: int) -> None:
    """Print what is not seen, by row."""
    rows = {name: row for name, row in combinations().items() if not names or name in names}
    whole = 0
    async with Engine() as engine:
        for name, row in rows.items():
            found = await missing(engine, row, seeds)
            whole += not found
            if found:
                print(f"{name:34}{', '.join(f'{what} ({n}/{seeds})' for what, n in found.items())}", flush=True)
    print(f"{whole} of {len(rows)} show all in {seeds} runs each")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--seeds", type=int, default=5)
    options = parser.parse_args()
    asyncio.run(main(options.names, options.seeds))
