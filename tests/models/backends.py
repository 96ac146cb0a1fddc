"""Models of bad character for the scripted server: random but of the schema, garbage, half JSON, nothing, endless."""

import json
import random
import string
from collections.abc import Callable
from typing import Any

import pytest

from tests.models.fake_ollama import Answer, Respond, endless


def draw(schema: dict[str, Any], rng: random.Random) -> Any:
    """A value of a JSON schema, drawn from all that it allows."""
    if "anyOf" in schema:
        return draw(rng.choice(schema["anyOf"]), rng)
    if "enum" in schema:
        return rng.choice(schema["enum"])
    kind = schema.get("type")
    if kind == "object":
        required = schema.get("required", ())
        return {n: draw(s, rng) for n, s in schema["properties"].items() if n in required or rng.random() < 0.5}
    if kind == "array":
        count = rng.randint(schema.get("minItems", 0), schema.get("maxItems", 3))
        return [draw(schema["items"], rng) for _ in range(count)]
    if kind == "integer":
        return rng.randint(schema["minimum"], schema["maximum"])
    if kind == "number":
        return round(rng.uniform(schema["minimum"], schema["maximum"]), rng.choice((0, 1, 3)))
    if kind == "boolean":
        return rng.random() < 0.5
    alphabet = string.ascii_letters + string.digits + " ._-'\"{}\\äß"
    return "".join(rng.choice(alphabet) for _ in range(rng.randint(0, min(40, schema.get("maxLength", 40)))))


def random_json(seed: int) -> Respond:
    """Answers every form with random JSON of its schema; what has no form with random words."""
    rng = random.Random(seed)

    def respond(request: dict[str, Any]) -> str:
        schema = request.get("format")
        return json.dumps(draw(schema, rng)) if schema else draw({"type": "string"}, rng)

    return respond


def half_json(seed: int) -> Respond:
    """Random JSON of the schema, broken off somewhere."""
    whole = random_json(seed)
    rng = random.Random(seed)

    def respond(request: dict[str, Any]) -> str:
        text = whole(request)
        return text[: rng.randint(0, max(1, len(text) - 1))]

    return respond


def garbage(seed: int) -> Respond:
    """Any characters."""
    rng = random.Random(seed)
    return lambda request: "".join(chr(rng.choice((rng.randint(32, 126), rng.randint(160, 0x2FF)))) for _ in range(300))


def wordy(seed: int) -> Respond:
    """Random JSON of the schema, wrapped in thoughts, words and a fence, as models that ignore `format` do."""
    whole = random_json(seed)
    return lambda request: (
        f"<think>{{hm}} let me see</think>Here is it:\n```json\n{whole(request)}\n```\nI hope this {{helps}}!"
    )


BAD: dict[str, Callable[[int], Respond]] = {
    "garbage": garbage,
    "half_json": half_json,
    "empty": lambda seed: lambda request: "",
    "endless": lambda seed: lambda request: Answer(endless('{"a": 1}, ')),
    "endless blanks": lambda seed: lambda request: Answer(endless(" \n")),
    "wrong form": lambda seed: lambda request: '{"objects": {"car": 1}, "behaviour": [null]}',
    "error": lambda seed: lambda request: Answer("some words", chunk=2, fault="error"),
    "busy": lambda seed: lambda request: Answer(status=503),
    "refused": lambda seed: lambda request: Answer(status=400, error="invalid format"),
}

FAST = ("garbage", "endless", "refused")
BAD_NAMES = [name if name in FAST else pytest.param(name, marks=pytest.mark.full) for name in BAD]
"""The bad characters as parameters: three in every run, the others in the full one."""
