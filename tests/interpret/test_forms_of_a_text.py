"""One scene in many forms: lists, lines, points, mails, JSON, YAML. Each is the scene that plain sentences tell."""

import json

import pytest
import yaml

from c2s_engine.interpret import EmbeddedInterpreter
from c2s_engine.interpret.reading.structured import structured

EGO = "go drives at 90 km/h in the right lane of a two-lane motorway"
CAR = "car in the left lane, 20 m behind ego, overtakes ego and cuts in"
TRUCK = "truck 60 m ahead of ego drives at 70 km/h"
PLAIN = f"E{EGO}. A {CAR}. A {TRUCK}."
DATA = {
    "road": "two-lane motorway",
    "ego": {"speed": "90 km/h", "lane": "right"},
    "actors": [
        {"type": "car", "position": "left lane, 20 m behind ego", "action": "overtakes ego and cuts in"},
        {"type": "truck", "position": "60 m ahead of ego", "speed": "70 km/h"},
    ],
}
BY_NAME = {
    "ego_vehicle": {"speed_kmh": 90, "lane": "right"},
    "road": {"type": "motorway", "lanes": 2},
    "vehicles": {
        "car_1": {"position": "left lane, 20 m behind ego", "behaviors": ["overtake_ego", "cut in"]},
        "truck_1": {"position": "60 m ahead of ego", "speed_kph": 70},
    },
}
FORMS = {
    "lines": "Two-lane motorway\nego: right lane, 90 km/h\ncar1: left lane, 20 m behind ego, overtakes ego and cuts in"
    "\ntruck1: 60 m ahead of ego, 70 km/h",
    "labels": "ego: right lane, 90 km/h. car 1: left lane, 20 m behind ego, overtakes ego and cuts in."
    " truck 1: 60 m ahead of ego, 70 km/h. Two-lane motorway.",
    "points": f"1) E{EGO} 2) A {CAR} 3) A {TRUCK}",
    "list": f"1. E{EGO}.\n2. A {CAR}.\n3. A {TRUCK}.",
    "heads": "ROAD: two-lane motorway. EGO: 90 km/h, right lane. ACTOR 1 (car): left lane, 20 m behind ego; overtakes"
    " ego and cuts in. ACTOR 2 (truck): 60 m ahead of ego, 70 km/h.",
    "mail": f"Hi team,\n\nplease build this one for me: e{EGO}. A {CAR}. A {TRUCK}.\n\nBest regards,\nTom",
    "given": f"Given a two-lane motorway\nAnd e{EGO}\nAnd a {TRUCK}\nWhen a car in the left lane, 20 m behind ego,"
    " overtakes ego\nThen the car cuts in",
    "comment": f"# E{EGO}. A car in the left lane,\n# 20 m behind ego, overtakes ego and cuts in.\n# A {TRUCK}.",
    "json": json.dumps(DATA),
    "fenced": f"```json\n{json.dumps(DATA, indent=2)}\n```",
    "yaml": yaml.safe_dump(DATA, sort_keys=False),
    "names": yaml.safe_dump(BY_NAME, sort_keys=False),
}


def _shown(text: str) -> tuple:
    structure = EmbeddedInterpreter().interpret(text).structure
    place = structure.place.spec
    others = [
        (o.spec.type, o.spec.placement.position, o.spec.placement.along, o.spec.placement.gap, o.spec.speed)
        + tuple(p.action for p in o.spec.phases)
        for o in structure.objects
    ]
    return place.kind, place.lanes, place.ego_lane, structure.ego.spec.speed, sorted(others)


@pytest.mark.parametrize("form", FORMS)
def test_each_form_is_the_scene(form: str) -> None:
    assert _shown(FORMS[form]) == _shown(PLAIN)


def test_deeds_that_are_mappings_themselves() -> None:
    deeds = [{"type": "cut_in", "side": "from the left"}, {"type": "brake", "to": "40 km/h"}]
    data = {"ego": {"speed": "60 km/h"}, "actors": [{"type": "van", "position": "left lane", "actions": deeds}]}
    plain = "Ego drives at 60 km/h. A van in the left lane cuts in from the left and then brakes to 40 km/h."
    assert _shown(json.dumps(data)) == _shown(plain)


def test_what_is_no_mapping_is_left_alone() -> None:
    for text in ("Ego: drives at 50 km/h. A car brakes.", "{broken", "a: 1\nb: 2\nc: 3", "", "[1, 2]", "{}"):
        assert structured(text) == []
    laughs = "a: &a [x, x]\nb: &b [*a, *a]\nc: {d: *b}\nego: {speed: 3}\n"
    assert structured(laughs) == []


def test_two_of_a_kind_keep_their_numbers() -> None:
    text = "Ego follows car 1. Car 2 is in the left lane. Car 1 brakes."
    structure = EmbeddedInterpreter().interpret(text).structure
    assert len(structure.objects) == 2
    assert [[p.action for p in o.spec.phases] for o in structure.objects].count(["brake"]) == 1
