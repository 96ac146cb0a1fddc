"""Scenes given as JSON or YAML, as lines of keys and values: {"ego": {"lane": "left"}} becomes "Ego lane: left"."""

import json
import re
from typing import Any

import yaml

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.reading.motions import third_person, third_persons
from c2s_engine.interpret.reading.rewritten import Replacement

FENCE = re.compile(r"\A\s*```(?:json|ya?ml)?[ \t]*\n(?P<inside>.*?)\n?```\s*\Z", re.DOTALL)
MAPPING = re.compile(r"^[ \t]*(?:-[ \t]+)?[\w\"'][\w \"'-]*:(?:[ \t]|$)", re.MULTILINE)
ALIASES = re.compile(r"^[^\n\"']*[:\-][ \t]+[&*]\w", re.MULTILINE)
"""What may say the same thing over and over."""
LONGEST = 20_000
"""Characters above which a text is no single scene."""


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
    if len(inside) > LONGEST or ALIASES.search(inside):
        return None
    try:
        if inside.lstrip().startswith("{"):
            return json.loads(inside)
        return yaml.safe_load(inside) if len(MAPPING.findall(inside)) >= 3 else None
    except (ValueError, yaml.YAMLError, RecursionError):
        return None


def _nested(value: Any) -> bool:
    return isinstance(value, dict) or isinstance(value, list) and any(isinstance(v, dict) for v in value)


def _of_mappings(data: dict[Any, Any]) -> bool:
    return bool(data) and all(isinstance(value, dict) for value in data.values())


def _ended(said: str) -> str:
    return said if said.endswith(".") else f"{said}."


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
            elif isinstance(value, dict) and not whose and not _of_mappings(value) and self._kind(value, key):
                self.actor(value, key)
            elif isinstance(value, dict):
                self.mapping(value, whose)
            elif isinstance(value, list) and _nested(value) and not whose:
                for item in value:
                    self._item(key, item)
            elif isinstance(value, list) and _nested(value):
                self._line(key, [self._deed(item) for item in value], whose)
            else:
                self._line(key, value, whose)

    def _item(self, key: str, item: Any) -> None:
        """One of a list: a road user, or something that is said of the scene."""
        if isinstance(item, dict):
            self.actor(item, key)
        elif item:
            self.said.append(_ended(str(item)))

    def _deed(self, item: Any) -> str:
        """One of the deeds of somebody: {"type": "brake", "to": "20 km/h"} is "brake to 20 km/h"."""
        if not isinstance(item, dict):
            return str(item)
        keys = {self._key(str(name)): value for name, value in item.items()}
        named = next((k for k in (*self.table["in_order"], *self.table["kinds"]) if k in keys), None)
        rest = (str(v) if k in self.table["plain"] else f"{k} {v}" for k, v in keys.items() if k != named)
        return " ".join([str(keys.get(named, "")), *rest]).strip()

    def of(self, whose: str, value: Any) -> None:
        """What is said of ego or a road user."""
        if isinstance(value, dict):
            self.mapping(value, whose)
        elif value not in (None, ""):
            self.said.append(f"{whose}: {value}")

    def actor(self, data: dict[Any, Any], key: str) -> None:
        """A road user: its type under a number, then what is said of it; ego under its own name."""
        named = {self._key(str(name)): str(value).lower() for name, value in data.items()}
        whose = "Ego"
        if not any(named.get(k) in language.table("notation")["egos"] for k in self.table["kinds"]):
            self.actors += 1
            whose = f"Actor {self.actors}"
            self.said.append(f"{whose}: {self._kind(data, key) or 'car'}")
        self.mapping({n: v for n, v in data.items() if self._key(str(n)) not in self.table["kinds"]}, whose)

    def _kind(self, data: dict[Any, Any], key: str) -> str | None:
        """The noun of a road user: the value of a key for it, else its own key ("car_1")."""
        keys = {self._key(str(name)): value for name, value in data.items()}
        said = [keys[k] for k in self.table["kinds"] if isinstance(keys.get(k), str)]
        for noun in (*said, re.sub(r"[ \d]+$", "", key)):
            plain = str(noun).replace("_", " ").lower()
            if any(span.kind == "actor" for span in scan.names(plain)):
                return plain
        return None

    def _key(self, name: str) -> str:
        spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
        return " ".join(re.sub(r"[_-]", " ", spaced).lower().split())

    def _line(self, key: str, value: Any, whose: str) -> None:
        unit = next((unit for end, unit in self.table["units"].items() if key.endswith(f" {end}")), "")
        key = re.sub(rf" (?:{'|'.join(self.table['units'])})$", "", key)
        if value in (None, "", [], "none", "None") or isinstance(value, bool):
            return
        values = [str(v) for v in value] if isinstance(value, list) else [str(value)]
        if len(values) > 1 and all(len(v.split()) > 3 for v in values) and not whose:  # sentences
            self.said += [_ended(v) for v in values]
            return
        acts = key in self.table["in_order"]
        said = " and then ".join(_does(v) for v in values) if acts else ", ".join(values)
        said = said.replace("_", " ") + (f" {unit}" if unit and re.fullmatch(r"-?[\d.]+", said) else "")
        if key in self.table["told"]:
            self.said.append(_ended(said))
        else:
            self.said.append(f"{whose} {key}: {said}" if whose else f"{key[:1].upper()}{key[1:]}: {said}")
