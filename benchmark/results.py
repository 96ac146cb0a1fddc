"""Outcomes and scores together: what tables, JSON, comparison and the results file are made of."""

import hashlib
import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from c2s_bench.atoms import LAYERS
from c2s_bench.records import BenchmarkError, Record
from c2s_bench.scorer import AtomScore, RecordScore, Totals, score, totals
from c2s_bench.tasks import Outcome, Setup
from c2s_engine.paths import cache_folder
from c2s_engine.structure.facts import RunFacts

LONGEST_NAME = 120
"""Characters of a name of results that its file keeps."""


@dataclass(frozen=True)
class Result:
    """One record's score and cost."""

    part: str
    withheld: bool
    score: RecordScore
    seconds: float
    tokens: float
    program: str
    reason: str
    error: str
    first: RunFacts | None = None  # the first rollout that ran; not kept in files
    folder: str = ""  # where the program's map lies
    share: float | None = None  # of the components that no fallback stands in for, where a model was at work
    required: tuple[dict[str, Any], ...] = ()  # what S requires: id, kind, holds

    @property
    def whole(self) -> bool:
        """Whether it ran and showed all that S requires."""
        return self.score.ran and bool(self.required) and all(r["holds"] for r in self.required)

    @property
    def id(self) -> str:
        return self.score.id

    def as_dict(self) -> dict[str, Any]:
        """The figures of one record, percentages as numbers, under the names of the paper's columns."""
        s = self.score
        figures: dict[str, Any] = {"CSR": s.csr, "SQ": s.sq, "FA": s.fa, "RT": self.seconds, "tokens": self.tokens}
        own = {} if self.share is None else {"share": self.share}
        return {**figures, **own, **s.layers, "whole": self.whole, "reason": self.reason}


def result_of(record: Record, outcome: Outcome, runs: int) -> Result:
    """Score an outcome."""
    facts = outcome.run_facts()
    return Result(
        record.part,
        record.withheld,
        score(record, facts, runs),
        outcome.seconds,
        outcome.tokens,
        outcome.program,
        outcome.reason,
        outcome.error,
        next((f for f in facts if f.ran), None),
        outcome.folder,
        outcome.share,
        outcome.required,
    )


def total_of(results: Sequence[Result]) -> Totals:
    return totals([r.score for r in results], [r.seconds for r in results], [r.tokens for r in results])


def share_of(results: Iterable[Result]) -> float | None:
    """The mean share of components that no fallback stands in for, over the records that a model worked on."""
    shares = [r.share for r in results if r.share is not None]
    return sum(shares) / len(shares) if shares else None


def grouped(results: Sequence[Result]) -> dict[str, Sequence[Result]]:
    """By source, in the order of the results."""
    groups: dict[str, list[Result]] = {}
    for result in results:
        groups.setdefault(result.score.source, []).append(result)
    return {**groups}


def parts(results: Sequence[Result]) -> dict[str, Sequence[Result]]:
    """The development and the reporting part, where both are there."""
    found = {p: [r for r in results if r.part == p] for p in ("dev", "test")}
    return {p: rows for p, rows in found.items() if rows and len(rows) < len(results)}


def kinds(results: Iterable[Result]) -> dict[str, tuple[int, int]]:
    """By kind of atom (events by their name): how many hold, of how many, over the programs that ran."""
    counted: dict[str, tuple[int, int]] = {}
    for result in results:
        for atom in result.score.atoms if result.score.ran else ():
            if atom.counts:
                label = label_of(atom)
                held, number = counted.get(label, (0, 0))
                counted[label] = (held + atom.holds, number + 1)
    return dict(sorted(counted.items(), key=lambda kv: (LAYERS.index(kv[0][:2]), kv[1][0] - kv[1][1], kv[0])))


def classes(results: Iterable[Result]) -> dict[str, tuple[int, int, int]]:
    """By class of requirement: how many hold, of how many, and how many could not be judged, where the program ran."""
    counted: dict[str, tuple[int, int, int]] = {}
    for result in results:
        for required in result.required if result.score.ran else ():
            held, number, open_ = counted.get(required["kind"], (0, 0, 0))
            holds = required["holds"]
            counted[required["kind"]] = (held + (holds is True), number + 1, open_ + (holds is None))
    return dict(sorted(counted.items()))


def label_of(atom: AtomScore) -> str:
    """An atom's layer and kind; events and temporary things by their own name."""
    kind = atom.atom if atom.kind == "temporary" else atom.kind
    if atom.kind == "event":
        event = atom.atom.split(": ", 1)[1]
        kind = "any_of" if " or " in event else event.split()[0]
    return f"{atom.layer} {kind}"


def as_json(results: Sequence[Result], setup: Setup, reveal: bool) -> dict[str, Any]:
    """The whole result as one object; records of the reporting part appear by themselves only when revealed."""
    shown = [r for r in results if reveal or not r.withheld]
    return {
        "method": setup.method,
        "model": setup.model,
        "runs": setup.runs,
        "total": total_of(results).as_dict(),
        "by_part": {part: total_of(rows).as_dict() for part, rows in parts(results).items()},
        "by_source": {source: total_of(rows).as_dict() for source, rows in grouped(results).items()},
        "by_record": {r.id: r.as_dict() for r in shown},
        "by_kind": {kind: {"holds": held, "of": number} for kind, (held, number) in kinds(results).items()},
        "requirements": {
            "whole": sum(r.whole for r in results),
            "of": len(results),
            "by_class": {
                kind: {"holds": held, "of": number, "not_judged": open_}
                for kind, (held, number, open_) in classes(results).items()
            },
        },
        "withheld": len(results) - len(shown),
        **({} if (share := share_of(results)) is None else {"share": share}),
    }


def results_file(name: str) -> Path:
    """Where the last results under a name lie; a name too long for a file is cut and told by its digest."""
    plain = name.replace("/", "_").replace(":", "_")
    if len(plain) > LONGEST_NAME:
        plain = f"{plain[:LONGEST_NAME]}-{hashlib.sha256(plain.encode()).hexdigest()[:12]}"
    return cache_folder() / "bench" / "results" / f"{plain}.jsonl"


def save(results: Sequence[Result], file: Path) -> None:
    """Write results as JSON lines, atoms and programs included."""
    file.parent.mkdir(parents=True, exist_ok=True)
    lines = [json.dumps(_row(r), ensure_ascii=False) for r in results]
    part = file.with_name(file.name + ".part")
    part.write_text("\n".join([*lines, ""]), encoding="utf-8")
    part.replace(file)


def load_results(name: str) -> list[Result]:
    """The results of a JSON-lines file, or the last ones of a method."""
    file = Path(name) if Path(name).is_file() else results_file(name)
    try:
        return [_result(json.loads(line)) for line in file.read_text(encoding="utf-8").splitlines() if line]
    except OSError:
        raise BenchmarkError(
            f"there are no results of {name}: give a file of results, or run `c2s bench --method {name}` first"
        ) from None
    except (ValueError, KeyError, TypeError):
        raise BenchmarkError(f"{file} is no file of benchmark results") from None


def _row(result: Result) -> dict[str, Any]:
    return {
        "id": result.id, "source": result.score.source, "part": result.part, "withheld": result.withheld,
        **result.as_dict(), "ran": result.score.ran, "error": result.error, "program": result.program,
        "atoms": [asdict(a) for a in result.score.atoms], "required": list(result.required),
    }  # fmt: skip


def _result(row: dict[str, Any]) -> Result:
    atoms = tuple(AtomScore(**a) for a in row["atoms"])
    scored = RecordScore(row["id"], row["source"], row["ran"], {x: row[x] for x in LAYERS}, row["SQ"], atoms)
    return Result(
        row["part"], row["withheld"], scored, row["RT"], row["tokens"], row["program"], row["reason"], row["error"],
        share=row.get("share"), required=tuple(row.get("required", ())),
    )  # fmt: skip
