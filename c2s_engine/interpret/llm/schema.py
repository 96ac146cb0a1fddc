"""The JSON schemas that a model's answers are held to: made from the specs, small, closed, with bounds.

Beyond pydantic's own schema: references are inlined, optional fields are left out instead of null, references are
limited to the objects that there are, and numbers have the bounds of data/models.yaml.
"""

from collections.abc import Iterable
from functools import cache
from typing import Any, get_args

import yaml
from jsonschema import Draft202012Validator
from jsonschema.exceptions import ValidationError
from pydantic import BaseModel

from c2s_engine import paths
from c2s_engine.structure.specs import SPEC_OF, Reference

_REFERENCE = next(m.pattern for m in get_args(Reference)[1].metadata if hasattr(m, "pattern"))
ASKED = {"G": (), "R": (), "E": (), "O": ("name", "type", "placement"), "T": ()}
"""The fields that every answer must have."""
NOT_ASKED = {"parameters", "preset", "map"}
"""Settings that no form of a spec asks for: the detector does."""


@cache
def limits() -> dict[str, Any]:
    """The table data/models.yaml: bounds of numbers (SI) by field, and lengths of lists."""
    return yaml.safe_load(paths.shipped("models.yaml").read_text(encoding="utf-8"))


def spec_schema(kind: str, ids: Iterable[str], *, allowed: dict[str, list[str]] | None = None) -> dict[str, Any]:
    """The schema of one spec. `ids`: what may be referred to; `allowed`: narrower choices for a field's words."""
    schema = compact(spec_class(kind), tuple(ids), allowed or {})
    schema["required"] = [n for n in ASKED[kind] if n in schema["properties"]] or schema.get("required", [])
    schema["properties"]["unmet"] = {"type": "string", "maxLength": limits()["lengths"]["unmet"]}
    return schema


def spec_class(kind: str) -> type[BaseModel]:
    """The class of a kind's specs."""
    return SPEC_OF[kind]  # type: ignore[return-value]


def described(kind: str) -> dict[str, str]:
    """What the specs' classes say of the fields of a kind, by name, those of the objects in it too."""
    whole = spec_class(kind).model_json_schema()
    parts = [*whole.get("$defs", {}).values(), whole]
    return {n: f.get("description", "") for part in parts for n, f in part.get("properties", {}).items()}


def compact(model: type[BaseModel], ids: tuple[str, ...] = (), allowed: dict[str, list[str]] | None = None) -> dict:
    """The inlined, closed schema of a pydantic class."""
    whole = model.model_json_schema()
    return _node(whole, whole.get("$defs", {}), "", ids, allowed or {})


def _node(node: dict[str, Any], defs: dict[str, Any], name: str, ids: tuple[str, ...], allowed: dict) -> dict[str, Any]:
    if "$ref" in node:
        return _node(defs[node["$ref"].rsplit("/", 1)[-1]], defs, name, ids, allowed)
    if "anyOf" in node:
        choices = [c for c in node["anyOf"] if c.get("type") != "null"]
        if len(choices) == 1:
            return _node(choices[0], defs, name, ids, allowed)
        return {"anyOf": [_node(c, defs, name, ids, allowed) for c in choices]}
    if _refers(node):
        return {"type": "string", "enum": _referable(name, ids)}
    if "const" in node:
        return {"type": "string", "enum": [node["const"]]}
    if "enum" in node:
        words = [w for w in node["enum"] if w in allowed.get(name, node["enum"])]
        return {"enum": words} if not all(isinstance(w, str) for w in words) else {"type": "string", "enum": words}
    kind = node.get("type")
    if kind == "object":
        return _object(node, defs, ids, allowed)
    if kind == "array":
        return _array(node, defs, name, ids, allowed)
    if kind in ("number", "integer"):
        low, high = limits()["numbers"].get(name, (node.get("minimum", 0), node.get("maximum", 1000)))
        return {"type": kind, "minimum": low, "maximum": high}
    if kind == "string":
        return {"type": "string", "maxLength": limits()["lengths"]["string"]}
    return {"type": kind} if kind else {}


def _object(node: dict[str, Any], defs: dict, ids: tuple[str, ...], allowed: dict) -> dict[str, Any]:
    names = [n for n in node.get("properties", {}) if n != "component" and n not in NOT_ASKED]
    names = [n for n in names if not _refers(node["properties"][n]) or _referable(n, ids)]
    properties = {n: _node(node["properties"][n], defs, n, ids, allowed) for n in names}
    schema: dict[str, Any] = {"type": "object", "properties": properties, "additionalProperties": False}
    required = [n for n in node.get("required", ()) if n in names]
    if required:
        schema["required"] = required
    return schema


def _refers(node: dict[str, Any]) -> bool:
    """Whether a field names ego or an object."""
    return any(n.get("pattern") == _REFERENCE for n in (node, *node.get("anyOf", ())))


def _referable(name: str, ids: tuple[str, ...]) -> list[str]:
    return [i for i in ids if name != "hidden_by" or i != "ego"]


def _array(node: dict[str, Any], defs: dict, name: str, ids: tuple[str, ...], allowed: dict) -> dict[str, Any]:
    if "prefixItems" in node:
        item = _node(node["prefixItems"][0], defs, name, ids, allowed)
        return {"type": "array", "items": item, "minItems": 2, "maxItems": 2}
    longest = limits()["lengths"].get(name, limits()["lengths"]["list"])
    return {"type": "array", "items": _node(node["items"], defs, name, ids, allowed), "maxItems": longest}


def accepts(schema: dict[str, Any], value: Any) -> str:
    """What is wrong with a value by such a schema, in a phrase; empty where nothing is."""
    errors = sorted(Draft202012Validator(schema).iter_errors(value), key=_rank)
    return _fault(errors[0]) if errors else ""


def _rank(error: ValidationError) -> tuple[int, int]:
    """What is told first: of the outermost object, fields that there are not, then those that lack."""
    order = ("additionalProperties", "required")
    return len(error.absolute_path), order.index(error.validator) if error.validator in order else len(order)


def _fault(error: ValidationError) -> str:
    """The first error in words that a model can follow."""
    where = error.json_path.removeprefix("$").lstrip(".") or "the answer"
    schema, value = error.schema, error.instance
    assert isinstance(schema, dict)
    if error.validator == "anyOf":
        meant = [n for n, choice in enumerate(schema["anyOf"]) if _meant(choice, value)]
        branch = meant[0] if meant else len(schema["anyOf"]) - 1 if isinstance(value, list) else 0
        of_branch = [e for e in error.context or () if e.schema_path[0] == branch]
        return _fault(min(of_branch or list(error.context or ()), key=_rank))
    if error.validator == "enum":
        return f"{where} must be one of {', '.join(map(str, schema['enum']))}, not {value!r}"
    if error.validator == "type":
        return f"{where} must be {_A[schema['type']]}"
    if error.validator in ("minimum", "maximum"):
        return f"{where} must lie between {schema['minimum']} and {schema['maximum']} (SI units), not {value}"
    if error.validator in ("minItems", "maxItems"):
        return f"{where} must have {schema.get('minItems', 0)} to {schema.get('maxItems')} items"
    if error.validator == "additionalProperties":
        extra = sorted(set(value) - set(schema["properties"]))
        return f"{where} has no field {extra[0]}; there are {', '.join(schema['properties'])}"
    if error.validator == "required":
        return f"{where} lacks {next(n for n in schema['required'] if n not in value)}"
    return f"{where}: {error.message}"


def _meant(choice: dict[str, Any], value: Any) -> bool:
    """Whether a value names the one word by which an object of that choice is told from the others."""
    single = {n: s["enum"][0] for n, s in choice.get("properties", {}).items() if len(s.get("enum", ())) == 1}
    return bool(single) and isinstance(value, dict) and all(value.get(n) == word for n, word in single.items())


_A = {
    "object": "an object", "array": "a list", "string": "a string", "number": "a number", "integer": "a whole number",
    "boolean": "true or false",
}  # fmt: skip
