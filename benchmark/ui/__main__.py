"""`python -m c2s_bench.ui`: measures the app and prints a table (or JSON with --json)."""

import argparse
import asyncio
import json
import platform

from c2s_bench.ui.editing import edit_long_program
from c2s_bench.ui.latency import key_to_draw
from c2s_bench.ui.terminal import first_paint, idle_cpu

GOALS: dict[str, float | None] = {
    "first paint, s (median of starts)": 0.4,
    "  of the app's processor time, s (in steps of 0.01)": None,
    "what was typed upon it is shown, s (median of starts)": None,
    "key to draw while a scenario is made, ms (95th percentile)": 50.0,
    "  of the app's processor time, ms (95th percentile)": None,
    "key to draw in a program of 2,000 lines, ms (95th percentile)": 50.0,
    "  of the app's processor time then, ms (95th percentile)": None,
    "scroll a page in a program of 2,000 lines, ms (95th percentile)": 50.0,
    "  of the app's processor time there, ms (95th percentile)": None,
    "processor time while idle, %": 1.0,
}


def main() -> None:
    """Run all measurements, one after the other."""
    parser = argparse.ArgumentParser(prog="python -m c2s_bench.ui", description=__doc__)
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--starts", type=int, default=9, help="starts of the app to take the first paint from")
    parser.add_argument("--idle", type=float, default=20.0, help="seconds to watch the idle app")
    options = parser.parse_args()
    paints, made = first_paint(options.starts), asyncio.run(key_to_draw())
    key, scroll = asyncio.run(edit_long_program())
    measured = [f for times in (made, key, scroll) for f in (times.wall, times.processor)]
    figures = [*paints, *measured, idle_cpu(options.idle)]
    rows = {name: (value, goal) for (name, goal), value in zip(GOALS.items(), figures, strict=True)}
    if options.json:
        machine = f"{platform.processor() or platform.machine()}, Python {platform.python_version()}"
        print(json.dumps({"machine": machine, **{n: {"value": v, "goal": g} for n, (v, g) in rows.items()}}, indent=1))
        return
    for name, (value, goal) in rows.items():
        verdict = "no goal" if goal is None else f"goal {goal:g}   {'met' if value <= goal else 'MISSED'}"
        print(f"{name:<66} {value:8.2f}   {verdict}")


if __name__ == "__main__":
    main()
