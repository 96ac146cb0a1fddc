"""`c2s models list | pull | probe | suggest`: what is at Ollama's host, fetching a model, trying one out."""

import asyncio
from typing import TYPE_CHECKING, Annotated

import typer
import yaml

from c2s_engine.config import ConfigError, load_settings
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.models.settings import settings_for

if TYPE_CHECKING:
    from c2s_engine.models.probe import Tried

app = typer.Typer(help="Language models at Ollama: list, pull, probe, suggest.", no_args_is_help=True)

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
                typer.echo("There are no models yet: `c2s models suggest` names some, `c2s models pull NAME` gets one.")
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
def probe(
    name: Annotated[str, typer.Argument(metavar="[MODEL]", help="Default: the one that is set.")] = "",
    host: Host = "",
    again: Annotated[bool, typer.Option("--again", help="Try anew.")] = False,
) -> None:
    """Try out in which ways a model keeps to a JSON schema, and whether it thinks; what holds is used from then on."""

    async def work() -> None:
        model = name or load_settings().model
        if not model:
            raise ConfigError("Name the model to be tried: `c2s models list` shows what is there.")
        from c2s_engine.models.probe import probe as try_out
        from c2s_engine.models.probe import ways_for

        async with _client(model, host) as client:
            found = await try_out(client, again=again, every=True, on_way=lambda tried: typer.echo(_told(tried)))
            best = found.best(ways_for(client, found.thinks))
        does_not = "does not keep to a JSON schema: it is told the schema in words as well"
        typer.echo(f"{model}: {f'keeps to a JSON schema: forms are asked for by {best}' if best else does_not}")
        typer.echo(f"{model}: {'can think' if found.thinks else 'does not think'}")
        typer.echo(f"{model}: tried with Ollama {found.server or '(which tells no version)'}")
        if found.context_length:
            typer.echo(f"{model}: loaded with a context of {found.context_length} tokens")

    _run(work())


def _told(tried: "Tried") -> str:
    """What came of one way, in a line."""
    if not tried.holds:
        return f"  {str(tried.way):<32} no: {tried.fault}"
    truth = "" if tried.right else ", with a wrong answer"
    return f"  {str(tried.way):<32} yes{truth}: {tried.tokens} tokens, {tried.seconds:.1f} s"


@app.command()
def suggest(
    memory: Annotated[float | None, typer.Option(min=0, help="Only what fits into so many GB.")] = None,
) -> None:
    """Models worth trying, by the memory that they need (estimated), and what the probe found about each."""
    from c2s_engine import paths

    typer.echo(f"{'GB':>3}  {'model':<22} {'download':>8}  what the probe found")
    for m in yaml.safe_load(paths.shipped("ollama.yaml").read_text(encoding="utf-8")):
        if memory is None or m["memory"] <= memory:
            heard = f"; heard: {m['heard']}" if "heard" in m else ""
            typer.echo(f"{m['memory']:>3}  {m['name']:<22} {m['size']:>5} GB  {m['found']}{heard}")
