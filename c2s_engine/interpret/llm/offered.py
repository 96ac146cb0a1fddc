"""What a form offers only where it can apply, and what of an answer does not (prompts/offered.yaml)."""

import re
from functools import cache
from importlib import resources
from typing import Any

import yaml


@cache
def table() -> dict[str, Any]:
    """prompts/offered.yaml."""
    text = resources.files("c2s_engine.interpret.llm").joinpath("prompts", "offered.yaml").read_text(encoding="utf-8")
    return yaml.safe_load(text)


def offer(schema: dict[str, Any], said: str, within: str = "form") -> None:
    """Take out of a form's schema what cannot apply in a scenario that says this. `within`: the field that it is of."""
    properties = schema["properties"]
    for name, node in properties.items():
        choices = node.get("enum", [])
        for choice, groups in table()["choices"].get(name, {}).items():
            if choice in choices and len(choices) > 1 and not _says(said, groups):
                choices.remove(choice)
    for name, needed in table()["fields"].get(within, {}).items():
        if name in properties and not (_taken(properties, needed.get("with", {})) and _says(said, needed["said"])):
            del properties[name]
    for name, node in properties.items():
        inner = node.get("items", node)
        if "properties" in inner:
            offer(inner, said, name)


def asks(cid: str, said: str) -> bool:
    """Whether a scenario that says this is asked for a component that has no sentence."""
    return _says(said, table()["asked"].get(cid, []))


def _taken(properties: dict[str, Any], choices: dict[str, list[str]]) -> bool:
    """Whether the fields beside it offer a choice that takes it."""
    return all(set(taking) & set(properties.get(name, {}).get("enum", ())) for name, taking in choices.items())


def pop_inapplicable_fields(value: dict[str, Any], within: str = "form") -> list[str]:
    """Take out of an answer the fields that its own choice beside them does not take; what they said, in words."""
    left: list[str] = []
    for name, needed in table()["fields"].get(within, {}).items():
        for beside, taking in needed.get("with", {}).items():
            if name in value and value.get(beside) not in taking and (said := value.pop(name)) is not False:
                left.append(f"{name.replace('_', ' ')} {said}")
    for name, inner in value.items():
        for item in inner if isinstance(inner, list) else [inner]:
            if isinstance(item, dict):
                left += pop_inapplicable_fields(item, name)
    return left


def _says(said: str, groups: list[str]) -> bool:
    return any(_pattern(group).search(said) for group in groups)


@cache
def _pattern(group: str) -> re.Pattern[str]:
    words = table()["groups"][group].replace("_", r"\s").split()
    return re.compile(rf"(?<!\w)(?:{'|'.join(words)})", re.I)
