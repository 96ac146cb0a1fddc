"""Settings of the engine: what a user may set once, in config.toml, by environment or in code."""

import os
import tomllib
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError

from c2s_engine import paths

METHOD = "reader"
"""The method where none is asked for."""
FORMER = ("embedded",)
"""Names of methods that were, which settings and sessions may still have: METHOD is meant."""
WITHOUT_MODEL = frozenset((METHOD, *FORMER, "chatscene"))
"""The methods that need no model to be served."""


class ConfigError(ValueError):
    """The settings file cannot be used; the message says why."""


class Settings(BaseModel):
    """Every field may stand in config.toml under the same name."""

    model_config = ConfigDict(extra="ignore")

    method: str = METHOD
    """How texts are read and programs written: reader, typed, mixed, chat2scenic:C1 ... C12, chatscene ..."""
    map: str | None = None
    """The map where the text names none; none: the paper's default Town05 where it is installed, else `town`."""
    map_folders: tuple[str, ...] = ()
    """Folders in which further .xodr files lie."""
    carla_root: str | None = None
    """Where CARLA is installed; without it, $CARLA_ROOT."""
    model: str | None = None
    """The Ollama model; none: methods without a model only."""
    ollama: dict[str, Any] = {}
    """How models are asked: num_ctx, answer_tokens, timeout, think, endpoint, record ...
    (models.settings.ModelSettings); a table [ollama.models."NAME"] holds what differs for one model."""
    improve: bool = False
    """Whether a model is told what a run did not show, to change S (at most twice, kept where the score rises)."""
    solve: bool = True
    """Whether what a text leaves open is chosen so that the run shows what is required, by a few more runs."""
    offers: bool = True
    """Whether snippets near to what cannot be expressed are looked for when a turn is over."""
    embedding_model: str | None = None
    """Another sentence-transformers model (folder or name) for the index; none: the shipped one."""
    runs: int = 1
    """Rollouts of the dry run a program."""
    seconds: float = 20.0
    """Simulated seconds a rollout, where the program does not end sooner."""
    allow: tuple[tuple[str, str], ...] = ()
    """Further (module, name) pairs that checked programs may import."""


def load_settings(path: Path | None = None, model: str | None = None) -> Settings:
    """The settings of config.toml, else the defaults; raises ConfigError. `model`, else C2S_MODEL, replaces theirs."""
    path = path or paths.config_file()
    values: dict = {}
    if path.is_file():
        try:
            values = tomllib.loads(path.read_text(encoding="utf-8"))
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise ConfigError(f"{path} cannot be read: {error}. Correct or remove the file.") from None
    if chosen := model or os.environ.get("C2S_MODEL"):
        values["model"] = chosen
    try:
        return Settings.model_validate(values)
    except ValidationError as error:
        first = error.errors()[0]
        where = ".".join(str(part) for part in first["loc"])
        raise ConfigError(f"{path}: {where}: {first['msg']}") from None
