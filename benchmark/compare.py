"""What changed between two results, by record and by atom."""

from collections.abc import Sequence

from c2s_bench import tables
from c2s_bench.results import Result, total_of


def compare(a: Sequence[Result], b: Sequence[Result], names: tuple[str, str], reveal: bool = False) -> str:
    """The totals of both, then each record that differs with the atoms that were gained (+) and lost (-)."""
    ours, theirs = {r.id: r for r in a}, {r.id: r for r in b}
    both = [i for i in ours if i in theirs]
    lines = [tables.models({n: total_of(rows) for n, rows in zip(names, (a, b), strict=True)}, with_paper=False)]
    lines += [
        "",
        f"{len(both)} records in both; {len(ours) - len(both)} only in A, {len(theirs) - len(both)} only in B",
    ]
    hidden = [0, 0]
    for identity in both:
        first, second = ours[identity], theirs[identity]
        change = second.score.fa - first.score.fa
        gained, lost = _atoms(first, second)
        if not (gained or lost or first.score.ran != second.score.ran):
            continue
        if second.withheld and not reveal:
            hidden[change < 0] += change != 0
            continue
        lines.append(f"{identity}: FA {first.score.fa:.1f} -> {second.score.fa:.1f}")
        if first.score.ran and not second.score.ran:
            lines.append(f"  no longer runs: {second.reason}")
        elif second.score.ran and not first.score.ran:
            lines.append(f"  now runs; before: {first.reason}")
        lines += [f"  + {text}" for text in gained] + [f"  - {text}" for text in lost]
    if any(hidden):
        lines.append(f"reporting part: {hidden[0]} records better, {hidden[1]} worse (--reveal names them)")
    return "\n".join(lines)


def _atoms(first: Result, second: Result) -> tuple[list[str], list[str]]:
    before = {(a.layer, a.atom): a.holds for a in first.score.atoms if a.counts}
    after = {(a.layer, a.atom): a.holds for a in second.score.atoms if a.counts}
    strays = {k for k in before.keys() ^ after.keys() if "nothing expects it" in k[1]}
    shared = before.keys() & after.keys()
    gained = [k for k in shared if after[k] and not before[k]] + [k for k in strays if k in before]
    lost = [k for k in shared if before[k] and not after[k]] + [k for k in strays if k in after]
    return [f"{layer} {text}" for layer, text in sorted(gained)], [f"{layer} {text}" for layer, text in sorted(lost)]
