"""From a model's answer to a JSON value: models that ignore `format` wrap it in words, fences or thoughts."""

import json
import re
from typing import Any

from c2s_engine.models.errors import AnswerUnusable

_THOUGHT = re.compile(r"<think(?:ing)?>.*?(?:</think(?:ing)?>|\Z)", re.S)
_FENCE = re.compile(r"```[a-zA-Z]*\s*\n?(.*?)(?:```|\Z)", re.S)


def json_object(text: str) -> dict[str, Any]:
    """The JSON object in an answer; raises AnswerUnusable with what was wrong."""
    text = _THOUGHT.sub("", text).strip()
    if not text:
        raise AnswerUnusable("it is empty")
    fenced = _FENCE.search(text)
    for candidate in (text, fenced[1] if fenced else "", text[text.find("{") :] if "{" in text else ""):
        value = _first(candidate.strip())
        if isinstance(value, dict):
            return value
    if "{" in text:
        raise AnswerUnusable("its JSON is broken")
    raise AnswerUnusable("it holds no JSON object")


def _first(text: str) -> Any:
    if not text:
        return None
    try:
        return json.JSONDecoder().raw_decode(text)[0]
    except (ValueError, RecursionError):
        return None
