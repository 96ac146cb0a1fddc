"""`c2s maps`, `c2s doctor`, `c2s glossary`, `c2s gallery`."""

from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.table import Table
from rich.text import Text

from c2s_engine.commands.console import OK, REFUSED, InputError, dump, out, sentences, work

if TYPE_CHECKING:
    from c2s_engine.api import Engine

Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]


def maps(
    name: Annotated[str | None, typer.Argument(help="A map by name or .xodr path: count its places.")] = None,
    as_json: Json = False,
) -> None:
    """List the maps at hand, and how many places of each kind they have."""
    found = work(_maps(name), as_json)
    if as_json:
        dump(found)
        raise typer.Exit(OK)
    table = Table("map", "places", "file", box=None, pad_edge=False)
    for entry in found:
        counts = ", ".join(f"{n} {kind}" for kind, n in entry["places"].items() if n)
        why = Text(entry["error"], style="red") if "error" in entry else Text(counts or "-")
        table.add_row(Text(entry["name"]), why, Text(entry["path"]))
    out.print(table)


async def _maps(name: str | None) -> list[dict[str, Any]]:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    async with Engine(load_settings()) as engine:
        if name:
            return [await _counted(engine, name)]
        return [await _counted_or_why(engine, known) for known in engine.library.names()]


async def _counted(engine: "Engine", name: str) -> dict[str, Any]:
    found = engine.library.find(name)
    places = await engine.survey(found)
    return {"name": found.name, "path": str(found.path), "carla_map": found.carla_map, "places": places}


async def _counted_or_why(engine: "Engine", name: str) -> dict[str, Any]:
    """Of many maps, one that cannot be read must not take the others down."""
    from c2s_engine.check.client import CheckError

    try:
        return await _counted(engine, name)
    except (LookupError, ValueError, CheckError) as error:
        return {"name": name, "path": "", "carla_map": None, "places": {}, "error": str(error)}


def glossary(word: Annotated[str | None, typer.Argument(help="A term; without one, all of them.")] = None) -> None:
    """Say what the words of the app and the documents mean."""
    from c2s_engine.session.glossary import meaning, terms

    with sentences():
        said = meaning(word) if word else "\n".join(f"{name}: {text}" for name, text in terms().items())
        if not said:
            raise InputError(f"The glossary has no word {word!r}: it has {', '.join(terms())}.")
        out.print(Text(said))


def gallery(name: Annotated[str | None, typer.Argument(help="The example whose text to print.")] = None) -> None:
    """List ten examples to start from, or print the text of one: c2s generate "$(c2s gallery cut-in)"."""
    from c2s_engine.session.gallery import gallery as entries

    with sentences():
        if name is None:
            for label, example in entries().items():
                out.print(Text.assemble((f"{label:<14}", "bold"), example.about), soft_wrap=True)
            return
        if name not in entries():
            raise InputError(f"There is no example {name!r}: there are {', '.join(entries())}.")
        print(entries()[name].text)


def doctor(as_json: Json = False) -> None:
    """Say what is installed, reachable and missing, and what to do about it."""
    from c2s_engine.doctor import examine

    findings = work(examine(), as_json)
    if as_json:
        dump(findings)
    else:
        table = Table(show_header=False, box=None, pad_edge=False)
        for f in findings:
            mark = (
                Text("✓", style="green")
                if f["ok"]
                else Text("–" if f["optional"] else "✗", style="yellow" if f["optional"] else "red")
            )
            table.add_row(mark, Text(f["name"], style="bold"), Text(f["found"]), Text(f["advice"], style="dim"))
        out.print(table)
    raise typer.Exit(OK if all(f["ok"] or f["optional"] for f in findings) else REFUSED)
