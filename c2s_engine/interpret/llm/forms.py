"""The form of one component: the JSON schema of its answer, and the instructions that are made from that schema."""

from typing import Any, NamedTuple, get_args

from c2s_engine.interpret.llm import prose, words
from c2s_engine.interpret.llm.asking import prompt
from c2s_engine.interpret.llm.components import Sentences
from c2s_engine.interpret.llm.offered import offer
from c2s_engine.interpret.llm.schema import spec_schema
from c2s_engine.interpret.llm.units import plain
from c2s_engine.require.paces import paces_of
from c2s_engine.structure import vocabulary as v

Schema = dict[str, Any]
REQUIRED = ("distance", "closest", "visible", "not_visible")
"""What can be required: of the start, and how near two come."""
BY_ITSELF = ("time", "place", "speed", "light")
"""What somebody can wait for who is alone."""
_THINGS_STAND = {
    "ahead", "left_lane", "right_lane", "oncoming_lane", "roadside", "sidewalk", "partly_in_lane", "intersection_exit",
}  # fmt: skip
_NO_PERSONS = {"beside", "parked", "on_ramp", "crossing_left", "crossing_right", "opposite_approach", "circulating"}


class Form(NamedTuple):
    """Instructions and schema."""

    system: str
    schema: Schema


def form_of(cid: str, text: str, sentences: Sentences) -> Form:
    """The form of a component other than G among the others of a text."""
    others = [o for o in sentences.ids if o.startswith("O") and o != cid]
    kinds = {o: sentences.objects[int(o[1:]) - 1].type for o in others}
    earlier = [o for o in others if cid.startswith("O") and int(o[1:]) < int(cid[1:])]
    kind = cid[0]
    if kind == "O":
        told = sentences.objects[int(cid[1:]) - 1]
        kind = "thing" if words.is_thing(told.type) else "O"
        schema = _thing(told.type, earlier) if kind == "thing" else _road_user(told.type, others, earlier, kinds)
        if told.still:
            for name in ("speed", "pace", "phases"):
                schema["properties"].pop(name, None)
    elif kind == "E":
        schema = _ego(others, kinds)
    elif kind == "T":
        schema = _restrictions(["ego", *others])
    else:
        schema = spec_schema("R", ["ego", *others])
    types = (o.type.replace("_", " ") for o in sentences.objects)
    offer(schema, plain(" ".join((text, *map(sentences.of, sentences.ids), *types))))
    system = prompt(
        "fill", about=prose.table()[kind]["about"], fields=prose.fields(kind, schema),
        examples=prose.examples(kind, schema, others, earlier),
    ).strip()  # fmt: skip
    return Form(system, schema)


def _ego(others: list[str], kinds: dict[str, str]) -> Schema:
    schema = spec_schema("E", others, allowed={"action": words.all_actions(), "pace": paces_of("car")})
    _phases(schema, words.actions_for("vehicle"), kinds)
    return schema


def _restrictions(ids: list[str]) -> Schema:
    schema = spec_schema("T", ids)
    required = schema["properties"]["require"]["items"]["properties"]
    required["kind"]["enum"] = list(REQUIRED)
    del required["action"]
    return schema


def _thing(type_: str, earlier: list[str]) -> Schema:
    types = [t for t in get_args(v.ObjectType) if words.is_thing(t)]
    where = [p for p in get_args(v.Position) if p in _THINGS_STAND]
    schema = spec_schema("O", ["ego", *earlier], allowed={"type": types, "position": where})
    for name in ("phases", "speed", "pace", "model", *(["limit"] if type_ != "speed_sign" else [])):
        del schema["properties"][name]
    _placement(schema, earlier, ("along", "facing", "hidden_by", "arrives"))
    return schema


def _road_user(type_: str, others: list[str], earlier: list[str], kinds: dict[str, str]) -> Schema:
    person = type_ in words.PERSONS
    types = [t for t in get_args(v.ObjectType) if not words.is_thing(t) and (t in words.PERSONS) == person]
    where = [p for p in get_args(v.Position) if not person or p not in _NO_PERSONS]
    paces = paces_of("pedestrian" if person else type_)
    schema = spec_schema("O", ["ego", *others], allowed={"type": types, "position": where, "pace": paces})
    del schema["properties"]["limit"]
    _placement(schema, earlier, ())
    _phases(schema, words.actions_for(type_), {"ego": "car", **kinds})
    return schema


def _placement(schema: Schema, earlier: list[str], without: tuple[str, ...]) -> None:
    """Who is placed by another comes after it in the program; where there is none, it is ego."""
    placement = schema["properties"]["placement"]["properties"]
    if earlier:
        placement["of"]["enum"] = ["ego", *earlier]
    for name in (*without, "later", *(() if earlier else ("of",))):
        placement.pop(name, None)


def _phases(schema: Schema, actions: list[str], kinds: dict[str, str]) -> None:
    """The actions of a road user, and what it can wait for: an action that one of the others can take."""
    phase = schema["properties"]["phases"]["items"]["properties"]
    phase["action"]["enum"] = actions
    awaited = {a for kind in kinds.values() for a in words.actions_for(kind)}
    for trigger in (phase["trigger"]["properties"], phase["until"]["properties"]):
        if awaited:
            trigger["action"]["enum"] = [a for a in words.all_actions() if a in awaited]
        else:
            trigger["kind"]["enum"] = [k for k in trigger["kind"]["enum"] if k in BY_ITSELF]
            for name in ("subject", "of", "action"):
                trigger.pop(name, None)
