"""`c2s interpret` and `c2s import`: texts and programs to S."""

import asyncio
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.table import Table
from rich.text import Text

from c2s_engine.commands import show
from c2s_engine.commands.console import OK, dump, err, out, sentences, work
from c2s_engine.commands.reading import read_program, read_text
from c2s_engine.structure.account import account
from c2s_engine.structure.components import Unmet
from c2s_engine.structure.progress import Progress, Say

if TYPE_CHECKING:
    from c2s_engine.api import Engine
    from c2s_engine.check.protocol import ImportResult
    from c2s_engine.interpret.learned import Read

Json = Annotated[bool, typer.Option("--json", help="Print one JSON object.")]


def interpret(
    text: Annotated[str | None, typer.Argument(help="The description, or - for standard input.")] = None,
    file: Annotated[Path | None, typer.Option("--file", "-f", help="Read it from a .txt, .md or .pdf file.")] = None,
    explain: Annotated[
        bool, typer.Option("--explain", help="Show the model's answer, how sure it is, and what each field rests on.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Interpret a description: what S it gives, and why. No program is written."""
    with sentences(as_json):
        from c2s_engine.api import Engine
        from c2s_engine.config import load_settings

        description = read_text(text, file)
        engine = Engine(load_settings())
        reading = f"reading {len(description):,} characters"
        with err.status(reading) if err.is_terminal and not as_json else nullcontext():
            read, idle = asyncio.run(_read(engine, description))
            structure, stages = read.structure, _stages(read) if explain or as_json else {}
    if as_json:
        told = [c.model_dump(mode="json") for c in account(structure, idle)]
        dump({"structure": structure.model_dump(mode="json"), "account": told, "stages": stages,
              "without_effect": [u.model_dump(mode="json") for u in idle]})  # fmt: skip
        raise typer.Exit(OK)
    if explain:
        for stage, results in stages.items():
            out.print(Text(stage, style="bold"))
            table = Table(show_header=False, box=None, pad_edge=False)
            for entry in results:
                table.add_row("  ", Text(", ".join(f"{k}: {v}" for k, v in entry.items())))
            out.print(table)
    show.structure(structure)
    show.without_effect(idle)
    for c in structure.components:
        out.print(Text(f"{c.id} {c.spec.model_dump_json(exclude_defaults=True)}", style="dim"))


def said(event: Progress) -> None:
    """Print what is to be said of a reading."""
    if isinstance(event, Say):
        err.print(Text(event.text, style="yellow"))


async def _read(engine: "Engine", text: str) -> tuple["Read", tuple[Unmet, ...]]:
    """What is read of a text, and the phrases of it that nothing in S says."""
    found = await engine.reading(text, said)
    return found, await engine.without_effect(text, found.structure)


def _stages(read: "Read") -> dict[str, list[dict[str, Any]]]:
    """How S came of the text: the model's answer with how sure it is of each field, the settings that were found by
    table, and the words that the fields rest on."""
    from c2s_engine.interpret.learned.certainty import certainties
    from c2s_engine.interpret.settings import detect

    text, sure = read.structure.text, certainties(read.answer)
    return {
        "answer": [{"line": line} for line in read.answer.text.splitlines()],
        "certainty": [{"field": f"{cid}.{path}", "likely": round(p, 3)} for (cid, path), p in sure.items()],
        "settings": [{"field": f"{cid}.{path}", "value": f.value, "span": f.span, "text": text[slice(*f.span)]}
                     for cid, path, f in detect(text).found()],
        "links": [{"field": f"{c.id}.{li.field}".rstrip("."), "span": li.span, "text": li.label}
                  for c in read.structure.components for li in c.links],
    }  # fmt: skip


def import_(
    file: Annotated[Path, typer.Argument(help="A Scenic driving program.")],
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the assembled program there.")] = None,
    as_json: Json = False,
) -> None:
    """Decompose any Scenic driving program into G, R, E, O1..N, T; assembled again it is the same, byte for byte."""
    with sentences(as_json):
        text = read_program(file)
    found: Any = work(_import(text, file), as_json)
    with sentences(as_json):
        from c2s_engine.structure.program import assemble

        program = assemble(found.structure)
        if output is not None:
            output.write_text(program.text, encoding="utf-8")
    if as_json:
        dump({
            "structure": found.structure.model_dump(mode="json"),
            "source_map": [s.model_dump(mode="json") for s in program.spans],
            "upgraded": found.upgraded is not None,
            "diff": found.diff,
        })  # fmt: skip
        raise typer.Exit(OK)
    if found.diff:
        err.print(Text("upgraded from Scenic 2:", style="yellow"))
        typer.echo(found.diff, err=True)  # as it is: wrapped or without its tabs it could not be applied
    show.structure(found.structure)


async def _import(text: str, file: Path) -> Any:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    async with Engine(load_settings()) as engine:
        found, own = await imported(engine, text, file)
    if own:
        err.print(Text(f"Components as in {own}.", style="dim"))
    return found


async def imported(engine: "Engine", text: str, file: Path) -> tuple["ImportResult", str]:
    """The program in components, and the name of the S that they are from: the one that was saved with the program,
    where that is its own; else none."""
    from c2s_engine.check.protocol import ImportResult
    from c2s_engine.saving import beside, followed, taken
    from c2s_engine.structure.program import assemble

    if edits := taken(file, text):
        structure = await followed(engine, edits)
        if assemble(structure).text == text:
            return ImportResult(structure=structure), beside(file).name
    return await engine.check_client.import_program(text, file.name), ""
