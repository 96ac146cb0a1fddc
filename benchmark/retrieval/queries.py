"""The benchmark's queries."""

from dataclasses import dataclass
from pathlib import Path

import yaml

from c2s_engine.retrieve.rows import Kind


@dataclass(frozen=True)
class Query:
    """A query with what is relevant to it: grades by snippet name, or by words of a passage's title path."""

    text: str
    kind: Kind
    component: str | None
    reworded: bool
    relevant: dict[str, int]
    reported: bool
    """Every second query is reported only; the thresholds were fitted on the others."""

    def grade(self, item: str, title: str) -> int:
        """The grade of a result (0: not relevant)."""
        if self.kind == "snippet":
            return self.relevant.get(item.split("/", 1)[-1], 0)
        return max((g for words, g in self.relevant.items() if names(words, title)), default=0)


def names(words: str, title: str) -> bool:
    """Whether a title path is meant by those words: a heading's beginning after `›`, or part of the path."""
    if words.startswith("› "):
        return title.endswith(words) or f"{words} ›" in title
    return words in title


def load() -> list[Query]:
    """All queries, in the file's order."""
    data = yaml.safe_load((Path(__file__).parent / "queries.yaml").read_text())
    found = []
    kinds: tuple[tuple[str, Kind], ...] = (("snippets", "snippet"), ("documents", "doc"))
    for section, kind in kinds:
        found += [
            Query(q["q"], kind, q.get("component"), q.get("reworded", False), q["relevant"], i % 2 == 1)
            for i, q in enumerate(data[section])
        ]
    return found
