"""`c2s report`: the dossier of a program, a session or a file of texts."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.text import Text

from c2s_engine.commands.console import BAD_INPUT, OK, REFUSED, err, fail, out, sentences, work
from c2s_engine.commands.reading import read_program
from c2s_engine.report.material import Material, ReportError

if TYPE_CHECKING:
    from c2s_engine.api import Engine

FORMATS = ("md", "html", "json")


def report(
    what: Annotated[
        str,
        typer.Argument(
            metavar="PROGRAM|SESSION|RECORDS",
            help="A .scenic file, a session's name, or a YAML list of maps with id and text.",
        ),
    ],  # noqa: E501
    output: Annotated[Path, typer.Option("--output", "-o", help="The folder to write to.")] = Path("report"),
    form: Annotated[str, typer.Option("--format", help="md, html or json.")] = "md",
    method: Annotated[str | None, typer.Option(help="RECORDS: how texts are turned into programs.")] = None,
    seed: Annotated[int, typer.Option(help="The seed of the sampled scene.")] = 0,
    drivers: Annotated[
        bool, typer.Option("--drivers", help="RECORDS: run it with two other drivers in ego's place, too.")
    ] = False,
) -> None:
    """Write the dossier: what was said, what became of it, what the run shows in pictures and numbers, the program."""
    with sentences():
        if form not in FORMATS:
            fail(f"There is no format {form}: say md, html or json.", BAD_INPUT)
        made = work(_work(what, output, form, method, seed, drivers))
    for material, file in made:
        out.print(Text(f"{file}{'  ' + material.problem if material.problem else ''}"), soft_wrap=True)
    raise typer.Exit(REFUSED if any(m.problem for m, _ in made) else OK)


async def _work(
    what: str, output: Path, form: str, method: str | None, seed: int, drivers: bool
) -> list[tuple[Material, Path]]:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    async with Engine(load_settings()) as engine:
        return await dossiers(engine, what, output, form, method, seed, _tell, drivers)


def _tell(at: str) -> None:
    err.print(Text(at, style="dim"))


async def dossiers(
    engine: "Engine", what: str, output: Path, form: str, method: str | None, seed: int, tell: Callable[[str], Any],
    drivers: bool = False,
) -> list[tuple[Material, Path]]:
    """The dossiers of a program, a session or a file of texts, written; `tell` is told which text it is at.

    Raises ReportError, SessionError, CheckError, InputError and OSError.
    """
    from c2s_engine.report import gather
    from c2s_engine.report.writing import write

    file = Path(what)
    made: list[tuple[Material, Path]] = []
    records = file.suffix.lower() in (".yaml", ".yml")
    if records and not file.is_file():
        raise ReportError(f"There is no file {file}: check the name.")
    told = gather.read_records(file) if records else []
    for number, record in enumerate(told, 1):
        tell(f"{number}/{len(told)} {record.id}")
        material = await gather.of_text(engine, record, method=method, seed=seed, drivers=drivers)
        made.append((material, write(material, output / record.id, form)))  # type: ignore[arg-type]
    if not records:
        if file.is_file() or file.suffix == ".scenic":
            material = await gather.of_program(engine, file, read_program(file), seed=seed)
        else:
            material = await gather.of_session(engine, what, seed=seed)
        made.append((material, write(material, output, form)))  # type: ignore[arg-type]
    return made
