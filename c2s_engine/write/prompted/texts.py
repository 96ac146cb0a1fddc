"""The prompt blocks: text files under write/prompts, filled in by `$name`."""

from functools import cache
from importlib import resources
from string import Template


@cache
def read(*parts: str) -> str:
    """A file of write/prompts."""
    return resources.files("c2s_engine.write").joinpath("prompts", *parts).read_text(encoding="utf-8")


def fill(name: str, **values: str) -> str:
    """The text of `name`.md with its places filled in; every place must be named."""
    return Template(read(*f"{name}.md".split("/")).strip()).substitute(values)
