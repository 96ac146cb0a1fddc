"""`python -m c2s_bench.retrieval.fitting`: how often the snippets that a generator is shown fit its component.

By the sentence alone, and by what the component is and does as well; judged beforehand in fitting.yaml. A snippet that
was never judged counts as none that fits, and is listed.
"""

import tempfile
from pathlib import Path
from typing import Any

import yaml

from c2s_bench.retrieval.run import Row, table
from c2s_engine.retrieve.library import Library, default_threads

SHOWN = 3
KINDS = {"R": "place", "E": "ego", "O": "object"}


def cases() -> list[dict[str, Any]]:
    """The judged components."""
    return yaml.safe_load(Path(__file__).with_name("fitting.yaml").read_text(encoding="utf-8"))


def fitting(library: Library) -> tuple[list[Row], list[str]]:
    """A row for each kind and way of searching; the snippets that were shown but never judged."""
    rows: list[Row] = []
    unjudged: list[str] = []
    judged = cases()
    library.remember([c["q"] for c in judged])
    for kind, name in KINDS.items():
        chosen = [c for c in judged if c["component"] == kind]
        for way, with_terms in (("sentence", False), ("sentence and terms", True)):
            shown = fit = first = 0
            for case in chosen:
                terms = case["about"] if with_terms else ()
                found = [p.id.partition("/")[2] for p in library.search(case["q"], "snippet", kind, SHOWN, terms=terms)]
                unjudged += [f"{case['q']}: {i}" for i in found if i not in [*case["fits"], *case["other"]]]
                shown, fit = shown + len(found), fit + sum(i in case["fits"] for i in found)
                first += bool(found) and found[0] in case["fits"]
            rows.append({"component": f"{name} ({len(chosen)})", "by": way, "shown": shown, "fit": fit,
                         "fit %": round(100 * fit / shown, 1), "first fits": first})  # fmt: skip
    return rows, unjudged


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        found, never = fitting(Library(Path(folder), None, default_threads()))
    print(table(found))
    print("\n".join(["", "Never judged:", *never] if never else []))
