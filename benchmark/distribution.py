"""How the records are distributed, in the columns of the paper's table, beside the paper's own figures."""

from collections.abc import Sequence

from c2s_bench.paper import paper
from c2s_bench.records import Record, by_source

COLUMNS = ("Number", "SCE", "VRU", "VRU types", "TC", "Temporal", "DB vehicle", "DB VRU")


def distribution(records: Sequence[Record]) -> dict[str, tuple[int, ...]]:
    """The figures of each source and in all, counted from the tags."""
    groups = {**by_source(records), "Total": list(records)}
    return {source: _row(rows) for source, rows in groups.items()}


def _row(rows: Sequence[Record]) -> tuple[int, ...]:
    def having(tag: str) -> int:
        return sum(bool(r.tags.get(tag)) for r in rows)

    def distinct(tag: str) -> int:
        return len({label for r in rows for label in r.tags.get(tag, ())})

    return (
        len(rows),
        having("sce"),
        having("vru"),
        distinct("vru"),
        having("traffic_control"),
        having("temporal"),
        distinct("vehicle_behaviors"),
        distinct("vru_behaviors"),
    )


def markdown(records: Sequence[Record]) -> str:
    """The table in Markdown; where the paper's figure differs it stands in brackets."""
    theirs = paper()["distribution"]
    lines = ["| Source | " + " | ".join(COLUMNS) + " |", "| --- |" + " ---: |" * len(COLUMNS)]
    for source, row in distribution(records).items():
        published = theirs.get(source, row)
        cells = [str(n) if n == p else f"{n} ({p})" for n, p in zip(row, published, strict=True)]
        lines.append(f"| {source} | " + " | ".join(cells) + " |")
    note = "In brackets: the paper's figure, where it differs (it does not define the labels of its last columns)."
    return "\n".join([*lines, "", note])
