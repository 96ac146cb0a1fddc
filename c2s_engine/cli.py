"""`c2s`: the command line. Commands of other packages (bench, app) come in by the entry point group `c2s.commands`."""

import contextlib
import gc
import sys
from importlib.metadata import entry_points, version
from typing import Annotated

import typer

from c2s_engine.commands.console import BAD_INPUT, err

app = typer.Typer(
    help="From a description of a driving scenario to a Scenic program that runs, and both kept in step.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def _version(asked: bool) -> None:
    if asked:
        typer.echo(f"c2s {version('c2s')}")
        raise typer.Exit


@app.callback()
def options(
    show_version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and leave.")
    ] = False,
) -> None:
    """From a description of a driving scenario to a Scenic program that runs, and both kept in step."""


def _mount(wanted: str | None) -> None:
    """Mount the commands; the heavier ones only when they are asked for or help is shown."""
    if wanted == "app":  # on the screen at once
        for entry in entry_points(group="c2s.commands", name="app"):
            app.add_typer(entry.load(), name="app")
        return
    from c2s_engine.commands import checking, generate, places, sessions, texts

    app.command()(generate.generate)
    app.command()(checking.check)
    app.command()(checking.run)
    app.command()(places.maps)
    app.command()(places.doctor)
    app.command()(places.glossary)
    app.command()(places.gallery)
    app.command()(texts.interpret)
    app.command("import")(texts.import_)
    app.command()(sessions.edit)
    app.add_typer(sessions.app, name="sessions")
    everything = wanted is None
    if everything or wanted == "report":
        from c2s_engine.commands.report import report

        app.command()(report)
    if everything or wanted == "calibrate":
        from c2s_engine.commands.calibrating import calibrate

        app.command()(calibrate)
    if everything or wanted == "mcp":
        from c2s_engine.commands.mcp import mcp

        app.command()(mcp)
    if everything or wanted in ("index", "search"):
        from c2s_engine.commands.indexing import parts
        from c2s_engine.retrieve import commands as retrieval

        retrieval.decomposer[:] = [parts]
        app.add_typer(retrieval.app, name="index")
        app.command("search")(retrieval.search_command)
    if everything or wanted == "models":
        from c2s_engine.models.commands import app as models

        app.add_typer(models, name="models")
    for entry in entry_points(group="c2s.commands"):
        if everything or wanted == entry.name:
            with contextlib.suppress(ModuleNotFoundError):  # a front that is not installed
                app.add_typer(entry.load(), name=entry.name)


def main() -> None:
    """The entry point; what nobody foresaw is still one sentence."""
    wanted = next((a for a in sys.argv[1:] if not a.startswith("-")), None)
    _mount(wanted)
    try:
        app()
    except (KeyboardInterrupt, BrokenPipeError):
        sys.exit(130)
    except Exception as error:  # noqa: BLE001
        what = f"{type(error).__name__}: {error}"
        err.print(f"c2s: internal error: {what}. Please report it.", markup=False, style="red")
        sys.exit(BAD_INPUT)
    finally:
        gc.freeze()  # the interpreter ends without looking through all that was imported, which takes 0.7 s


if __name__ == "__main__":
    main()
