"""Scores by hand, as in the paper: a sheet to fill in, and how well the filled one agrees with the executed scores."""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import StatisticsError, correlation, mean
from typing import Any

import yaml

from c2s_bench.atoms import LAYERS
from c2s_bench.explain import events
from c2s_bench.records import BenchmarkError, Record
from c2s_bench.results import Result
from c2s_engine.structure.facts import RunFacts

HEAD = """\
# For each record, give each layer under `scores` a number from 0 (nothing is as the text says) to 100 (all of it is):
# RL road, TI lights and signs, TM temporary things, DO ego and the other objects, EN weather and time of day.
# Leave a score empty where you cannot tell. Then: c2s bench rate --read THIS_FILE
"""
NEAR = 10.0  # percentage points within which two scores count as agreeing

Picture = Callable[[str], str]


class _Block(str):
    """Text that YAML shows line by line."""


class _Dumper(yaml.SafeDumper):
    pass


_Dumper.add_representer(_Block, lambda d, text: d.represent_scalar("tag:yaml.org,2002:str", text, style="|"))
_Dumper.add_representer(type(None), lambda d, _: d.represent_scalar("tag:yaml.org,2002:null", ""))


def write_sheet(
    file: Path, records: Sequence[Record], results: Sequence[Result], facts: Mapping[str, RunFacts], picture: Picture
) -> int:
    """Write the programs that ran as a sheet, and the executed scores in a file beside it; how many there are.

    The raters see the text, the program, the first rollout's events and its picture, and not the executed scores.
    """
    rows: list[dict[str, Any]] = []
    executed: dict[str, Any] = {}
    for record, result in zip(records, results, strict=True):
        if not result.score.ran:
            continue
        layers = {layer: result.score.layers[layer] for layer in LAYERS if result.score.layers[layer] is not None}
        executed[record.id] = layers
        rows.append(
            {
                "id": record.id,
                "text": _Block(record.text),
                "program": _Block(_clean(result.program)),
                "events": _Block(events(facts[record.id])),
                "picture": _Block(_clean(picture(record.id))),
                "scores": dict.fromkeys(layers),
            }
        )
    body = yaml.dump(rows, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=110)
    file.write_text(HEAD + body, encoding="utf-8")
    _beside(file).write_text(json.dumps(executed, indent=1), encoding="utf-8")
    return len(rows)


@dataclass(frozen=True)
class Agreement:
    """How the scores by hand and the executed ones of a layer agree (percentage points; None: cannot be told)."""

    number: int
    by_hand: float
    executed: float
    difference: float  # mean, absolute
    near: float  # percent of the pairs within NEAR points
    correlation: float | None


def read_sheet(file: Path) -> dict[str, Agreement]:
    """The agreement per layer and of SQ (the mean over the rated layers); raises BenchmarkError."""
    try:
        rows = yaml.safe_load(file.read_text(encoding="utf-8"))
        executed = json.loads(_beside(file).read_text(encoding="utf-8"))
    except OSError as error:
        raise BenchmarkError(f"{error.filename} cannot be read: {error.strerror}") from None
    except (yaml.YAMLError, ValueError) as error:
        raise BenchmarkError(f"{file} is no sheet as `c2s bench rate` writes it: {error}") from None
    pairs: dict[str, list[tuple[float, float]]] = {layer: [] for layer in (*LAYERS, "SQ")}
    for row in rows or ():
        rated = _scores(row, executed, file)
        for layer, value in rated.items():
            pairs[layer].append((value, executed[row["id"]][layer]))
        if rated:
            pairs["SQ"].append((mean(rated.values()), mean(executed[row["id"]][x] for x in rated)))
    if not pairs["SQ"]:
        raise BenchmarkError(f"no score is filled in yet in {file}")
    return {layer: _agreement(values) for layer, values in pairs.items() if values}


def markdown(agreements: Mapping[str, Agreement]) -> str:
    """The agreement as a table."""
    lines = [
        f"| Layer | Rated | By hand % | Executed % | Mean difference | Within {NEAR:.0f} points % | Correlation |",
        "| --- |" + " ---: |" * 6,
    ]
    for layer, a in agreements.items():
        told = "-" if a.correlation is None else f"{a.correlation:.2f}"
        figures = f"{a.by_hand:.1f} | {a.executed:.1f} | {a.difference:.1f} | {a.near:.0f} | {told}"
        lines.append(f"| {layer} | {a.number} | {figures} |")
    return "\n".join(lines)


def _scores(row: Any, executed: Mapping[str, Any], file: Path) -> dict[str, float]:
    if not isinstance(row, dict) or row.get("id") not in executed:
        raise BenchmarkError(f"{file}: {row.get('id') if isinstance(row, dict) else row!r} was not on the sheet")
    found = {}
    for layer, value in (row.get("scores") or {}).items():
        if value is None:
            continue
        if layer not in executed[row["id"]]:
            raise BenchmarkError(f"{file}: {row['id']}: the text says nothing about {layer}, so it has no score")
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= 100:
            raise BenchmarkError(f"{file}: {row['id']}: {layer} must be a number from 0 to 100, is {value!r}")
        found[layer] = float(value)
    return found


def _agreement(pairs: Sequence[tuple[float, float]]) -> Agreement:
    hand, ours = [a for a, _ in pairs], [b for _, b in pairs]
    gaps = [abs(a - b) for a, b in pairs]
    try:
        related = correlation(hand, ours)
    except StatisticsError:
        related = None
    near = 100.0 * sum(g <= NEAR for g in gaps) / len(gaps)
    return Agreement(len(pairs), mean(hand), mean(ours), mean(gaps), near, related)


def _beside(file: Path) -> Path:
    return file.with_name(file.name + ".executed.json")


def _clean(text: str) -> str:
    """Without blanks at the ends of lines, which YAML cannot show as a block, and empty lines around."""
    return "\n".join(line.rstrip() for line in text.replace("\t", "    ").splitlines()).strip("\n")
