"""A part of the records as a records file, for trials with a slow model.

`python -m c2s_bench.local.selection N`: the first N development records of each source (2). `... selection every N`:
the first of all records and each Nth after it, both parts of the benchmark.
"""

import sys
from collections import Counter

import yaml

from c2s_bench.records import load


def first(each: int) -> list[str]:
    """The ids of the first development records of each source."""
    taken: Counter[str] = Counter()
    chosen = []
    for record in load(split="dev"):
        taken[record.source] += 1
        if taken[record.source] <= each:
            chosen.append(record.id)
    return chosen


def every(step: int) -> list[str]:
    """The ids of each `step`th record, of all."""
    return [r.id for r in load()[::step]]


def as_yaml(ids: list[str]) -> str:
    """The records as YAML, in the order in which they stand."""
    entries = [e for f in sorted({r.file for r in load()}) for e in yaml.safe_load(f.read_text(encoding="utf-8"))]
    return yaml.safe_dump([e for e in entries if e["id"] in ids], sort_keys=False, allow_unicode=True)


if __name__ == "__main__":
    told = sys.argv[1:]
    print(as_yaml(every(int(told[1])) if told[:1] == ["every"] else first(int(told[0]) if told else 2)), end="")
