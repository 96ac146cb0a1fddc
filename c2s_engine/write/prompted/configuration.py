"""The twelve configurations of the paper's ablation, by name (prompts/configurations.yaml)."""

from functools import cache
from typing import Any, Literal

import yaml
from pydantic import BaseModel, ConfigDict

from c2s_engine.write.prompted.texts import read

Block = Literal["CP", "CoT", "ICL", "CodeICL", "DocICL"]


class Configuration(BaseModel):
    """Which blocks a prompt has."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    name: str
    tier: str
    blocks: tuple[Block, ...]
    snippets: int
    chunks: int

    def has(self, block: Block) -> bool:
        return block in self.blocks


@cache
def _table() -> dict[str, Any]:
    return yaml.safe_load(read("configurations.yaml"))


def names() -> list[str]:
    """C1 to C12."""
    return list(_table()["configurations"])


def default() -> str:
    """The configuration that the paper found best."""
    return _table()["default"]


@cache
def configuration(name: str) -> Configuration:
    """The configuration of that name; raises ValueError naming those that there are."""
    table = _table()
    if name not in table["configurations"]:
        raise ValueError(f"There is no configuration {name}; there are {', '.join(names())}.")
    return Configuration(name=name, **table["configurations"][name], **table["retrieved"])
