"""What the writer decides beyond S is said, and said once."""

import pytest

from c2s_engine.structure.components import Assumption, Component, Structure
from c2s_engine.structure.specs import (
    EgoSpec,
    LightChange,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    SettingsSpec,
    Trigger,
)
from c2s_engine.write.typed.decided import BY, differences, with_decisions


def scene(place: PlaceSpec, ego: EgoSpec, *objects: ObjectSpec) -> Structure:
    return Structure(
        place=Component(id="R", spec=place), ego=Component(id="E", spec=ego),
        objects=tuple(Component(id=f"O{n}", spec=o) for n, o in enumerate(objects, 1)),
    )  # fmt: skip


def said(structure: Structure) -> dict[str, str]:
    return {f"{c.id}.{a.field}": a.value for c in structure.components for a in c.assumed if a.by == BY}


FROM_RIGHT = Placement(position="crossing_right")
VAN = ObjectSpec(name="van", type="van", placement=FROM_RIGHT, phases=(Phase(action="run_red"),))


def test_what_is_left_open_is_said() -> None:
    found = said(with_decisions(scene(PlaceSpec(), EgoSpec(speed=13.89), VAN), 1.0))
    assert found["R.kind"] == "intersection" and found["R.control"] == "signal"
    assert found["R.manoeuvre"] == "straight" and found["O1.speed"].endswith("km/h")
    assert "E.speed" not in found


def test_when_a_light_changes_is_said_where_s_leaves_it_open() -> None:
    whens = (("green", Trigger(kind="time")), ("red", Trigger(kind="time", value=9)))
    changes = tuple(LightChange(to=to, when=when) for to, when in whens)
    settings = SettingsSpec(light="red", light_changes=changes)
    asked = scene(PlaceSpec(kind="intersection", control="signal"), EgoSpec(speed=13.89))
    asked = asked.with_component(Component(id="G", spec=settings, origin="rendered"))
    found = said(with_decisions(asked, 1.0))
    assert found["G.light_changes.0.when"] == "3 s have passed" and "G.light_changes.1.when" not in found


def test_what_is_changed_says_what_it_was() -> None:
    asked = scene(PlaceSpec(kind="road"), EgoSpec(speed=13.89), VAN)
    (kind,) = [a for a in with_decisions(asked, 1.0).place.assumed if a.field == "kind"]
    assert kind == Assumption(field="kind", value="intersection", reason="written so for road", by=BY)


def test_a_phase_that_the_writer_adds_is_said() -> None:
    walker = ObjectSpec(
        name="walker", type="pedestrian", placement=Placement(position="sidewalk", side="right"),
        phases=(Phase(action="cross_road"),),
    )  # fmt: skip
    asked = scene(PlaceSpec(kind="crosswalk", crosswalk=True), EgoSpec(speed=8.0, reaction="yield"), walker)
    assert said(with_decisions(asked, 1.0))["E.phases"] == "yield"


def test_decisions_are_made_anew() -> None:
    once = with_decisions(scene(PlaceSpec(), EgoSpec(), VAN), 1.0)
    assert with_decisions(once, 1.0) == once
    spec = VAN.model_copy(update={"speed": 9.0})
    faster = once.with_component(once["O1"].model_copy(update={"spec": spec}))
    assert "O1.speed" not in said(with_decisions(faster, 1.0))


def test_code_by_hand_is_left_alone() -> None:
    asked = scene(PlaceSpec(), EgoSpec(), VAN)
    asked = asked.with_component(asked["O1"].model_copy(update={"origin": "by_hand", "code": "van = new Van"}))
    assert not with_decisions(asked, 1.0)["O1"].assumed


@pytest.mark.parametrize(
    ("was", "now", "found"),
    [
        (Placement(gap=10.0), Placement(gap=24.0), [("gap", 10.0, 24.0)]),
        (ObjectSpec(), ObjectSpec(placement=Placement(side="left")), [("placement.side", None, "left")]),
        (EgoSpec(phases=(Phase(action="stop"),)), EgoSpec(phases=(Phase(action="stop", rate=7.0),)),
         [("phases.0.rate", None, 7.0)]),
        (EgoSpec(), EgoSpec(), []),
    ],
)  # fmt: skip
def test_differences_name_the_field(was, now, found) -> None:
    assert list(differences(was, now)) == found
