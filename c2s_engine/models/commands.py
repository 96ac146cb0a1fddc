"""`c2s models list | pull | probe`: what is at Ollama's host, fetching a model, trying one out."""

import asyncio
from typing import Annotated

import typer

from c2s_engine.config import ConfigError, load_settings
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.models.settings import settings_for

app = typer.Typer(help="Language models at Ollama: list, pull, probe.", no_args_is_help=True)

Host = Annotated[str, typer.Option("--host", help="Where Ollama listens; default OLLAMA_HOST.")]


def _run(coroutine) -> None:
    try:
        asyncio.run(coroutine)
    except ConfigError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(2) from None
    except ModelError as error:
        typer.echo(str(error), err=True)
        raise typer.Exit(3 if error.service else 1) from None


def _client(model: str, host: str) -> OllamaClient:
    """A client with the user's settings of that model."""
    return OllamaClient(settings_for(model, load_settings().ollama, host))


@app.command("list")
def list_models(host: Host = "") -> None:
    """List the models at the host."""

    async def work() -> None:
        async with _client("", host) as client:
            models = await client.models()
            if not models:
                typer.echo("There are no models yet: get one with `c2s models pull NAME`.")
            for m in models:
                typer.echo(f"{m['name']:<40} {m['size'] / 1e9:6.1f} GB  {m['parameters']:<8} {m['quantization']}")

    _run(work())


@app.command()
def pull(model: str, host: Host = "") -> None:
    """Fetch a model to the host."""

    async def work() -> None:
        async with _client(model, host) as client:
            said = ""
            async for what, done, total in client.pull(model):
                line = f"{what} {100 * done // total}%" if total else what
                if line != said:
                    typer.echo(line)
                    said = line
        typer.echo(f"{model} is there.")

    _run(work())


@app.command()
def probe(model: str, host: Host = "", again: Annotated[bool, typer.Option(help="Try anew.")] = False) -> None:
    """Try out whether a model keeps to a JSON schema and whether it thinks."""

    async def work() -> None:
        from c2s_engine.models.probe import probe as try_out

        async with _client(model, host) as client:
            found = await try_out(client, again=again)
        typer.echo(f"{model}: {'keeps' if found.honours_format else 'does not keep'} to a JSON schema")
        typer.echo(f"{model}: {'can think' if found.thinks else 'does not think'}")
        if found.context_length:
            typer.echo(f"{model}: loaded with a context of {found.context_length} tokens")

    _run(work())
