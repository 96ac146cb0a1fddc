"""`c2s mcp`: the engine as a tool of assistants, over the Model Context Protocol."""

import importlib.util
from typing import Annotated

import typer

from c2s_engine.commands.console import NO_SERVICE, err, fail, sentences

MISSING = "The package mcp is not installed: `pip install 'c2s[mcp]'` gets it, in a checkout `pip install -e '.[mcp]'`."


def mcp(
    model: Annotated[str | None, typer.Option(help="The Ollama model, for methods that use one.")] = None,
) -> None:
    """Serve generate, interpret, check, run, edit, report and search to an assistant (MCP over stdio)."""
    if importlib.util.find_spec("mcp") is None:
        fail(MISSING, NO_SERVICE)
    with sentences():
        from c2s_engine.config import load_settings
        from c2s_engine.mcp_server.service import server

        made = server(load_settings(model=model))
    if err.is_terminal:
        err.print("c2s serves MCP on standard input and output; an assistant starts it. Ctrl+C ends it.", style="dim")
    made.run("stdio")
