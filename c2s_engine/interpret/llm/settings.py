"""The paper's SettingsDetector: map, weather, time, light and ego's model, each with a confidence."""

import re
from typing import Any, get_args

from pydantic import BaseModel, ConfigDict

from c2s_engine.interpret.llm import prose
from c2s_engine.interpret.llm.asking import Asker, prompt
from c2s_engine.interpret.llm.forms import Form
from c2s_engine.interpret.llm.offered import offer
from c2s_engine.interpret.llm.schema import limits
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Assumption, Unmet
from c2s_engine.structure.specs import LightChange, SettingsSpec, Trigger

ACCEPTED = 0.6
"""From this confidence on a detected setting is taken (the paper, Algorithm 1); else the default stands."""

BLUEPRINT = re.compile(r"[a-z]+(\.[a-z0-9_]+)+")
TOWN = re.compile(r"Town\d\d(HD|_Opt)?")
CHANGES_BY = ("place", "time")
"""By what a text tells when a light changes."""


class Detected(BaseModel):
    """The settings that were taken, and those that were not with the reason."""

    model_config = ConfigDict(frozen=True)

    spec: SettingsSpec
    ego_model: str | None = None
    assumed: tuple[Assumption, ...] = ()
    unmet: tuple[Unmet, ...] = ()


def asked(text: str) -> dict[str, Any]:
    """The schema of the settings that a text can tell of, without their confidences."""
    word = {"type": "string", "maxLength": limits()["lengths"]["string"]}
    schema = {
        "type": "object",
        "properties": {
            "map": word,
            "weather": {"type": "array", "items": _enum(v.Weather), "maxItems": limits()["lengths"]["weather"]},
            "time": _enum(v.TimeOfDay),
            "light": _enum(v.LightState),
            "light_changes": _changes(),
            "ego_model": word,
            "unmet": {"type": "string", "maxLength": limits()["lengths"]["unmet"]},
        },
        "additionalProperties": False,
    }
    offer(schema, text, "settings")
    return schema


def form_of(text: str) -> Form:
    """The detector's form for a text: each setting with a confidence."""
    plain = asked(text)
    fields = {name: node if name == "unmet" else _sure(node) for name, node in plain["properties"].items()}
    schema = {**plain, "properties": fields}
    told = {"fields": prose.fields("G", plain), "examples": prose.examples("G", schema, [], [])}
    return Form(prompt("settings", **told), schema)


def _sure(value: dict[str, Any]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {"value": value, "confidence": {"type": "number", "minimum": 0, "maximum": 1}},
        "required": ["value", "confidence"],
        "additionalProperties": False,
    }


def _changes() -> dict[str, Any]:
    low, high = limits()["numbers"]["value"]
    fields = {
        "to": _enum(v.LightState),
        "kind": {"type": "string", "enum": list(CHANGES_BY)},
        "value": {"type": "number", "minimum": low, "maximum": high},
    }
    change = {"type": "object", "properties": fields, "required": list(fields), "additionalProperties": False}
    return {"type": "array", "items": change, "maxItems": limits()["lengths"]["list"]}


def _enum(literal: Any) -> dict[str, Any]:
    return {"type": "string", "enum": list(get_args(literal))}


def _change(said: dict[str, Any]) -> LightChange:
    place = "stop_line" if said["kind"] == "place" else None
    return LightChange(to=said["to"], when=Trigger(kind=said["kind"], value=said["value"], place=place))


async def detect(text: str, asker: Asker) -> Detected:
    """The settings of a text; raises ModelError."""
    form = form_of(text)
    return await asker.form(form.system, text, form.schema, purpose="settings", component="G", build=accepted)


def accepted(found: dict[str, Any]) -> Detected:
    """What of an answer is taken: confident enough, and naming what there is."""
    taken: dict[str, Any] = {}
    assumed: list[Assumption] = []
    for name in ("map", "weather", "time", "light", "light_changes", "ego_model"):
        if name not in found or found[name]["value"] in ("", []):
            continue
        value, confidence = found[name]["value"], found[name]["confidence"]
        form = {"map": TOWN, "ego_model": BLUEPRINT}.get(name)
        if form and not form.fullmatch(value):
            continue
        if confidence >= ACCEPTED:
            taken[name] = value
        else:
            reason = f"{value} was detected with a confidence of {confidence:.2f} only"
            assumed.append(Assumption(field="model" if name == "ego_model" else name, value="default", reason=reason))
    weather = tuple(dict.fromkeys(taken.get("weather", ())))
    if len(weather) > 1:
        weather = tuple(w for w in weather if w != "clear")
    light = {"light": taken.get("light"), "light_changes": tuple(map(_change, taken.get("light_changes", ())))}
    spec = SettingsSpec(map=taken.get("map"), weather=weather, time=taken.get("time"), **light)
    unmet = (Unmet(text=found["unmet"], reason="no setting says this"),) if found.get("unmet") else ()
    return Detected(spec=spec, ego_model=taken.get("ego_model"), assumed=tuple(assumed), unmet=unmet)
