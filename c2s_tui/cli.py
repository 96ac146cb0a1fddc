"""`c2s app`: starts the app."""

from pathlib import Path
from typing import Annotated

import typer

app = typer.Typer(add_completion=False, help="The editor: chat, structure and live code, kept in step.")


@app.callback(invoke_without_command=True)
def start(
    session: Annotated[str | None, typer.Argument(help="The session to open; it is made where there is none.")] = None,
    file: Annotated[Path | None, typer.Option("--file", "-f", help="A .scenic file to open.")] = None,
) -> None:
    """Open the editor on a session (default: the last one, or the example)."""
    from c2s_tui.launch import launch

    raise typer.Exit(launch(session, file))
