"""`python -m c2s_bench.local.selection [N]`: the first N development records of each source (2), as a records file."""

import sys
from collections import Counter

import yaml

from c2s_bench.records import load


def selected(each: int) -> str:
    """The records as YAML, in the order in which they stand."""
    taken: Counter[str] = Counter()
    chosen = []
    for record in load(split="dev"):
        taken[record.source] += 1
        if taken[record.source] <= each:
            chosen.append(record.id)
    entries = [e for f in sorted({r.file for r in load()}) for e in yaml.safe_load(f.read_text(encoding="utf-8"))]
    return yaml.safe_dump([e for e in entries if e["id"] in chosen], sort_keys=False, allow_unicode=True)


if __name__ == "__main__":
    print(selected(int(sys.argv[1]) if len(sys.argv) > 1 else 2), end="")
