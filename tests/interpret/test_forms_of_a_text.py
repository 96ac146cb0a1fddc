"""One scene in many forms: lists, lines, points, mails, JSON, YAML. Each is the scene that plain sentences tell."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

EGO = "go drives at 90 km/h in the right lane of a two-lane motorway"
CAR = "car in the left lane, 20 m behind ego, overtakes ego and cuts in"
TRUCK = "truck 60 m ahead of ego drives at 70 km/h"
PLAIN = f"E{EGO}. A {CAR}. A {TRUCK}."
FORMS = {
    "points": f"1) E{EGO} 2) A {CAR} 3) A {TRUCK}",
    "list": f"1. E{EGO}.\n2. A {CAR}.\n3. A {TRUCK}.",
    "heads": "ROAD: two-lane motorway. EGO: 90 km/h, right lane. ACTOR 1 (car): left lane, 20 m behind ego; overtakes"
    " ego and cuts in. ACTOR 2 (truck): 60 m ahead of ego, 70 km/h.",
    "mail": f"Hi team,\n\nplease build this one for me: e{EGO}. A {CAR}. A {TRUCK}.\n\nBest regards,\nTom",
    "given": f"Given a two-lane motorway\nAnd e{EGO}\nAnd a {TRUCK}\nWhen a car in the left lane, 20 m behind ego,"
    " overtakes ego\nThen the car cuts in",
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


def test_two_of_a_kind_keep_their_numbers() -> None:
    text = "Ego follows car 1. Car 2 is in the left lane. Car 1 brakes."
    structure = EmbeddedInterpreter().interpret(text).structure
    assert len(structure.objects) == 2
    assert [[p.action for p in o.spec.phases] for o in structure.objects].count(["brake"]) == 1
