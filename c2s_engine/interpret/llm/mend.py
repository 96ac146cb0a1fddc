"""Harmless slips of a model's JSON set right before it is judged: nulls, letter case, numbers as strings."""

import re
from typing import Any


def mend(schema: dict[str, Any], value: Any) -> Any:
    """The value with its slips set right as far as the schema tells how; what remains wrong is left as it is."""
    if "anyOf" in schema:
        choice = next((c for c in schema["anyOf"] if (c.get("type") == "array") == isinstance(value, list)), None)
        value = mend(choice, value) if choice else value
        if isinstance(value, list) and len(value) == 1:
            return value[0]
        return value
    if "enum" in schema:
        return _word(schema["enum"], value)
    kind = schema.get("type")
    if kind == "object" and isinstance(value, dict):
        known, needed = schema["properties"], schema.get("required", ())
        told = {n: v for n, v in value.items() if v is not None and (v != "" or n in needed)}
        kept = {n: mend(known[n], v) if n in known else v for n, v in told.items()}
        return {n: v for n, v in kept.items() if v is not None}
    if kind == "array":
        return _array(schema, value)
    if kind in ("number", "integer") and isinstance(value, str):
        return _number(value, kind)
    if kind == "integer" and isinstance(value, float) and value.is_integer():
        return int(value)
    return value


def _word(words: list[Any], value: Any) -> Any:
    if value in words or not isinstance(value, str):
        return value
    plain = re.sub(r"[\s-]+", "_", value.strip().lower())
    same = {str(w).lower(): w for w in words}
    if plain in ("null", "unknown", "n/a") and plain not in same:
        return None
    return same.get(plain, value)


def _array(schema: dict[str, Any], value: Any) -> Any:
    items = schema["items"]
    if not isinstance(value, list):
        value = [value]
    value = [v for v in (mend(items, v) for v in value if v is not None) if v is not None]
    pair = schema.get("minItems") == schema.get("maxItems") == 2 and items.get("type") == "number"
    if pair and len(value) == 2 and all(isinstance(v, int | float) for v in value):
        return sorted(value)
    return value


def _number(text: str, kind: str) -> Any:
    match = re.fullmatch(r"\s*(-?\d+(?:\.\d+)?)\s*(?:m|s|m/s|m/s2|m/s\^2)?\s*", text)
    if not match:
        return text
    number = float(match[1])
    return int(number) if kind == "integer" and number.is_integer() else number
