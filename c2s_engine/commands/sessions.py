"""`c2s edit` and `c2s sessions`: a session's turns without the app, and sessions as a whole."""

import asyncio
import contextlib
import difflib
import json
from collections.abc import AsyncIterator, Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.text import Text

from c2s_engine.commands import show
from c2s_engine.commands.console import OK, InputError, dump, err, may_save, out, sentences
from c2s_engine.commands.generate import exit_code, with_contradictions
from c2s_engine.commands.reading import read_program
from c2s_engine.commands.series import chosen_seeds, series
from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Finished, Passage, Progress, Say

if TYPE_CHECKING:
    from c2s_engine.api import Engine
    from c2s_engine.session.sessions import Session, Sessions
    from c2s_engine.structure.components import Unmet
    from c2s_engine.structure.edits import Edit

app = typer.Typer(help="Sessions: list, rename, duplicate, delete, export, import.", no_args_is_help=True)

Name = Annotated[str, typer.Argument(help="The session's name.")]


def edit(
    name: Annotated[str, typer.Argument(metavar="SESSION", help="The session (see `c2s sessions list`).")],
    new: Annotated[bool, typer.Option("--new", help="Make the session where there is none of that name.")] = False,
    say: Annotated[
        str | None, typer.Option("--say", help="A turn of the chat: a scenario, a change, a question.")
    ] = None,
    program: Annotated[
        Path | None, typer.Option("--program", metavar="FILE", help="Import a Scenic program into the session first.")
    ] = None,
    fields: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="ID.FIELD=VALUE", help="Such as 'O1.speed=40 km/h' (may be repeated)."),
    ] = None,
    remove: Annotated[list[str] | None, typer.Option("--remove", metavar="ID", help="Remove an object.")] = None,
    code: Annotated[
        list[str] | None, typer.Option("--code", metavar="ID=FILE", help="Your code for it; `ID=`: written again.")
    ] = None,
    undo: Annotated[bool, typer.Option("--undo", help="Undo the last turn.")] = False,
    redo: Annotated[bool, typer.Option("--redo", help="Redo what was undone.")] = False,
    to: Annotated[
        int | None, typer.Option("--to", metavar="N", help="Return to the state after turn N (0: before the first).")
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Run the turn that a crash interrupted.")] = False,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Save the program there, map and library beside it.")
    ] = None,
    standalone: Annotated[bool, typer.Option("--standalone", help="One file: with the driving library in it.")] = False,
    method: Annotated[str | None, typer.Option(help="The method.")] = None,
    model: Annotated[str | None, typer.Option(help="The Ollama model, for methods that use one.")] = None,
    improve: Annotated[
        bool | None, typer.Option("--improve/--no-improve", help="Let the model correct what the run did not show.")
    ] = None,
    seed: Annotated[int, typer.Option(help="The seed of the sampled scene.")] = 0,
    no_run: Annotated[bool, typer.Option("--no-run", help="Compile and sample, but do not run it.")] = False,
    contradictions: Annotated[
        bool,
        typer.Option("--contradictions",
                     help="If requirements are not met, find which numbers of the text contradict one another."),
    ] = False,
    seeds: Annotated[str | None, typer.Option(help="Then run it once with each of N seeds: 20, or 5-9.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False,
) -> None:
    """Work on a session: say something, set fields of S, write code by hand, undo, redo; show where it stands."""
    with sentences(as_json):
        edits = edits_of(fields or [], remove or [], code or [])
        options = {"method": method, "seed": seed, "run": not no_run, "improve": improve}
        chosen = chosen_seeds(seeds, seed)
        if contradictions and no_run:
            raise InputError("--contradictions needs dry runs: remove --no-run.")
        may_save(output)
        text = (program, read_program(program)) if program else None
        if not (new or program):
            known(name)
        told: list[str] = []
        session, done = asyncio.run(_work(name, text, say, edits, (undo, redo, resume, to), options, model, as_json,
                                          contradictions, told))  # fmt: skip
        if output is not None:
            from c2s_engine.config import load_settings
            from c2s_engine.maps.library import MapLibrary
            from c2s_engine.saving import kept_beside, kept_beside_message, missing_files, missing_files_message, save

            settings = load_settings()
            at_hand = MapLibrary(settings.map_folders, settings.carla_root).folder_of(session.program.text)
            folders = [session.details.get("folder"), at_hand, str(program.parent) if program else None]
            written = save(session.program, folders, output, standalone, session.structure)
            if not as_json:
                err.print(Text(f"saved {', '.join(map(str, written))}"))
            if not standalone and (kept := kept_beside(session.program, folders, output)):
                err.print(Text(kept_beside_message(kept), style="yellow"))
            if missing := missing_files(output):
                err.print(Text(missing_files_message(missing), style="yellow"))
        if not as_json:
            _print(session, done.details.get("without_effect", ()) if done else ())
            show.contradictions(done.details if done else {})
    code_of = OK if done is None else exit_code(done)
    if code_of != OK and told and not as_json:  # what stands above is of S as it was
        err.print(Text("\n".join(told), style="yellow"))
    found: dict[str, Any] = {}
    if chosen and code_of == OK:
        folder = session.details.get("folder")
        code_of, found = series(session.structure, session.program, chosen, as_json, folder=folder)
    if as_json:
        dump({**_as_dict(session, done), **({"series": found} if found else {})})
    raise typer.Exit(code_of)


@app.command("list")
def list_sessions(as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object.")] = False) -> None:
    """List the sessions, the one used last first."""
    with sentences(as_json):
        found = _sessions().list()
        if as_json:
            dump({"sessions": [vars(s) for s in found]})
            return
        for s in found:
            when = datetime.fromtimestamp(s.updated).strftime("%Y-%m-%d %H:%M")
            out.print(Text(f"{s.name:<30} {s.turns:>4} turns  {when}  {s.last[:60]}"), soft_wrap=True)


@app.command()
def rename(name: Name, new: str) -> None:
    """Give a session another name."""
    with sentences():
        _sessions().rename(name, new)


@app.command()
def duplicate(name: Name, new: str) -> None:
    """Make a second session with the same turns."""
    with sentences():
        _sessions().duplicate(name, new)


@app.command()
def delete(name: Name) -> None:
    """Delete a session with all its turns and drafts."""
    with sentences():
        _sessions().delete(name)


@app.command("export")
def export_session(name: Name, file: Path) -> None:
    """Write a session with its turns as one file."""
    with sentences():
        _sessions().export(name, file)


@app.command("import")
def import_session(file: Path, name: Annotated[str | None, typer.Option(help="Another name.")] = None) -> None:
    """Take a session from a file."""
    with sentences():
        out.print(Text(_sessions().import_file(file, name)))


def _sessions() -> "Sessions":
    from c2s_engine.session.sessions import Sessions

    return Sessions()


def known(name: str, new: str = "--new") -> None:
    """Raise InputError for a name that no session has: a slip of the keys makes no session. `new` is what makes one."""
    names = [s.name for s in _sessions().list()]
    if name not in names:
        near = difflib.get_close_matches(name, names, 3)
        there = f"did you mean {' or '.join(near)}?" if near else f"there are {', '.join(names[:8]) or 'none yet'}."
        raise InputError(f"There is no session {name!r}: {there} {new} makes it.")


def field_edit(name: str, value: Any) -> "Edit":
    """The edit of S that sets ID.FIELD; raises InputError."""
    from c2s_engine.structure.edits import SetDescription, SetField

    component, dot, path = name.strip().partition(".")
    if not dot or not path:
        raise InputError(f"{name}: write it as ID.FIELD, such as O1.speed")
    if path == "description":
        return SetDescription(component=component, description=str(value))
    return SetField(component=component, path=path, value=value)


def edits_of(fields: list[str], remove: list[str], code: list[str]) -> "list[Edit]":
    """The edits of S that options name: ID.FIELD=VALUE (the values as they are typed), IDs to remove, ID=FILE; raises
    InputError."""
    from c2s_engine.structure.edits import RemoveObject, SetCode

    edits: list[Edit] = []
    for given in fields:
        target, equals, text = given.partition("=")
        if not equals or "." not in target:
            raise InputError(f"--set {given}: write it as ID.FIELD=VALUE, such as O1.speed=40")
        edits.append(field_edit(target, text))
    edits += [RemoveObject(component=r) for r in remove]
    for given in code:
        component, equals, file = given.partition("=")
        if not equals:
            raise InputError(f"--code {given}: write it as ID=FILE")
        edits.append(SetCode(component=component, code=Path(file).read_text(encoding="utf-8") if file else None))
    return edits


def _meant(edit: "Edit", structure: Structure) -> "Edit":
    """An edit with what its typed value means: as in the fields of the app (50 km/h, 5-8 m), or JSON in SI units.
    Raises EditError."""
    from c2s_engine.structure.edits import SetField
    from c2s_engine.structure.values import field_at, parse

    if not isinstance(edit, SetField):
        return edit
    text, value = str(edit.value).strip(), edit.value
    field = field_at(structure[edit.component].spec, edit.path) if edit.component in structure else None
    if field is not None and text[:1] not in ("[", "{", '"'):
        value = parse(field, "" if text == "null" else text)
    else:
        with contextlib.suppress(ValueError):
            value = json.loads(text)
    return edit.model_copy(update={"value": value})


async def _work(
    name: str,
    program: tuple[Path, str] | None,
    say: str | None,
    edits: "list[Edit]",
    steps: tuple[bool, bool, bool, int | None],
    options: dict[str, Any],
    model: str | None,
    quiet: bool,
    contradictions: bool,
    told: list[str],
) -> "tuple[Session, Finished | None]":
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings
    from c2s_engine.saving import taken
    from c2s_engine.structure.edits import Replace

    undo, redo, resume, to = steps
    done: Finished | None = None
    settings = load_settings(model=model)
    engine = Engine(settings)
    async with contextlib.AsyncExitStack() as stack:
        if program or say or edits or resume or contradictions:  # the rest needs no check server
            await stack.enter_async_context(engine)
        session = _sessions().open(name, engine)
        try:
            if session.pending and not resume:
                err.print(Text(f"a turn was interrupted: {session.pending.text!r} (--resume runs it)", style="yellow"))
            if resume:
                done = await _take(session.resume(), quiet)
            if undo:
                done = await _take(session.undo(), quiet)
            if redo:
                done = await _take(session.redo(), quiet)
            if to is not None:
                done = await _take(session.back_to(to - 1), quiet)
            if program:
                given = taken(*program)
                if not given:
                    found = await engine.import_program(program[1], folder=program[0].parent)
                    given = [Replace(structure=found)]
                done = await _take(session.apply(given, **options), quiet)
            if say:
                upon = session.structure
                done = await _take(session.say(say, **options), quiet, told)
                if done is not None and session.structure != upon:
                    idle = await _without_effect(engine, session, say, upon)
                    done = done.model_copy(update={"details": {**done.details, "without_effect": idle}})
            if edits:
                meant = [_meant(edit, session.structure) for edit in edits]
                done = await _take(session.apply(meant, **options), quiet)
            if contradictions:
                done = await with_contradictions(engine, done or state_of(session), options["seed"])
        finally:
            session.close()
    return session, done


async def _without_effect(
    engine: "Engine", session: "Session", said: str, before: Structure
) -> "tuple[Unmet, ...]":
    """The words of a description, or of a change of what S was `before`, that nothing in S says."""
    if session.structure.text == said:
        return await session.without_effect()
    found = await engine.without_effect(said, session.structure, before)
    session.keep_idle(said, found)
    return found


async def _take(events: AsyncIterator[Progress], quiet: bool, told: list[str] | None = None) -> Finished | None:
    """The end of a turn, whose words are printed as they come, and added to `told`."""
    done, number = None, 0
    async for event in events:
        if isinstance(event, Passage) and not quiet:
            number += 1
            err.print(Text(f"{number} {event.title}", style="bold"))
            err.print(Text(event.text.strip()))
        elif isinstance(event, Say) and not quiet:
            if told is not None:
                told.append(event.text)
            err.print(Text(event.text, style={"warning": "yellow", "error": "red"}.get(event.severity, "")))
        elif isinstance(event, Finished):
            done = event
    return done


def state_of(session: "Session") -> Finished:
    """A session as it stands, as the end of a turn."""
    kept: dict[str, Any] = {k: session.details[k] for k in ("folder", "map", "room") if k in session.details}
    kept["without_effect"] = session.idle or ()
    return Finished(
        ok=True, structure=session.structure, program=session.program, stages=session.stages, facts=session.facts,
        requirements=session.requirements, results=session.results, details=kept,
    )  # fmt: skip


def _as_dict(session: "Session", done: Finished | None) -> dict[str, Any]:
    from c2s_engine.commands.generate import as_dict

    state = done or state_of(session)
    history = [{"kind": t.kind, "text": t.text, "summary": t.summary, "when": t.when} for t in session.history]
    return {**as_dict(state), "session": session.name, "history": history}


def _print(session: "Session", idle: Sequence["Unmet"]) -> None:
    """The session as it stands; `idle`: the words of what was said just now that make no difference."""
    for turn in session.history[-5:]:
        when = datetime.fromtimestamp(turn.when).strftime("%Y-%m-%d %H:%M")
        out.print(Text(f"{turn.index + 1:>3}  {when}  {turn.text[:70]}  ({turn.summary})", style="dim"), soft_wrap=True)
    show.structure(session.structure)
    show.conflicts(session.structure, session.name)
    show.stages(session.stages)
    show.diagnostics([d for s in session.stages for d in s.diagnostics])
    of_text = session.idle or ()
    show.outcome(
        session.structure, session.facts, session.requirements, session.results, session.measures, idle=of_text
    )
    show.without_effect([u for u in idle if u not in of_text])
