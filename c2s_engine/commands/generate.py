"""`c2s generate`: a description in, a Scenic program that runs out."""

import asyncio
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.syntax import Syntax
from rich.text import Text

from c2s_engine import driving
from c2s_engine.commands import show
from c2s_engine.commands.console import (
    BAD_INPUT,
    NO_SERVICE,
    OK,
    REFUSED,
    InputError,
    dump,
    err,
    may_save,
    out,
    sentences,
    work,
)
from c2s_engine.commands.reading import read_text
from c2s_engine.structure.account import account
from c2s_engine.structure.measures import collisions
from c2s_engine.structure.progress import Finished, Say, StageStarted, StructureChanged

if TYPE_CHECKING:
    from c2s_engine.api import Engine


def generate(
    text: Annotated[str | None, typer.Argument(help="The description, or - for standard input.")] = None,
    file: Annotated[
        Path | None, typer.Option("--file", "-f", help="Read the description from a .txt, .md or .pdf file.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Save the program there, map and library beside it; `-`: standard output."),
    ] = None,
    standalone: Annotated[bool, typer.Option("--standalone", help="One file: with the driving library in it.")] = False,
    map_name: Annotated[str | None, typer.Option("--map", help="A map by name or .xodr path (see `c2s maps`).")] = None,
    strict: Annotated[
        bool, typer.Option("--strict", help="Refuse a place that the map lacks or has no room for; change nothing.")
    ] = False,
    seed: Annotated[int, typer.Option(help="The seed of the sampled scene.")] = 0,
    runs: Annotated[int, typer.Option(min=1, max=50, help="Rollouts of the dry run.")] = 1,
    method: Annotated[str | None, typer.Option(help="The method; `c2s doctor` shows which are available.")] = None,
    model: Annotated[str | None, typer.Option(help="The Ollama model, for methods that use one.")] = None,
    improve: Annotated[
        bool | None, typer.Option("--improve/--no-improve", help="Let the model correct what the run did not show.")
    ] = None,
    widen: Annotated[
        bool, typer.Option("--widen", help="Turn open values into ranges in which 90 % of the scenes still pass.")
    ] = False,
    contradictions: Annotated[
        bool,
        typer.Option("--contradictions",
                     help="If requirements are not met, find which numbers of the text contradict one another."),
    ] = False,
    no_run: Annotated[bool, typer.Option("--no-run", help="Compile and sample, but do not run it.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
) -> None:
    """Turn a description of a driving scenario into a Scenic program that runs."""
    only_program = output == Path("-") or output is None and not out.is_terminal
    if output == Path("-"):  # where no library can lie beside it
        output, standalone = None, True
    with sentences(as_json):
        description = read_text(text, file)
        for name, wanted in (("--widen", widen), ("--contradictions", contradictions)):
            if wanted and no_run:
                raise InputError(f"{name} needs dry runs: remove --no-run.")
        may_save(output)
    options = {"method": method, "map": map_name, "seed": seed, "run": not no_run, "runs": runs, "improve": improve}
    options |= {"strict": strict, "widen": widen}
    done: Finished = work(_generate(description, options, model, as_json, contradictions), as_json)
    if output is not None and done.program.text:
        with sentences(as_json):
            from c2s_engine.saving import kept_beside, kept_beside_message, save

            folders = [done.details.get("folder")]
            written = save(done.program, folders, output, standalone, done.structure)
            if not as_json:
                err.print(Text(f"saved {', '.join(str(p) for p in written)}"))
            if not standalone and (kept := kept_beside(done.program, folders, output)):
                err.print(Text(kept_beside_message(kept), style="yellow"))
    if as_json:
        dump(as_dict(done))
    else:
        if output is None and done.program.text:
            _print_program(driving.inlined(done.program.text) if standalone else done.program.text)
        _report(done, err if only_program else out)
    raise typer.Exit(exit_code(done))


def exit_code(done: Finished) -> int:
    """Done, refused, not understood as a text or a change, or stopped because a service (the model's) is not there."""
    if any(d.code == "model-service" for d in done.diagnostics):
        return NO_SERVICE
    if any(d.stage == "interpret" and d.code == "text" or d.code == "unknown-map" for d in done.diagnostics):
        return BAD_INPUT
    if done.details.get("turn") == "edit" and done.details.get("unchanged"):
        return BAD_INPUT if done.ok else REFUSED
    return OK if done.ok else REFUSED


async def _generate(
    text: str, options: dict[str, Any], model: str | None, quiet: bool, contradictions: bool
) -> Finished:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    settings = load_settings(model=model)
    words, method = len(text.split()), options["method"] or settings.method
    if not quiet:
        err.print(Text(f"c2s: {words} word{'s' * (words != 1)}, method {method}", style="dim"))
    with err.status("starting") if not quiet and err.is_terminal else _quiet() as status:
        idle: asyncio.Task[Any] | None = None
        async with Engine(settings) as engine:
            async for event in engine.generate(text, **options):
                if isinstance(event, StructureChanged) and idle is None:
                    read = event.structure
                    idle = asyncio.create_task(engine.without_effect(read.text, read))  # while that is run
                elif isinstance(event, StageStarted) and status is not None:
                    status.update(event.stage + event.runs)
                elif isinstance(event, Say) and not quiet:
                    err.print(Text(event.text, style={"warning": "yellow", "error": "red"}.get(event.severity, "")))
                elif isinstance(event, Finished):
                    if idle is not None:
                        if status is not None:
                            status.update("reading the text again without each phrase")
                        event = event.model_copy(update={"details": {**event.details, "without_effect": await idle}})
                    if not contradictions:
                        return event
                    if status is not None:
                        status.update("looking for what contradicts")
                    return await with_contradictions(engine, event, options["seed"])
    raise RuntimeError("the turn ended without a result")


async def with_contradictions(engine: "Engine", done: Finished, seed: int) -> Finished:
    """A finished turn with what of its text contradicts itself, where its run did not show all that is required."""
    failing, name = any(not r.holds for r in done.results), done.details.get("map")
    if not failing or not name:
        return done
    found = engine.contradictions(done.structure, map=name, room=done.details.get("room", 1.0), seed=seed)
    return done.model_copy(update={"details": {**done.details, "contradictions": [o async for o in found]}})


class _quiet:
    def __enter__(self) -> None:
        return None

    def __exit__(self, *_: object) -> None:
        return None


def as_dict(done: Finished) -> dict[str, Any]:
    """The JSON of a finished turn."""
    keep = ("id", "description", "spec", "code", "origin", "links", "assumed", "unmet")
    components = [{k: c.model_dump(mode="json")[k] for k in keep} for c in done.structure.components]
    return {
        "ok": done.ok,
        "structure": components,
        "not_understood": [u.model_dump(mode="json") for u in done.structure.not_understood],
        "account": [c.model_dump(mode="json") for c in account(done.structure, done.details.get("without_effect", ()))],
        "program": done.program.text,
        "source_map": [s.model_dump(mode="json") for s in done.program.spans],
        "stages": [s.model_dump(mode="json") for s in done.stages],
        "events": show.events_as_dicts(done.facts),
        "collisions": [
            {"seed": f.seed, "time": c.time, "one": c.one, "other": c.other, "said": c.said}
            for f in done.facts
            for c in collisions(f, done.requirements)
        ],
        "measures": [m.model_dump(mode="json") for m in done.measures],
        "without_effect": [u.model_dump(mode="json") for u in done.details.get("without_effect", ())],
        "contradictions": [o.model_dump(mode="json") for o in done.details.get("contradictions", ())],
        "requirements": show.required_as_dicts(done.requirements, done.results),
        "facts": [f.model_dump(mode="json") for f in done.facts],
        "map": done.details.get("map"),
        "tokens": done.details.get("tokens", 0),
        "tokens_by_component": done.details.get("usage", {}),
        "share_without_fallback": done.details.get("share"),
        "seconds": done.seconds,
    }


def _print_program(text: str) -> None:
    if out.is_terminal:
        out.print(Syntax(text, "python", background_color="default"))
    else:
        out.file.write(text)


def _report(done: Finished, to: Console) -> None:
    """S and how it went; where the program alone is the output, on standard error."""
    show.structure(done.structure, to)
    to.print()
    show.stages(done.stages, to)
    show.diagnostics(done.diagnostics, to)
    show.cost(done.details, to)
    idle = done.details.get("without_effect", ())
    show.outcome(done.structure, done.facts, done.requirements, done.results, done.measures, to, idle)
    show.contradictions(done.details, to)
