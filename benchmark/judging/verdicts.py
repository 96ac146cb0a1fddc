"""Reading verdicts, and what they say together."""

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from pathlib import Path
from statistics import mean
from typing import Any, Literal

import yaml
from pydantic import BaseModel, ConfigDict, Field, ValidationError, field_validator

from c2s_bench.records import BenchmarkError

LAYERS = ("road", "infrastructure", "environment", "actors", "placement", "behaviour", "order", "outcome", "realism")
Layer = Literal[
    "road", "infrastructure", "environment", "actors", "placement", "behaviour", "order", "outcome", "realism"
]
Choice = Literal["yes", "minor", "no"]
CHOICES: tuple[Choice, ...] = ("yes", "minor", "no")


class Fault(BaseModel):
    model_config = ConfigDict(frozen=True)

    layer: Layer
    what: str = ""


class Verdict(BaseModel):
    """One judge's verdict on one scenario."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    id: str
    judge: str = Field(min_length=1)
    verdict: Choice
    faults: tuple[Fault, ...] = ()
    readability: int | None = Field(None, ge=1, le=5)
    loss_said: bool | None = None

    @field_validator("verdict", mode="before")
    @classmethod
    def _word(cls, value: Any) -> Any:
        """YAML reads a bare yes or no as a truth value."""
        return {True: "yes", False: "no"}[value] if isinstance(value, bool) else value

    @field_validator("faults", mode="before")
    @classmethod
    def _listed(cls, value: Any) -> Any:
        return value or ()


def read(folder: Path, known: Sequence[str]) -> list[Verdict]:
    """Every `verdict*.yaml` below a folder: one verdict or a list of them, of the scenario named in `id` or by the
    nearest folder. Raises BenchmarkError naming each that cannot be read."""
    found: list[Verdict] = []
    problems: list[str] = []
    for file in sorted(folder.rglob("verdict*.yaml")):
        for number, item in enumerate(_items(file, problems), 1):
            where = f"{file.relative_to(folder)}" + (f", entry {number}" if number > 1 else "")
            try:
                found.append(_verdict(item, file, known))
            except (ValidationError, ValueError) as error:
                problems.append(f"{where}: {_sentence(error)}")
    twice = [k for k, n in Counter((v.id, v.judge) for v in found).items() if n > 1]
    problems += [f"{identity}: {judge} judged it twice" for identity, judge in twice]
    if problems:
        raise BenchmarkError("Verdicts that cannot be used:\n" + "\n".join(f"- {p}" for p in problems))
    if not found:
        raise BenchmarkError(f"There is no verdict below {folder}: judges write verdict-NAME.yaml beside each report.")
    return found


def _items(file: Path, problems: list[str]) -> list[Any]:
    try:
        content = yaml.safe_load(file.read_text("utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        problems.append(f"{file}: no YAML: {' '.join(str(error).split())}")
        return []
    return content if isinstance(content, list) else [content]


def _verdict(item: Any, file: Path, known: Sequence[str]) -> Verdict:
    if not isinstance(item, dict):
        raise ValueError("must be a map with judge, verdict, faults, readability, loss_said")
    above = next((p.name for p in file.parents if p.name in known), "")
    verdict = Verdict.model_validate({"id": above, "judge": _named(file), **item})
    if verdict.id not in known:
        raise ValueError(f"there is no scenario {verdict.id!r}: put it into its folder, or name it in `id`")
    return verdict


def _named(file: Path) -> str:
    """The judge by the file's name, where the file does not say."""
    return file.stem.removeprefix("verdict").strip("-_.")


def _sentence(error: Exception) -> str:
    if isinstance(error, ValidationError):
        return "; ".join(f"{'.'.join(map(str, e['loc']))}: {e['msg']}" for e in error.errors())
    return str(error)


def kappa(pairs: Sequence[tuple[str, str]]) -> float | None:
    """Cohen's kappa of pairs of verdicts; None where chance alone would agree wholly."""
    if not pairs:
        return None
    agreed = mean(a == b for a, b in pairs)
    first, second = Counter(a for a, _ in pairs), Counter(b for _, b in pairs)
    chance = sum(first[c] * second[c] for c in first) / len(pairs) ** 2
    return None if chance == 1 else (agreed - chance) / (1 - chance)


def judged_pairs(verdicts: Sequence[Verdict]) -> list[tuple[Verdict, Verdict]]:
    """Every two verdicts on one scenario, judges in the order of their names."""
    by_id: dict[str, list[Verdict]] = defaultdict(list)
    for verdict in sorted(verdicts, key=lambda v: v.judge):
        by_id[verdict.id].append(verdict)
    return [pair for group in by_id.values() for pair in combinations(group, 2)]


def table(verdicts: Sequence[Verdict], whole: Mapping[str, bool | None]) -> str:
    """What the verdicts say, as Markdown. `whole`: whether all requirements hold, None where that cannot be said."""
    return "\n\n".join([*_counts(verdicts), *_faults(verdicts), *_agreement(verdicts), *_requirements(verdicts, whole)])


def _counts(verdicts: Sequence[Verdict]) -> Iterator[str]:
    judges = sorted({v.judge for v in verdicts})
    lines = ["| judge | scenarios | yes | minor | no | readability | loss said |", "| --- " * 7 + "|"]
    for judge in [*judges, ""]:
        own = [v for v in verdicts if judge in ("", v.judge)]
        count = Counter(v.verdict for v in own)
        readable = [v.readability for v in own if v.readability is not None]
        said = [v.loss_said for v in own if v.loss_said is not None]
        cells = [
            judge or "**all**", str(len(own)), *(str(count[c]) for c in CHOICES),
            f"{mean(readable):.2f}" if readable else "-", f"{mean(said):.0%}" if said else "-",
        ]  # fmt: skip
        lines.append(f"| {' | '.join(cells)} |")
    yield "\n".join(lines)
    by_id = {i: [v.verdict for v in verdicts if v.id == i] for i in sorted({v.id for v in verdicts})}
    agreed = {c: [i for i, given in by_id.items() if set(given) == {c}] for c in CHOICES}
    split = [i for i, given in by_id.items() if len(set(given)) > 1]
    named = [f"- {c} by every judge: {len(ids)}: {', '.join(ids) or '-'}" for c, ids in agreed.items()]
    named.append(f"- judges differ: {len(split)}: {', '.join(split) or '-'}")
    yield "\n".join([f"Of {len(by_id)} scenarios:", "", *named])


def _faults(verdicts: Sequence[Verdict]) -> Iterator[str]:
    lines = ["| layer | faults | scenarios | ids |", "| --- " * 4 + "|"]
    for layer in LAYERS:
        having = [(v.id, f) for v in verdicts for f in v.faults if f.layer == layer]
        ids = sorted({i for i, _ in having})
        if having:
            lines.append(f"| {layer} | {len(having)} | {len(ids)} | {', '.join(ids)} |")
    yield "\n".join(lines)


def _agreement(verdicts: Sequence[Verdict]) -> Iterator[str]:
    found = [(a.verdict, b.verdict) for a, b in judged_pairs(verdicts)]
    if not found:
        yield "Agreement between judges: no scenario has two verdicts."
        return
    accepted = [("yes" if a == "yes" else "-", "yes" if b == "yes" else "-") for a, b in found]
    lines = [
        f"- {what}: {mean(a == b for a, b in pairs):.0%} of {len(pairs)}, kappa {_figure(kappa(pairs))}"
        for what, pairs in (("yes / minor / no", found), ("yes or not", accepted))
    ]
    yield "\n".join(["Agreement between two judges of a scenario:", "", *lines])


def _figure(value: float | None) -> str:
    return "undefined" if value is None else f"{value:.2f}"


def _requirements(verdicts: Sequence[Verdict], whole: Mapping[str, bool | None]) -> Iterator[str]:
    told = [(whole.get(v.id), v.verdict == "yes") for v in verdicts]
    counted = Counter((w, y) for w, y in told if w is not None)
    total = sum(counted.values())
    if not total:
        return
    same = counted[True, True] + counted[False, False]
    yield (
        f"“All requirements hold” agrees with “yes” in {same / total:.0%} of {total} verdicts: both "
        f"{counted[True, True]}, neither {counted[False, False]}, requirements alone {counted[True, False]}, judge "
        f"alone {counted[False, True]}."
    )
