"""The prose of a form, made from its schema: fields and choices in its order, meanings from prompts/fields.yaml."""

import json
from collections.abc import Mapping
from functools import cache
from importlib import resources
from typing import Any

import yaml

from c2s_engine.interpret.llm import words
from c2s_engine.interpret.llm.schema import accepts, described

UNMET = "what these fields cannot say"
EXAMPLES = 2
MANY = 6
"""Choices from which on they are not listed a second time."""


@cache
def table() -> dict[str, Any]:
    """prompts/fields.yaml."""
    text = resources.files("c2s_engine.interpret.llm").joinpath("prompts", "fields.yaml").read_text(encoding="utf-8")
    return yaml.safe_load(text)


def fields(kind: str, schema: dict[str, Any]) -> str:
    """`- name (choices): meaning` for each field, the fields of an object below it (several on a line), and a line for
    each choice that the vocabulary explains. A field that fields.yaml does not know is told in its class's words."""
    known = described("O" if kind == "thing" else kind)
    told = {**known, **table()[kind]["fields"], "unmet": UNMET}
    return "\n".join(_lines(schema["properties"], told, "- ", {}, known))


def _lines(
    properties: dict[str, Any], told: Mapping[str, Any], mark: str, explained: dict[str, list[Any]],
    known: Mapping[str, str],
) -> list[str]:  # fmt: skip
    """`explained`: the choices that were explained so far, by their field; `known`: what the classes say."""
    rows: list[str] = []
    joins = False
    listed: dict[str, list[Any]] = {}
    for name, node in properties.items():
        meaning, inner, choices = told[name], _object_in(node), _choices(node)
        section = meaning.get("words", "") if isinstance(meaning, dict) else ""
        plain = meaning.get("is", "") if isinstance(meaning, dict) else meaning
        beside = next((n for n, other in properties.items() if inner and n != name and other == node), "")
        if beside and f"{mark}{beside}: " in "\n".join(rows):
            rows.append(f"{mark}{name}: {plain}, fields as {beside}")
        elif inner is not None:
            each = ", each" if node.get("type") == "array" else ""
            rows.append(f"{mark}{name}: {plain}{each}:")
            rows += _lines(
                inner["properties"], {**known, **table()["inner"].get(name, {})}, f"-{mark}", explained, known
            )
        elif section:
            rows.append(f"{mark}{name}{f': {plain}' if plain else ''}:")
            rows += [row.replace("- ", " ", 1) for row in words.lines(section, choices).splitlines()]
            explained[name] = choices
        else:
            these = f" ({_listed(choices, explained.get(name, []), listed)})" if choices else ""
            listed[name] = choices
            if len(choices) >= MANY:
                explained.setdefault(name, choices)
            row = f"{name}{these}{f': {plain}' if plain else ''}"
            if joins and mark != "- ":
                rows[-1] += f"; {row}"
            else:
                rows.append(f"{mark}{row}")
        joins = inner is None and not section
    return rows


def _listed(choices: list[Any], explained: list[Any], listed: Mapping[str, list[Any]]) -> str:
    """The choices; where all that were explained before are among them, those as such and the others by name; where a
    field beside it has the same, as that one's."""
    if len(choices) >= MANY and explained and set(explained) <= set(choices):
        return ", ".join(["as above", *(c for c in choices if c not in explained)])
    same = next((name for name, others in listed.items() if others == choices), "")
    return f"as {same}" if same and len(choices) >= MANY else ", ".join(map(str, choices))


def _object_in(node: dict[str, Any]) -> dict[str, Any] | None:
    node = node.get("items", node) if node.get("type") == "array" else node
    return node if "properties" in node else None


def _choices(node: dict[str, Any]) -> list[Any]:
    node = node.get("items", node) if node.get("type") == "array" else node
    return node.get("enum", [])


def examples(kind: str, schema: dict[str, Any], others: list[str], earlier: list[str]) -> str:
    """The first examples of a kind that the schema takes, in its order of fields."""
    names = {"{other}": others[0] if others else "", "{ahead}": earlier[0] if earlier else ""}
    shown = []
    for example in table()[kind].get("examples", ()):
        text = f"{example['says']}\n{json.dumps(example['answer'])}"
        for place, name in names.items():
            text = text.replace(place, name or place)
        says, _, answer = text.partition("\n")
        value = json.loads(answer)
        if accepts(schema, value) == "" and "{" not in says:
            shown.append(f'Example. "{says}"\n{json.dumps(in_order(schema, value))}')
    return "\n".join(shown[:EXAMPLES])


def in_order(schema: dict[str, Any], value: Any) -> Any:
    """A value with its fields in the order of the schema."""
    if "anyOf" in schema:
        schema = next(c for c in schema["anyOf"] if accepts(c, value) == "")
    if isinstance(value, list):
        return [in_order(schema["items"], item) for item in value]
    if isinstance(value, dict):
        return {n: in_order(s, value[n]) for n, s in schema["properties"].items() if n in value}
    return value
