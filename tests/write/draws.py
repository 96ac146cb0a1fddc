"""Random structures drawn from the specs' own fields: every Literal from its names, numbers from sane ranges,
references to what is there. Used by the property tests of the writer.
"""

import random
import re
import typing
from typing import Any

from c2s_engine.require.paces import paces_of
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import (
    Condition,
    EgoSpec,
    LightChange,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    RestrictionsSpec,
    SettingsSpec,
    Trigger,
)
from c2s_engine.write.typed import contradiction
from c2s_engine.write.typed.contradictions import FITS, OVER_BY_ITSELF, contradictions


def _one(rng: random.Random, literal: Any) -> Any:
    return rng.choice(typing.get_args(literal))


def _maybe(rng: random.Random, share: float, make: Any) -> Any:
    return make() if rng.random() < share else None


def _quantity(rng: random.Random, low: float, high: float) -> Any:
    a, b = sorted(round(rng.uniform(low, high), 1) for _ in range(2))
    return a if rng.random() < 0.6 else (a, b)


def trigger(rng: random.Random, refs: list[str]) -> Trigger:
    kind = _one(rng, v.TriggerKind)
    return Trigger(
        kind=kind,
        value=_maybe(rng, 0.7, lambda: _quantity(rng, 1, 40)) if kind != "action" else None,
        subject=_maybe(rng, 0.2, lambda: rng.choice(refs)),
        of=_maybe(rng, 0.5, lambda: rng.choice(refs)),
        action=_one(rng, v.Action) if kind == "action" else None,
        place=_one(rng, v.TriggerPlace) if kind == "place" else None,
        light=_one(rng, v.LightState) if kind == "light" else None,
    )


def phase(rng: random.Random, refs: list[str], action: str | None = None) -> Phase:
    action = action or _one(rng, v.Action)
    target = _maybe(rng, 0.4, lambda: rng.choice(refs))
    return Phase(
        action=action,
        speed=_maybe(rng, 0.4, lambda: _quantity(rng, 0, 35)),
        rate=_maybe(rng, 0.3, lambda: _quantity(rng, 0.5, 9)),
        side=_maybe(rng, 0.4, lambda: _one(rng, v.Side)),
        target=target,
        clearance=_maybe(rng, 0.5, lambda: _quantity(rng, 0.3, 3)) if target and action in FITS["clearance"] else None,
        until=_maybe(rng, 0.1, lambda: trigger(rng, refs)) if action not in OVER_BY_ITSELF else None,
        duration=_maybe(rng, 0.3, lambda: _quantity(rng, 0.5, 8)),
        trigger=_maybe(rng, 0.4, lambda: trigger(rng, refs)),
    )


def place(rng: random.Random, kind: str | None = None) -> PlaceSpec:
    kind = kind or _one(rng, v.PlaceKind)
    junction = kind == "intersection"
    return PlaceSpec(
        kind=kind,
        arms=_maybe(rng, 0.4, lambda: rng.choice([3, 4])) if junction else None,
        control=_maybe(rng, 0.5, lambda: _one(rng, v.Control)) if junction else None,
        manoeuvre=_maybe(rng, 0.6, lambda: _one(rng, v.Manoeuvre)) if junction else None,
        lanes=_maybe(rng, 0.3, lambda: rng.randint(1, 3)),
        ego_lane=_maybe(rng, 0.15, lambda: _one(rng, v.EgoLane)),
        oncoming=_maybe(rng, 0.2, lambda: True),
        curve=_maybe(rng, 0.5, lambda: _one(rng, v.Side)) if kind == "curve" else None,
        shoulder=_maybe(rng, 0.1, lambda: True),
        sidewalk=_maybe(rng, 0.1, lambda: True),
        distance=_maybe(rng, 0.2, lambda: _quantity(rng, 15, 90)),
    )


def ego(rng: random.Random, refs: list[str]) -> EgoSpec:
    return EgoSpec(
        type=_one(rng, v.VehicleType) if rng.random() < 0.3 else "car",
        speed=_maybe(rng, 0.6, lambda: _quantity(rng, 0, 36)),
        pace=_maybe(rng, 0.1, lambda: rng.choice(paces_of("car"))),
        phases=tuple(phase(rng, refs) for _ in range(rng.choice([0, 0, 1, 1, 2, 3]))),
        reaction=_one(rng, v.Reaction),
        react_to=_maybe(rng, 0.3, lambda: rng.choice(refs)) if len(refs) > 1 else None,
        hard=rng.random() < 0.4,
    )


def thing(
    rng: random.Random, index: int, others: list[str], position: str | None = None, action: str | None = None
) -> ObjectSpec:
    refs = ["ego", *others]
    kind = _one(rng, v.ObjectType)
    return ObjectSpec(
        name=rng.choice(["lead", "walker", "truck", "cutter", "object", "ego", "new", "Other Car", "O"]),
        type=kind,
        count=rng.choice([1, 1, 1, 2, 3]),
        spacing=_maybe(rng, 0.2, lambda: _quantity(rng, 1, 15)),
        placement=Placement(
            position=position or _one(rng, v.Position),
            of=rng.choice(refs) if rng.random() < 0.3 else "ego",
            along=_maybe(rng, 0.2, lambda: _one(rng, v.Along)),
            lanes_over=2 if rng.random() < 0.1 else 1,
            side=_maybe(rng, 0.6, lambda: _one(rng, v.Side)),
            gap=_maybe(rng, 0.5, lambda: _quantity(rng, 3, 70)),
            hidden_by=_maybe(rng, 0.1, lambda: rng.choice(others)) if others else None,
            facing=_maybe(rng, 0.1, lambda: rng.choice(["along", "against", "across"])),
        ),
        speed=_maybe(rng, 0.5, lambda: _quantity(rng, 0, 30)),
        pace=_maybe(rng, 0.2, lambda: rng.choice(paces_of(kind))) if paces_of(kind) else None,
        phases=tuple(
            phase(rng, refs, action if i == 0 else None) for i in range(rng.choice([0, 1, 1, 2]) or bool(action))
        ),
        limit=13.9 if kind == "speed_sign" else None,
    )


def settings(rng: random.Random, refs: list[str]) -> SettingsSpec:
    return SettingsSpec(
        weather=tuple(sorted({_one(rng, v.Weather) for _ in range(rng.choice([0, 1, 2]))})),
        time=_maybe(rng, 0.5, lambda: _one(rng, v.TimeOfDay)),
        light=_maybe(rng, 0.3, lambda: _one(rng, v.LightState)),
        light_changes=tuple(
            LightChange(to=_one(rng, v.LightState), when=trigger(rng, refs))
            for _ in range(rng.choice([0] * 9 + [1, 2]))
        ),
        parameters={"fog_density": 40.0} if rng.random() < 0.1 else {},
    )


def restrictions(rng: random.Random, refs: list[str]) -> RestrictionsSpec:
    def condition(kinds: tuple[str, ...]) -> Condition:
        kind = rng.choice(kinds)
        return Condition(
            kind=kind,  # type: ignore[arg-type]
            subject=rng.choice(refs),
            other=rng.choice(refs),
            minimum=2.0 if kind in ("distance", "time", "travelled") else None,
            action=_one(rng, v.Action) if kind == "action" else None,
        )

    return RestrictionsSpec(
        terminate_when=tuple(condition(("distance", "time", "stopped", "collision", "travelled", "action"))
                             for _ in range(rng.choice([0, 0, 0, 1]))),
        duration=_maybe(rng, 0.3, lambda: round(rng.uniform(3, 30), 1)),
    )  # fmt: skip


def structure(
    seed: int, *, position: str | None = None, action: str | None = None, kind: str | None = None
) -> Structure:
    """A structure for a seed; a position, an action of O1 and a kind of place may be prescribed.

    Those that break a row of data/contradictions.yaml, or wait for what cannot come, are drawn again, where the
    prescribed names allow it.
    """
    found = None
    for attempt in range(20):
        found = _structure(random.Random(f"{seed} {attempt}"), position, action, kind)
        if _consistent(found):
            break
    assert found is not None
    return found


def _consistent(found: Structure) -> bool:
    error = contradiction(found)
    waits = error is not None and any(re.search(r"trigger|until|light_changes|pace$", f) for f in error.fields)
    return error is None or not waits and str(error) not in {c.because for c in contradictions()}


def _structure(rng: random.Random, position: str | None, action: str | None, kind: str | None) -> Structure:
    number = rng.choice([0, 1, 1, 2, 3]) or bool(position or action)
    ids = [f"O{i + 1}" for i in range(number)]
    objects = tuple(
        Component(
            id=cid,
            description=f"object {i}",
            spec=thing(rng, i, ids[:i], position if i == 0 else None, action if i == 0 else None),
        )
        for i, cid in enumerate(ids)
    )
    refs = ["ego", *ids]
    return Structure(
        settings=Component(id="G", spec=settings(rng, refs)),
        place=Component(id="R", spec=place(rng, kind)),
        ego=Component(id="E", spec=ego(rng, refs)),
        objects=objects,
        restrictions=Component(id="T", spec=restrictions(rng, refs)),
    )
