"""A program run with many seeds: a row for each as soon as it is done, and a verdict."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.text import Text

from c2s_engine.commands import show
from c2s_engine.commands.console import OK, REFUSED, InputError, err, work
from c2s_engine.commands.reading import judged_by
from c2s_engine.session.seeds import numbers, verdict
from c2s_engine.structure.components import Structure
from c2s_engine.structure.measures import SeedResult
from c2s_engine.structure.program import Program


def chosen_seeds(text: str | None, first: int) -> list[int]:
    """The seeds that an option means; none where it is not given. Raises InputError."""
    try:
        return numbers(text, first) if text is not None else []
    except ValueError as error:
        raise InputError(str(error)) from None


def series(
    structure: Structure | None, program: Program | str, chosen: Sequence[int], as_json: bool,
    file: Path | None = None, **options: Any,
) -> tuple[int, dict[str, Any]]:  # fmt: skip
    """Run them, and show each unless JSON is asked for; the exit code and all of it as data. A file's S is the one that
    was saved with it, else recognised in it."""
    rows: list[SeedResult] = work(_rows(structure, program, chosen, as_json, file, options), as_json)
    if not as_json:
        show.seeds(rows)
    passed = [r.passed for r in rows]
    shown = [{**r.model_dump(mode="json"), "passed": r.passed} for r in rows]
    data = {"ok": all(passed), "passed": sum(passed), "of": len(rows), "verdict": verdict(rows), "seeds": shown}
    return OK if all(passed) else REFUSED, data


async def _rows(
    structure: Structure | None, program: Program | str, chosen: Sequence[int], quiet: bool, file: Path | None,
    options: dict[str, Any],
) -> list[SeedResult]:  # fmt: skip
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    rows = []
    async with Engine(load_settings()) as engine:
        if file is not None:
            options = {**options, "folder": str(file.resolve().parent), "filename": file.name}
            structure, program, words = await judged_by(engine, str(program), file)
            if words and not quiet:
                err.print(Text(words, style="dim"))
        async for row in engine.seeds(structure, program, chosen, **options):  # type: ignore[arg-type]
            rows.append(row)
            if not quiet:
                show.seed(row)
    return rows
