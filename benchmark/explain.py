"""One record's atoms, one by one: what held, how often, and what did not."""

from c2s_bench.atoms import LAYERS
from c2s_bench.records import Record
from c2s_bench.results import Result


def explain(record: Record, result: Result) -> str:
    """The text, the verdict, every atom with the share of rollouts in which it held, and the program."""
    figures = ", ".join(f"{k} {v:.0f}" for k, v in result.score.layers.items() if v is not None)
    lines = [f"{record.id} ({record.source}, {record.reference})", record.text, ""]
    lines.append(f"ran, SQ {result.score.sq:.1f} ({figures})" if result.score.ran else f"did not run: {result.reason}")
    for layer in LAYERS:
        for atom in result.score.atoms:
            if atom.layer == layer:
                mark = "left out" if atom.excluded else "holds" if atom.holds else "FAILS"
                why = f" ({atom.excluded})" if atom.excluded else ""
                lines.append(f"  {layer}  {mark:<8} {100 * atom.share:3.0f} %  {atom.atom}{why}")
    return "\n".join([*lines, "", result.program.rstrip() or "(no program)"])
