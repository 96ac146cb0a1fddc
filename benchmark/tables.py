"""The paper's tables in Markdown, ours and theirs."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from c2s_bench.paper import paper
from c2s_bench.results import Result, classes, grouped, kinds, label_of, parts, share_of, total_of
from c2s_bench.scorer import Totals

COLUMNS = ("CSR", "RT", "tokens", "RL", "TI", "TM", "DO", "EN", "SQ", "FA")
HEADS = {"CSR": "CSR %", "RT": "RT s", "tokens": "Tokens", "RL": "RL %", "TI": "TI %", "TM": "TM %", "DO": "DO %",
         "EN": "EN %", "SQ": "SQ %", "FA": "FA %"}  # fmt: skip
PART_NAMES = {"dev": "Development part", "test": "Reporting part"}
LEGEND = (
    "CSR: programs that compile, sample and run; RT: time from text to program; RL, TI, TM, DO, EN: road, "
    "infrastructure, temporary, objects, environment; SQ: their mean, over the programs that ran; FA = CSR x SQ."
)
THEIRS = (
    "The paper's figures are its own, measured otherwise: its programs ran in CARLA and people scored the layers; "
    "ours are decided by the dry run."
)


def by_source(results: Sequence[Result]) -> str:
    """Rows: each source, the two parts, all."""
    rows = {source: total_of(group) for source, group in grouped(results).items()}
    rows |= {PART_NAMES[part]: total_of(group) for part, group in parts(results).items()}
    rows["**Total**"] = total_of(results)
    lines = _head(["Source", "Number"])
    lines += [_line([name, str(row.number)], _figures(row)) for name, row in rows.items()]
    excluded = rows["**Total**"].excluded
    note = f" Left out: {excluded} atom{'s' if excluded != 1 else ''} about snow." if excluded else ""
    if (share := share_of(results)) is not None:
        note += f" No fallback stands in for {100 * share:.0f} % of the components."
    return "\n".join([*lines, "", LEGEND + note])


def by_kind(results: Sequence[Result]) -> str:
    """What holds and what fails, by kind of atom."""
    lines = ["| Layer | Atom | Holds | Of | % |", "| --- | --- | ---: | ---: | ---: |"]
    for label, (held, number) in kinds(results).items():
        layer, _, kind = label.partition(" ")
        lines.append(f"| {layer} | {kind} | {held} | {number} | {100 * held / number:.0f} |")
    return "\n".join(lines)


def requirements(results: Sequence[Result]) -> str:
    """How many scenarios are whole (all that S requires was seen), and what holds by class of requirement."""
    number, of_all = sum(r.whole for r in results), len(results)
    lines = [f"Whole: {number} of {of_all} ({100 * number / max(1, of_all):.0f} %) showed all that S requires."]
    lines += ["", "| Requirement | Holds | Of | % | Not judged |", "| --- | ---: | ---: | ---: | ---: |"]
    for kind, (held, of, open_) in classes(results).items():
        lines.append(f"| {kind} | {held} | {of} | {100 * held / of:.0f} | {open_} |")
    return "\n".join(lines)


def failing(results: Sequence[Result], reveal: bool) -> str:
    """Every atom that fails, by kind, with its record; those of the reporting part only when revealed."""
    found: dict[str, list[str]] = {}
    for result in results:
        for atom in result.score.atoms if result.score.ran and (reveal or not result.withheld) else ():
            if atom.counts and not atom.holds:
                found.setdefault(label_of(atom), []).append(f"- {result.id}: {atom.atom} ({100 * atom.share:.0f} %)")
    ordered = sorted(found.items(), key=lambda kv: (-len(kv[1]), kv[0]))
    return "\n".join(line for label, lines in ordered for line in (f"{label} ({len(lines)})", *lines, ""))


def models(rows: Mapping[str, Totals], with_paper: bool = True) -> str:
    """The paper's second table: a row a model or baseline."""
    lines = _head(["Model or method"])
    lines += [_line([name], _figures(row)) for name, row in rows.items()]
    if with_paper:
        for tier in paper()["models"]:
            lines.append(_line([f"*Paper: {tier['tier']}*"], [""] * len(COLUMNS)))
            lines += [_line([name], map(_number, COLUMNS, row)) for name, row in tier["rows"].items()]
    return "\n".join([*lines, "", LEGEND, *([THEIRS] if with_paper else [])])


def ablation(rows: Mapping[str, Totals], with_paper: bool = True) -> str:
    """The paper's first table: configurations C1 to C12, in tiers."""
    techniques = paper()["techniques"]
    lines = _head(["ID", *techniques])
    for tier in paper()["ablation"]:
        lines.append(_line([f"*{tier['tier']}*", *[""] * len(techniques)], [""] * len(COLUMNS)))
        for name, theirs in tier["rows"].items():
            marks = ["yes" if t in theirs["uses"] else "-" for t in techniques]
            if name in rows:
                lines.append(_line([name, *marks], _figures(rows[name])))
            if with_paper:
                label = f"{name} (paper)"
                lines.append(_line([label, *marks], map(_number, COLUMNS, theirs["figures"])))
    return "\n".join([*lines, "", LEGEND, *([THEIRS] if with_paper else [])])


def _head(first: list[str]) -> list[str]:
    names = [*first, *(HEADS[c] for c in COLUMNS)]
    return ["| " + " | ".join(names) + " |", "| --- |" + " ---: |" * (len(names) - 1)]


def _line(first: Iterable[str], figures: Iterable[str]) -> str:
    return "| " + " | ".join([*first, *figures]) + " |"


def _figures(row: Totals) -> list[str]:
    values = row.as_dict()
    return [_number(c, values[c]) for c in COLUMNS]


def _number(column: str, value: Any) -> str:
    if value is None:
        return "-"
    return f"{value:.0f}" if column == "tokens" else f"{value:.2f}"
