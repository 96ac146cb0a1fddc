"""What `c2s bench judge` does."""

import asyncio
from pathlib import Path

from c2s_bench.judging.sheets import materials, write_dossiers
from c2s_bench.judging.verdicts import read, table
from c2s_bench.records import BenchmarkError
from c2s_engine.report.gather import read_records
from c2s_engine.report.material import Material, ReportError
from c2s_engine.require import whole


def write_for_judges(
    records: Path, out: Path, *, blind: bool, method: str, model: str | None, seed: int
) -> str:
    """Dossiers of all texts in a file; a sentence on what was written. Raises BenchmarkError."""
    if not records.is_file():
        raise BenchmarkError(f"There is no file {records}: check the name.")
    try:
        told = read_records(records)
    except ReportError as error:
        raise BenchmarkError(str(error)) from None
    made = asyncio.run(write_dossiers(told, out, blind=blind, method=method, model=model, seed=seed))
    broken = [m.id for m in made if m.problem]
    without = f"; {len(broken)} did not run: {', '.join(broken)}" if broken else ""
    return f"{len(made)} dossiers in {out}{without}. Judges write verdict-NAME.yaml beside each report."


def read_verdicts(folder: Path) -> str:
    """What the verdicts in a folder say, beside the requirements on the very runs that were judged."""
    runs = {m.id: m for m in materials(folder)}
    verdicts = read(folder, list(runs))
    return table(verdicts, {i: all_hold(m) for i, m in runs.items()})


def all_hold(material: Material) -> bool:
    """Whether all requirements of S hold in the run that was judged; False where there was no whole run."""
    return not material.problem and whole(material.results)
