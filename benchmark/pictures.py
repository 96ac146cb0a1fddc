"""Top-down pictures in text of programs, for the sheet that people rate."""

import asyncio
from collections.abc import Sequence

from c2s_bench.records import BenchmarkError
from c2s_bench.results import Result

COLUMNS, ROWS = 100, 30


def text_pictures(results: Sequence[Result], seed: int) -> dict[str, str]:
    """A picture of the first rollout of each program that ran, by the record's id."""
    return asyncio.run(_pictures([r for r in results if r.score.ran], seed))


async def _pictures(results: Sequence[Result], seed: int) -> dict[str, str]:
    from c2s_engine.api import Engine
    from c2s_engine.dryrun.picture import text_picture

    found = {}
    async with Engine() as engine:
        for result in results:
            report = await engine.check(
                result.program, upto="run", seed=seed, trajectories=True, folder=result.folder or None
            )
            if not report.trajectories:
                raise BenchmarkError(f"{result.id}: its program ran before, and does not now: run with --fresh")
            found[result.id] = text_picture(report.trajectories[0], columns=COLUMNS, rows=ROWS)
    return found
