"""`c2s calibrate`: the same manoeuvres in the dry run and in CARLA, and the differences."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any

import typer
from rich.table import Table
from rich.text import Text

from c2s_engine.calibrate.driving import Backend, Carla, DryRun, NotDriven
from c2s_engine.calibrate.manoeuvres import Manoeuvre, manoeuvres
from c2s_engine.commands.console import BAD_INPUT, OK, REFUSED, dump, err, fail, out, sentences, work
from c2s_engine.dryrun.carla import server_at
from c2s_engine.structure.program import Program

SIDES = {"dry_run": "dry run", "carla": "CARLA"}


def calibrate(
    address: Annotated[str, typer.Option(help="HOST:PORT of the CARLA server.")] = "127.0.0.1:2000",
    only: Annotated[list[str] | None, typer.Option(help="Only this manoeuvre; may be given several times.")] = None,
    dry: Annotated[bool, typer.Option("--dry", help="The dry run alone; no CARLA is needed.")] = False,
    map_name: Annotated[str, typer.Option("--map", help="The map to drive on: a name or a file.")] = "town",
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
) -> None:
    """Drive a dozen manoeuvres in the dry run and in CARLA, and print what of them comes out differently."""
    known = manoeuvres()
    if unknown := [name for name in only or () if name not in known]:
        fail(f"There is no manoeuvre {unknown[0]}: there are {', '.join(known)}.", BAD_INPUT, as_json)
    with sentences(as_json):
        server = None if dry else Carla(*server_at(address, "--dry"))
    chosen = [known[name] for name in only or known]
    rows: list[dict[str, Any]] = []
    try:
        work(_work(chosen, server, map_name, rows), as_json)
    except typer.Exit:  # what was driven by then is not lost
        if rows and not as_json:
            _print(rows, dry)
        raise
    failed = any("why" in row for row in rows)
    if as_json:
        dump({"ok": not failed, "map": map_name, "carla": None if dry else address, "rows": rows})
    else:
        _print(rows, dry)
    raise typer.Exit(REFUSED if failed else OK)


async def _work(chosen: list[Manoeuvre], server: Carla | None, map_name: str, rows: list[dict[str, Any]]) -> None:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings
    from c2s_engine.saving import save

    async with Engine(load_settings()) as engine:
        on = engine.library.find(map_name)
        sides: dict[str, Backend] = {"dry_run": DryRun(engine), **({"carla": server} if server else {})}
        with TemporaryDirectory() as folder:
            for number, manoeuvre in enumerate(chosen, 1):
                file = Path(folder) / f"{manoeuvre.name}.scenic"
                save(Program(text=manoeuvre.program(on)), [str(on.path.parent)], file, standalone=True)
                at = f"{number}/{len(chosen)} {manoeuvre.name}: {manoeuvre.about}"
                err.print(Text(at, style="dim"), soft_wrap=True)
                rows += await compared(manoeuvre, file, sides)


async def compared(manoeuvre: Manoeuvre, file: Path, sides: dict[str, Backend]) -> list[dict[str, Any]]:
    """A row for each of its measures: the values of each side, and the difference; `why` where one was not driven."""
    values: dict[str, list[float | None]] = {}
    why: dict[str, str] = {}
    for side, drive in sides.items():
        try:
            found = await drive(manoeuvre, file)
            values[side] = [m.of(found) for m in manoeuvre.measures]
        except NotDriven as error:
            values[side], why[side] = [None] * len(manoeuvre.measures), str(error)
    rows: list[dict[str, Any]] = []
    for k, measure in enumerate(manoeuvre.measures):
        row: dict[str, Any] = {"manoeuvre": manoeuvre.name, "measure": measure.description, "unit": measure.unit}
        given = {side: values[side][k] for side in sides}
        row |= {side: None if value is None else round(value, 3) for side, value in given.items()}
        here, there = given.get("dry_run"), given.get("carla")
        row["difference"] = None if here is None or there is None else round(there - here, 3)
        rows.append(row | ({"why": why} if why else {}))
    return rows


def _print(rows: list[dict[str, Any]], dry: bool) -> None:
    columns = ["dry_run"] if dry else [*SIDES, "difference"]
    table = Table("manoeuvre", "measure", "unit", box=None, pad_edge=False)
    for column in columns:
        table.add_column(SIDES.get(column, column), justify="right", no_wrap=True)
    last = None
    for row in rows:
        numbers = [_number(row[column], signed=column == "difference") for column in columns]
        table.add_row("" if row["manoeuvre"] == last else row["manoeuvre"], row["measure"], row["unit"], *numbers)
        last = row["manoeuvre"]
    out.print(table)
    where = SIDES | {"dry_run": "the dry run"}
    reasons = {(row["manoeuvre"], side): why for row in rows for side, why in row.get("why", {}).items()}
    for (name, side), why in reasons.items():
        out.print(Text(f"{name} was not driven in {where[side]}: {why}", style="red"), soft_wrap=True)


def _number(value: float | None, signed: bool) -> str:
    if value is None:
        return "-"
    return f"{round(value, 2) + 0.0:{'+' if signed else ''}.2f}"  # + 0.0: no -0.00
