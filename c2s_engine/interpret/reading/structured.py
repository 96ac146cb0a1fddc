"""Scenes given as JSON or YAML, as lines of keys and values: {"ego": {"lane": "left"}} becomes "Ego lane: left"."""

import re
from typing import Any

import yaml

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import third_person, third_persons
from c2s_engine.interpret.reading.rewritten import Replacement

FENCE = re.compile(r"\A\s*```(?:json|ya?ml)?[ \t]*\n(?P<inside>.*?)\n?```\s*\Z", re.DOTALL)
MAPPING = re.compile(r"^[ \t]*(?:-[ \t]+)?[\w\"'][\w \"'-]*:(?:[ \t]|$)", re.MULTILINE)


def structured(text: str) -> list[Replacement]:
    """The lines that the whole text stands for; none where it is no nested mapping."""
    data = _loaded(text)
    if not isinstance(data, dict) or not any(_nested(value) for value in data.values()):
        return []
    lines = Lines()
    lines.mapping(data)
    return [(0, len(text), "\n".join(lines.said))] if lines.said else []


def _loaded(text: str) -> Any:
    fenced = FENCE.match(text)
    inside = fenced["inside"] if fenced else text
    try:
        return yaml.safe_load(inside) if len(MAPPING.findall(inside)) >= 3 else None
    except (ValueError, yaml.YAMLError, RecursionError):
        return None


def _nested(value: Any) -> bool:
    return isinstance(value, dict) or isinstance(value, list) and any(isinstance(v, dict) for v in value)


def _does(said: str) -> str:
    """What somebody does in the third person: "overtake_ego" is "overtakes ego"."""
    first, _, rest = said.replace("_", " ").strip().partition(" ")
    third = third_person(first)
    return f"{third if third.lower() in third_persons() else first} {rest}".strip()


class Lines:
    """The lines of keys and values, with a number for each road user."""

    def __init__(self) -> None:
        self.table: dict[str, Any] = language.table("structured")
        self.said: list[str] = []
        self.actors = 0

    def mapping(self, data: dict[Any, Any], whose: str = "") -> None:
        """All that a mapping says, of ego or a road user (`whose`) or of the scene."""
        for name, value in data.items():
            key = self._key(str(name))
            if key in self.table["left_out"]:
                continue
            if key in language.table("notation")["egos"]:
                self.of("Ego", value)
            elif isinstance(value, list) and not whose:
                for item in value:
                    self._item(key, item)
            else:
                self._line(key, value, whose)

    def _item(self, key: str, item: Any) -> None:
        """One of a list: a road user, or something that is said of the scene."""
        if isinstance(item, dict):
            self.actor(item, key)

    def _deed(self, item: Any) -> str:
        """One of the deeds of somebody: {"type": "brake", "to": "20 km/h"} is "brake to 20 km/h"."""
        keys = {self._key(str(name)): value for name, value in item.items()}
        named = next((k for k in (*self.table["in_order"], *self.table["kinds"]) if k in keys), None)
        rest = (str(v) if k in self.table["plain"] else f"{k} {v}" for k, v in keys.items() if k != named)
        return " ".join([str(keys.get(named, "")), *rest]).strip()

    def of(self, whose: str, value: Any) -> None:
        """What is said of ego or a road user."""
        if value not in (None, ""):
            self.said.append(f"{whose}: {value}")

    def actor(self, data: dict[Any, Any], key: str) -> None:
        """A road user: its type under a number, then what is said of it; ego under its own name."""
        named = {self._key(str(name)): str(value).lower() for name, value in data.items()}
        whose = "Ego"
        if not any(named.get(k) in language.table("notation")["egos"] for k in self.table["kinds"]):
            self.actors += 1
            whose = f"Actor {self.actors}"
            self.said.append(f"{whose}: {'car'}")
        self.mapping({n: v for n, v in data.items() if self._key(str(n)) not in self.table["kinds"]}, whose)

    def _key(self, name: str) -> str:
        spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
        return " ".join(re.sub(r"[_-]", " ", spaced).lower().split())

    def _line(self, key: str, value: Any, whose: str) -> None:
        unit = next((unit for end, unit in self.table["units"].items() if key.endswith(f" {end}")), "")
        key = re.sub(rf" (?:{'|'.join(self.table['units'])})$", "", key)
        values = [str(v) for v in value] if isinstance(value, list) else [str(value)]
        acts = key in self.table["in_order"]
        said = " and then ".join(_does(v) for v in values) if acts else ", ".join(values)
        said = said.replace("_", " ") + (f" {unit}" if unit else "")
        self.said.append(f"{whose} {key}: {said}" if whose else f"{key[:1].upper()}{key[1:]}: {said}")
