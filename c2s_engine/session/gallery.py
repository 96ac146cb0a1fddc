"""Ten descriptions to start from, one of each kind (data/gallery.yaml)."""

from functools import cache

import yaml
from pydantic import BaseModel, ConfigDict

from c2s_engine import paths


class Example(BaseModel):
    """A description, what it is an example of, and what its run must show: an actor's component and an event."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    about: str
    text: str
    shows: tuple[str, str]


@cache
def gallery() -> dict[str, Example]:
    """By name, in the order of the file."""
    entries = yaml.safe_load(paths.shipped("gallery.yaml").read_text("utf-8"))
    return {name: Example.model_validate(entry) for name, entry in entries.items()}
