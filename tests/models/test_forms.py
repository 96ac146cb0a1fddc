"""A form's prose and its schema say the same: each name, each choice and their order, for any scenario."""

import itertools
import json
import random
import re
from pathlib import Path
from typing import Any, Literal, get_args

import pytest
import yaml
from pydantic import Field

from c2s_engine.interpret.llm import offered, prose, rendered_sentences, settings
from c2s_engine.interpret.llm.components import ObjectSentence, Sentences, excerpt, instructions, sentences_schema
from c2s_engine.interpret.llm.forms import Form, form_of
from c2s_engine.interpret.llm.schema import accepts, spec_schema
from c2s_engine.interpret.llm.units import annotate, quantities
from c2s_engine.require.paces import paces_of
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import SPEC_OF, EgoSpec, ObjectSpec, Phase, Placement, Reference, Spec, Trigger
from c2s_engine.write.typed import contradiction
from c2s_engine.write.typed.contradictions import FITS

CASES = yaml.safe_load((Path(__file__).parent / "offered.yaml").read_text(encoding="utf-8"))
SILENT = "Somebody is at some spot."
_FIELD = re.compile(r"(?:^|; )(\w+)(?: \(([^()]*)\))?(?=:|;|$)")


def drawn(seed: int) -> list[tuple[str, Form]]:
    """The forms of a random scenario."""
    rng = random.Random(seed)
    kinds = [rng.choice(get_args(v.ObjectType)) for _ in range(rng.randint(0, 5))]
    objects = tuple(ObjectSentence(type=k, sentence=f"A {k}.", still=rng.random() < 0.3) for k in kinds)
    sentences = Sentences(place="A road.", ego="Ego drives.", objects=objects, restrictions="It ends.")
    text = " ".join(case["says"] for case in CASES if rng.random() < rng.choice((0, 0.1, 1)))
    return [(cid, form_of(cid, text, sentences)) for cid in sentences.ids[1:]]


def prose_of(form: Form) -> list[tuple[int, str, list[str]]]:
    """(depth, field, choices) of each field that the instructions explain, in their order."""
    found: list[tuple[int, str, list[str]]] = []
    explained: dict[str, list[str]] = {}
    told = form.system.partition("Fields in order:\n")[2].partition("\n\n")[0]
    for line in told.splitlines():
        mark = re.match(r"(-*) ", line)
        assert mark, line
        if not mark[1]:  # the choices of the field before it
            _, name, choices = found[-1]
            choices += line.strip().split(": ")[0].split(", ")
            explained[name] = choices
            continue
        for field in _FIELD.finditer(line[mark.end() :]):
            listed = field[2].split(", ") if field[2] else []
            if copied := re.search(rf"{field[1]}: [^;]*, fields as (\w+)", line):
                found.append((len(mark[1]), field[1], []))
                found += _below(found, copied[1])
                continue
            if listed[:1] == ["as above"]:
                listed = [*explained[field[1]], *listed[1:]]
            elif beside := re.fullmatch(r"as (\w+)", ", ".join(listed)):
                listed = next(choices for _, name, choices in reversed(found) if name == beside[1])
            found.append((len(mark[1]), field[1], listed))
            explained.setdefault(field[1], listed)
    return found


def _below(found: list[tuple[int, str, list[str]]], name: str) -> list[tuple[int, str, list[str]]]:
    """What was told of the fields of one."""
    at = max(i for i, row in enumerate(found) if row[1] == name)
    return list(itertools.takewhile(lambda row: row[0] > found[at][0], found[at + 1 : -1]))


def schema_of(schema: dict[str, Any], depth: int = 1) -> list[tuple[int, str, list[str]]]:
    found: list[tuple[int, str, list[str]]] = []
    for name, node in schema["properties"].items():
        inner = node.get("items", node)
        found.append((depth, name, [str(c) for c in inner.get("enum", ())]))
        if "properties" in inner:
            found += schema_of(inner, depth + 1)
    return found


@pytest.mark.parametrize("seed", range(40))
def test_the_prose_names_what_the_schema_has_in_its_order(seed):
    for cid, form in drawn(seed):
        told, asked = prose_of(form), schema_of(form.schema)
        assert [t[:2] for t in told] == [a[:2] for a in asked], cid
        assert in_any_order(told) == in_any_order(asked), cid


def in_any_order(rows: list[tuple[int, str, list[str]]]) -> list[tuple[str, list[str]]]:
    """The fields with their choices sorted."""
    return [(name, sorted(choices)) for _, name, choices in rows]


@pytest.mark.parametrize("seed", range(40))
def test_every_reference_in_backquotes_is_a_field(seed):
    for cid, form in drawn(seed):
        fields = {name for _, name, _ in schema_of(form.schema)}
        assert set(re.findall(r"`(\w+)`", form.system)) <= fields, cid


@pytest.mark.parametrize("seed", range(40))
def test_examples_are_answers_of_the_form_in_its_order(seed):
    for cid, form in drawn(seed):
        shown = [json.loads(line) for line in form.system.splitlines() if line.startswith("{")]
        assert shown, cid
        for value in shown:
            assert accepts(form.schema, value) == "" and json.dumps(prose.in_order(form.schema, value)) == json.dumps(
                value
            )
        assert f"({cid})" not in form.system, "an example that speaks of the form's own object as of another"


@pytest.mark.parametrize("says", [SILENT, "The light turns green after 5 s."])
def test_the_detector_tells_its_fields_as_every_form_does(says):
    form, asked = settings.form_of(says), settings.asked(says)
    assert in_any_order(prose_of(form)) == in_any_order(schema_of(asked))
    values = {n: f.get("properties", {}).get("value", f) for n, f in form.schema["properties"].items()}
    assert values == asked["properties"]
    shown = [json.loads(line) for line in form.system.splitlines() if line.startswith("{")]
    assert shown and not [fault for answer in shown if (fault := accepts(form.schema, answer))]


@pytest.mark.full
def test_every_example_is_shown_by_some_form():
    """None is of fields that there are no more."""
    told = "\n".join(form.system for seed in range(40) for _, form in drawn(seed))
    told += settings.form_of("The light is red.").system
    for kind in ("G", "R", "E", "O", "thing", "T"):
        for example in prose.table()[kind]["examples"]:
            pattern = re.escape(example["says"]).replace(r"\{other\}", r"\w+").replace(r"\{ahead\}", r"\w+")
            assert re.search(pattern, told), example["says"]


def test_the_splitter_tells_its_fields_in_order():
    told = re.findall(r"^-+ (\w+):", instructions(), re.M)
    schema = sentences_schema()["properties"]
    objects = list(schema["objects"]["items"]["properties"])
    names = [n for name in schema for n in ((name, *objects) if name == "objects" else (name,))]
    assert told == names
    assert all(t in instructions() for t in get_args(v.ObjectType))


def test_forms_of_what_never_moves_ask_for_no_motion():
    told = ObjectSentence(type="van", sentence="A van is parked.", still=True)
    form = form_of("O1", "", Sentences(objects=(told,)))
    assert not {"speed", "phases", "of", "hidden_by"} & set(form.schema["properties"])
    assert len(form.system) < 1600


def test_nothing_is_forced_where_nobody_else_is_there():
    form = form_of("E", "It moves off 2 s later.", Sentences(ego="Ego drives."))
    trigger = form.schema["properties"]["phases"]["items"]["properties"]["trigger"]["properties"]
    assert trigger["kind"]["enum"] == ["time", "place"] and list(trigger) == ["kind", "value", "place", "delay"]
    assert accepts(form.schema, {}) == "" and accepts(form_of("R", "", Sentences()).schema, {}) == ""


def test_a_long_report_is_shown_in_its_part():
    report = (
        "A van stood at the kerb. " + "The witness had been at work all day. " * 20 + "The van pulled out at 20 km/h."
    )
    shown = excerpt(report, "A van pulls out from the kerb.")
    assert "kerb" in shown and "pulled out" in shown and "witness" not in shown and len(shown) < 240
    assert excerpt("It rains.", "anything") == "It rains."


def asked(case: dict[str, Any], says: str) -> set[str]:
    """`container.field` and `field=choice` of the form that a case is about, for such a text."""
    if case.get("of") == "G":
        return offers_of(settings.asked(says), "settings")
    others = tuple(ObjectSentence(type="van", sentence="A van.") for _ in range(case.get("others", 0)))
    told = ObjectSentence(type=case.get("type", "car"), sentence=SILENT)
    form = form_of(case.get("of", "O1"), says, Sentences(place=SILENT, ego=SILENT, objects=(told, *others)))
    return offers_of(form.schema)


def offers_of(schema: dict[str, Any], within: str = "form") -> set[str]:
    found: set[str] = set()
    for name, node in schema["properties"].items():
        inner = node.get("items", node)
        found |= {f"{within}.{name}", *(f"{name}={c}" for c in inner.get("enum", ()))}
        if "properties" in inner:
            found |= offers_of(inner, name)
    return found


@pytest.mark.parametrize("case", CASES, ids=lambda c: c["says"][:40])
def test_a_field_is_offered_where_a_text_says_such_a_thing(case):
    assert set(case["offers"]) <= asked(case, case["says"])


@pytest.mark.full
def test_what_is_offered_only_where_it_applies_is_not_where_a_text_says_nothing_of_it():
    table = offered.table()
    rare = {f"{within}.{name}" for within, fields in table["fields"].items() for name in fields}
    rare |= {f"{name}={choice}" for name, choices in table["choices"].items() for choice in choices}
    assert rare <= {o for case in CASES for o in case["offers"]}, "each has a text that says such a thing"
    for case in CASES:
        assert not rare & asked(case, SILENT), case["says"]
    groups = [g for f in table["fields"].values() for n in f.values() for g in n["said"]]
    groups += [g for choices in table["choices"].values() for named in choices.values() for g in named]
    groups += [g for named in table["asked"].values() for g in named]
    assert set(groups) == set(table["groups"])


@pytest.mark.parametrize("kind", ["R", "E", "O", "T"])
def test_every_field_and_choice_of_the_specs_is_offered_by_some_form(kind):
    """On a text that says of everything something: none is out of reach."""
    text = " ".join(case["says"] for case in CASES)
    types = get_args(v.ObjectType)
    reached: set[str] = set()
    for type_ in types if kind == "O" else ("car",):
        told = (ObjectSentence(type="van", sentence="A van."), ObjectSentence(type=type_, sentence="It is there."))
        told += tuple(ObjectSentence(type=t, sentence="It is there.") for t in ("pedestrian", "bicycle"))
        sentences = Sentences(place="A road.", ego="Ego drives.", objects=told, restrictions="It ends.")
        reached |= offers_of(form_of("O2" if kind == "O" else kind, text, sentences).schema)
    whole = offers_of(spec_schema(kind, ["ego", "O1", "O2", "O3", "O4"]))
    whole.discard("require.action")  # at the start nothing has been done
    whole.discard("placement.later")  # the planner's
    if kind == "E":
        whole -= {f"pace={p}" for p in get_args(v.Pace) if p not in paces_of("car")}
    references = {f"{n}={c}" for n in ("of", "target", "hidden_by", "subject", "other", "react_to")
                  for c in ("ego", "O1", "O2", "O3", "O4")}  # fmt: skip
    assert whole - references <= reached


@pytest.mark.parametrize(
    ("type_", "without"),
    [
        ("pedestrian", {"phases.lateral_speed", "position=parked"}),
        ("cone", {"placement.arrives", "placement.hidden_by", "phases.action"}),
    ],
)
def test_a_field_comes_only_with_what_takes_it(type_, without):
    text = " ".join(case["says"] for case in CASES)
    assert not without & asked({"type": type_}, text)


def test_what_the_choice_beside_it_does_not_take_is_left_out_of_an_answer_and_said():
    answer = {
        "placement": {"position": "ahead", "gap": 20, "lateral": 1.5},
        "phases": [{"action": "brake", "gap": 5, "part": "front"}, {"action": "collide", "part": "rear"}],
    }
    assert offered.pop_inapplicable_fields(answer) == ["lateral 1.5", "part front"]
    assert answer == {
        "placement": {"position": "ahead", "gap": 20},
        "phases": [{"action": "brake", "gap": 5}, {"action": "collide", "part": "rear"}],
    }
    assert contradiction(Structure(text="", objects=(Component(id="O1", spec=ObjectSpec(**answer)),))) is None


def test_the_forms_and_the_writer_agree_on_what_takes_a_field():
    fields = offered.table()["fields"]
    assert {n: tuple(fields["phases"][n]["with"]["action"]) for n in FITS} == FITS
    for name in ("lateral", "arrives"):
        for position in get_args(v.Position):
            spec = ObjectSpec(placement=Placement(position=position, side="right", **{name: 1}))
            found = contradiction(Structure(text="", objects=(Component(id="O1", spec=spec),)))
            refused = found is not None and f"O.placement.{name}" in found.fields
            assert refused == (position not in fields["placement"][name]["with"]["position"]), (name, position)


@pytest.mark.parametrize(("said", "choices"), [("Ego hits a car.", "as part"), ("Ego follows a car.", "")])
def test_choices_that_two_fields_share_are_listed_once(said, choices):
    told = (ObjectSentence(type="car", sentence="A car."),)
    told_of = {name: c for _, name, c in prose_of(form_of("E", said, Sentences(ego=said, objects=told)))}
    assert (f"target_part ({choices})" in form_of("E", said, Sentences(ego=said, objects=told)).system) == bool(choices)
    assert told_of.get("target_part", []) == (list(get_args(v.Part)) if choices else [])


class _Contact(Spec):
    part: Literal["front", "rear"] | None = Field(None, description="where it is hit")
    by: Reference | None = Field(None, description="who hits it")


class _Phase(Phase):
    modality: Literal["attempt", "abort"] | None = Field(None, description="whether it comes to that")
    contact: _Contact | None = Field(None, description="how both touch")


class _Object(ObjectSpec):
    phases: tuple[_Phase, ...] = Field((), description="what it does")
    width: float | None = Field(None, description="how wide it is, m")


@pytest.mark.parametrize("others", [0, 2])
def test_a_new_field_of_the_specs_is_in_schema_and_prose(monkeypatch, others):
    monkeypatch.setitem(SPEC_OF, "O", _Object)
    told = tuple(ObjectSentence(type="car", sentence="A car.") for _ in range(others + 1))
    form = form_of("O1", "", Sentences(objects=told))
    assert [t[:2] for t in prose_of(form)] == [a[:2] for a in schema_of(form.schema)]
    fields = {name for _, name, _ in schema_of(form.schema)}
    assert {"modality", "contact", "part", "by", "width"} <= fields, "a reference can always be ego"
    assert "whether it comes to that" in form.system and "who hits it" in form.system
    phase = form.schema["properties"]["phases"]["items"]["properties"]
    assert phase["contact"]["properties"]["by"]["enum"] == ["ego", *(f"O{i}" for i in range(2, others + 2))]
    shown = [json.loads(line) for line in form.system.splitlines() if line.startswith("{")]
    assert shown and all(accepts(form.schema, value) == "" for value in shown)


def test_notes_of_quantities_are_not_doubled():
    once = annotate("It walks at 1.5 km/h.")
    assert annotate(once) == once and once.count("[=") == 1
    assert quantities("25 m ahead at 36 km/h, after 2 to 3 s") == [
        ("25 m", 25), ("36 km/h", pytest.approx(10)), ("2 to 3 s", 2), ("2 to 3 s", 3)
    ]  # fmt: skip


VAN = ObjectSpec(
    name="van", type="van", placement=Placement(position="ahead", gap=20),
    phases=(Phase(action="brake", trigger=Trigger(kind="action", of="O2", action="cross_road")),),
)  # fmt: skip
CHILD = ObjectSpec(name="child", type="child", placement=Placement(position="sidewalk", side="left"))


@pytest.mark.parametrize(
    ("said", "lost"),
    [
        ("A van drives 20 m ahead of ego and brakes when the child crosses the road.", []),
        ("A van 20 m ahead brakes.", []),
        ("A van 35 m ahead brakes.", ["35 m"]),
        ("A van at 50 km/h, 20 m ahead, brakes.", ["50 km/h"]),
        ("A van 20 m ahead slowly brakes.", ["slowly"]),
        ("A van 20 m ahead brakes and swerves.", ["swerves"]),
        ("A van 20 m ahead brakes, its horn blaring loudly at somebody", ["loudly"]),
        ("A van 20 m ahead brakes, with broken headlamps.", ["with broken headlamps"]),
    ],
)
def test_a_sentence_is_made_from_the_spec_and_what_it_lost_is_listed(said, lost):
    objects = (Component(id="O1", spec=VAN), Component(id="O2", spec=CHILD))
    s = rendered_sentences.with_rendered_sentences(Structure(text=said, objects=objects), {"O1": said})
    assert s["O1"].description == (
        "A van ahead of ego in the same lane, 20 m away; it brakes (brake when the child begins to cross the road)."
    )
    assert [u.text for u in s["O1"].unmet] == lost
    assert all(said[slice(*u.span)] == u.text for u in s["O1"].unmet if u.span)
    assert s["O2"].description == "" and s.ego.spec == EgoSpec(), "what the model said nothing of has no sentence"
