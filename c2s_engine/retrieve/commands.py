"""`c2s search` and `c2s index ...`: mounted by the CLI (`search_command` as a command, `app` as a sub-app)."""

import asyncio
import contextlib
import json
from collections.abc import Awaitable, Callable, Iterator
from typing import Annotated, Any, Literal

import typer
from rich.console import Console
from rich.panel import Panel
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn
from rich.syntax import Syntax
from rich.table import Table
from rich.text import Text

from c2s_engine.config import ConfigError, load_settings
from c2s_engine.retrieve.client import Decompose, Describe, RetrievalClient
from c2s_engine.retrieve.errors import RetrievalError
from c2s_engine.retrieve.provenance import attribution
from c2s_engine.structure.progress import Passage

NOTHING, FAILED = 1, 2  # exit codes: no answer (or findings), an error
app = typer.Typer(help="The index of snippets and documents.", no_args_is_help=True)
Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]

Parts = tuple[Decompose, Describe | None]
decomposer: list[Callable[[], contextlib.AbstractAsyncContextManager[Parts]]] = []
"""The CLI appends what gives `program -> S` and, where there is a model, `(component, code) -> sentence`, so that
`index add` takes .scenic files apart into snippets: the rooms of both are above this one."""


@contextlib.contextmanager
def _bar(quiet: bool) -> Iterator[Callable[[str, int, int], None]]:
    """A progress bar on stderr; `quiet` gives none."""
    if quiet:
        yield lambda stage, done, total: None
        return
    console = Console(stderr=True)
    columns = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("starting", total=None)
        yield lambda stage, done, total: bar.update(task, description=stage, completed=done, total=total)


def _run(work: Callable[[RetrievalClient], Awaitable[Any]], as_json: bool) -> Any:
    """Do something with a client; an error is one sentence on stderr and exit code 2."""

    async def with_client() -> Any:
        async with RetrievalClient(model=load_settings().embedding_model) as client:
            return await work(client)

    try:
        return asyncio.run(with_client())
    except (RetrievalError, ConfigError) as error:
        if as_json:
            typer.echo(json.dumps({"error": str(error)}))
        else:
            Console(stderr=True).print(Text(str(error), style="red"))
        raise typer.Exit(FAILED) from None
    except KeyboardInterrupt:
        raise typer.Exit(130) from None


def search_command(
    query: Annotated[str, typer.Argument(help="What to look for, in your words.")],
    kind: Annotated[Literal["doc", "snippet"], typer.Option(help="Documents or code snippets.")] = "doc",
    component: Annotated[str | None, typer.Option(help="Snippets of one component: R, E, O or T.")] = None,
    limit: Annotated[int, typer.Option(min=1, max=50, help="At most so many.")] = 5,
    all_: Annotated[bool, typer.Option("--all", help="Show the nearest even if nothing fits.")] = False,
    as_json: Json = False,
) -> None:
    """Search the documents or the snippets (exit code 1: nothing fits)."""
    if component:
        component, kind = component[:1].upper(), "snippet"
        if component not in "REOT":
            Console(stderr=True).print(Text(f"There are no snippets of {component}: say R, E, O or T.", style="red"))
            raise typer.Exit(FAILED)
    with _bar(as_json) as progress:
        found = _run(lambda c: c.search(query, kind, component, limit, abstain=not all_, progress=progress), as_json)
    if as_json:
        data = [{**p.model_dump(mode="json", exclude={"type"}), "whose": attribution(p)} for p in found]
        typer.echo(json.dumps(data, indent=1))
    elif not found:
        Console().print(Text("Nothing in the index answers this (--all shows the nearest)."))
    else:
        for number, passage in enumerate(found, 1):
            Console().print(_panel(number, passage))
    raise typer.Exit(0 if found else NOTHING)


def _panel(number: int, passage: Passage) -> Panel:
    ranks = ", ".join(f"{name} {rank}" for name, rank in passage.ranks.items())
    where = [passage.clause, attribution(passage), f"page {passage.page}" if passage.page else "", passage.source]
    foot = " · ".join(w for w in (*where, f"{passage.score:.2f}", ranks) if w)
    body = (
        Syntax(passage.text, "scenic", background_color="default") if passage.kind == "snippet" else Text(passage.text)
    )
    head = Text(f"{number}  {passage.component + ' ' if passage.component else ''}{passage.title}")
    return Panel(body, title=head, title_align="left", subtitle=Text(foot, style="dim"), subtitle_align="right")


@app.command()
def build(as_json: Json = False) -> None:
    """Build the index anew; what you added stays, known vectors are kept."""
    with _bar(as_json) as progress:
        report = _run(lambda c: c.build(progress), as_json)
    if as_json:
        typer.echo(json.dumps(report))
        return
    counts = report["counts"]
    typer.echo(
        f"{counts.get('doc', 0)} chunks, {counts.get('snippet', 0)} snippets ({report['embedded']} new vectors)."
    )
    for sentence in report["lost"]:
        typer.echo(f"No longer there: {sentence}")


@app.command()
def add(
    location: Annotated[
        str, typer.Argument(help="A PDF, HTML, Markdown, text or .scenic file, a folder, or an address.")
    ],
    as_json: Json = False,
) -> None:
    """Add documents or your own .scenic programs (exit code 1: some were refused)."""

    async def work(client: RetrievalClient, progress: Callable[[str, int, int], None]) -> dict:
        if decomposer:
            async with decomposer[0]() as (decompose, describe):
                return await client.add(location, progress, decompose=decompose, describe=describe)
        return await client.add(location, progress)

    with _bar(as_json) as progress:
        report = _run(lambda c: work(c, progress), as_json)
    if as_json:
        typer.echo(json.dumps(report))
    else:
        for source in report["added"]:
            typer.echo(f"{source['id']}  {source['title']}: {source['items']} items")
        for sentence in report["refused"]:
            Console(stderr=True).print(Text(sentence, style="yellow"))
    raise typer.Exit(NOTHING if report["refused"] else 0)


@app.command("list")
def list_(as_json: Json = False) -> None:
    """Show what is indexed."""
    report = _run(lambda c: c.list(), as_json)
    if as_json:
        typer.echo(json.dumps(report))
        return
    table = Table("id", "kind", "items", "what", "where")
    for source in report["sources"]:
        where = source["location"] if source["origin"] == "user" else source["origin"]
        table.add_row(source["id"], source["kind"], str(source["items"]), Text(source["title"]), Text(where))
    Console().print(table)
    if report.get("model"):
        typer.echo(f"{report['folder']}: {report['bytes'] / 1e6:.1f} MB, embedded with {report['model']}")
    if report["stale"]:
        typer.echo(f"To be built with the next search: {report['stale']}.")


@app.command()
def remove(id: Annotated[str, typer.Argument(help="The id (see `list`) or the path.")], as_json: Json = False) -> None:
    """Take something you added out of the index."""
    report = _run(lambda c: c.remove(id), as_json)
    if as_json:
        typer.echo(json.dumps(report))
    else:
        for source in report["removed"]:
            typer.echo(f"Removed {source['title']} ({source['items']} items).")


@app.command()
def verify(as_json: Json = False) -> None:
    """Check that the index is whole and up to date (exit code 1: it is not)."""
    report = _run(lambda c: c.verify(), as_json)
    if as_json:
        typer.echo(json.dumps(report))
    else:
        for sentence in report["findings"] or ["The index is whole and up to date."]:
            typer.echo(sentence)
    raise typer.Exit(0 if report["ok"] else NOTHING)
