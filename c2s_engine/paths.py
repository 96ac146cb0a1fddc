"""Where things are: the shipped data, and the user's cache, data and configuration folders (XDG)."""

import os
from importlib.resources import files
from pathlib import Path


def shipped(*parts: str) -> Path:
    """A file or folder of the shipped data (the package c2s_engine.data)."""
    return Path(str(files("c2s_engine.data").joinpath(*parts)))


def _xdg(variable: str, default: str) -> Path:
    return Path(os.environ.get(variable) or Path.home() / default) / "c2s"


def cache_folder() -> Path:
    return _xdg("XDG_CACHE_HOME", ".cache")


def data_folder() -> Path:
    return _xdg("XDG_DATA_HOME", ".local/share")


def config_file() -> Path:
    return _xdg("XDG_CONFIG_HOME", ".config") / "config.toml"
