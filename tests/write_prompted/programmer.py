"""A model that can program, for the scripted server: it answers with the components of one of the example programs."""

import json
import re
from collections.abc import Callable
from typing import Any

from c2s_engine.structure.progress import Passage
from c2s_engine.write.prompted.examples import Example, examples
from tests.models.fake_ollama import said

EXAMPLE = examples()["02"]
TEXT = EXAMPLE.description
_TYPES = {"01": ["car"], "02": ["van", "pedestrian"]}


def asked_for(request: dict[str, Any]) -> str:
    """Which component a request wants written ("" for forms), and whether it is a repair: `repair O1`."""
    last = [m["content"] for m in request["messages"] if m["role"] == "user"][0]
    if match := re.search(r"Now write component (\w+):", last):
        return match[1]
    if match := re.search(r"Write component (\w+) again, corrected", last):
        return f"repair {match[1]}"
    return ""


class Programmer:
    """`slips`: component -> what it writes at first instead of what is right; `repairs`: whether it mends them."""

    def __init__(self, example: Example = EXAMPLE, slips: dict[str, str] | None = None, repairs: bool = True) -> None:
        self.parts = {f.id: f for f in example.fragments}
        self.example = example
        self.slips = slips or {}
        self.repairs = repairs
        self.wrap: Callable[[str], str] = lambda code: f"1. Understand ... 2. ...\n```scenic\n{code}\n```\nDone."

    def __call__(self, request: dict[str, Any]) -> str:
        wanted = asked_for(request)
        if not wanted:
            return json.dumps(self._form(request))
        again, _, cid = wanted.rpartition(" ")
        if cid in self.slips and not (again and self.repairs):
            return self.wrap(self.slips[cid])
        return self.wrap(self.parts[cid].code)

    def _form(self, request: dict[str, Any]) -> dict[str, Any]:
        if "confidence" in said(request):
            return {"weather": {"value": ["cloudy"], "confidence": 1}, "time": {"value": "day", "confidence": 0.9}}
        objects = [c for c in self.parts if c.startswith("O")]
        types = _TYPES[self.example.number]
        return {
            "settings": self.parts["G"].sentence,
            "place": self.parts["R"].sentence,
            "ego": self.parts["E"].sentence,
            "objects": [{"type": t, "sentence": self.parts[c].sentence} for t, c in zip(types, objects, strict=True)],
            "restrictions": self.parts["T"].sentence,
        }


class Library:
    """A retriever of two passages of each kind that notes what it was asked."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, str, str | None, int]] = []
        self.about: dict[str, tuple[str, ...]] = {}

    async def __call__(
        self, query: str, kind: str, component: str | None, limit: int, terms: tuple[str, ...] = ()
    ) -> list[Passage]:
        self.asked.append((query, kind, component, limit))
        self.about[query] = terms
        title = "A similar component" if kind == "snippet" else "Specifiers"
        text = "x = new Car ahead of ego by 10" if kind == "snippet" else "A specifier sets a property of an object."
        row = {"kind": kind, "title": title, "text": text, "score": 0.9, "component": component or ""}
        return [Passage(**row)] * min(limit, 2)
