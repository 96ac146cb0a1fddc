"""Running records under a setup with the progress shown, and scoring what comes."""

from collections.abc import Sequence

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from c2s_bench.host import REAL
from c2s_bench.records import BenchmarkError, Record
from c2s_bench.results import Result, result_of
from c2s_bench.runner import run
from c2s_bench.store import Store
from c2s_bench.tasks import Setup, tasks_for

EVERY = 20  # records after which a log that is no terminal gets a line


def execute(
    records: Sequence[Record],
    setup: Setup,
    *,
    jobs: int = 1,
    scheduler: str = "",
    fresh: bool = False,
    engine: str = "",
    store: Store | None = None,
) -> list[Result]:
    """The results in the order of the records; raises BenchmarkError where nothing at all could be run."""
    by_id = {r.id: r for r in records}
    results: dict[str, Result] = {}
    outcomes = run(
        tasks_for(records, setup), store or Store(), jobs=jobs, scheduler=scheduler, fresh=fresh, engine=engine or REAL
    )
    columns = (
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(),
        TextColumn("left"), TimeRemainingColumn(),
    )  # fmt: skip
    console = Console(stderr=True)
    with Progress(*columns, console=console, disable=not console.is_terminal) as bar:
        shown = bar.add_task(setup.name, total=len(records))
        for outcome in outcomes:
            results[outcome.id] = result_of(by_id[outcome.id], outcome, setup.runs)
            bar.advance(shown)
            if not console.is_terminal and len(results) % EVERY == 0:
                console.print(f"{setup.name}: {len(results)} of {len(records)}", highlight=False)
    broken = [r.error for r in results.values() if r.error]
    if broken and len(broken) == len(results):
        raise BenchmarkError(f"no record could be run with {setup.name}: {broken[0]}")
    return [results[r.id] for r in records]
