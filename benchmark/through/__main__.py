"""`python -m c2s_bench.through [--records] [FILE.yaml]`: every description to a run, and the table of causes."""

import argparse
import json
from dataclasses import asdict
from pathlib import Path

from c2s_bench.through.run import Outcome, collect, fresh, of_records, table

RESULTS = Path(__file__).parent.parent / "results" / "through.json"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--records", action="store_true", help="the 123 of the benchmark, too")
    parser.add_argument("--keep", action="store_true", help=f"write the table to {RESULTS.name} among the results")
    given = parser.parse_args()
    groups = {"written afresh": fresh()} | ({"the 123": of_records()} if given.records else {})
    kept = {}
    for name, descriptions in groups.items():
        print(f"\n{name}:", flush=True)
        results = collect(descriptions, show)
        print("\n" + table(results))
        kept[name] = [asdict(o) for o in results]
    if given.keep:
        RESULTS.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


def show(one: Outcome) -> None:
    """One line for what a reader may want to look at: what did not run, or lacks an expected event."""
    if not one.runs:
        print(f"- {one.name}: {one.cause}: {one.sentence}", flush=True)
    elif one.missing:
        events = ", ".join(f"{event} of {who}" for event, who in one.missing)
        print(f"- {one.name}: runs, but without {events}", flush=True)


if __name__ == "__main__":
    main()
