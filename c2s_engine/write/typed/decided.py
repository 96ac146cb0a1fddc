"""What the typed writer decides beyond S: said in `assumed`, field by field, so that nothing of S changes silently.

The S that was asked is compared with the S that is written (its normal form, the plan's place, ego's added phases,
usual speeds); the entries are the writer's own (`by`) and are made anew whenever something is written.
"""

from collections.abc import Iterator
from typing import Any

from c2s_engine.structure.components import Assumption, ComponentId, Structure
from c2s_engine.structure.quantity import high
from c2s_engine.structure.shown import amount, value_in_words
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Placement, PlaceSpec, SettingsSpec, Spec
from c2s_engine.structure.triggers import clause
from c2s_engine.write.typed.answers import reacting_phases
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.planning import make_plan
from c2s_engine.write.typed.spread import spread
from c2s_engine.write.typed.tables import (
    BLUEPRINTS,
    HEIGHT,
    LENGTH,
    NOTE,
    ROLLING,
    TIMED,
    USUAL_HEIGHT,
    is_rolling,
    is_static,
)
from c2s_engine.write.typed.threats import threatening
from c2s_engine.write.typed.usual import crosses, default_gap, speed_of
from c2s_engine.write.typed.watching import with_value

BY = "writer"
OPEN = "left open: the writer's choice"


def with_decisions(structure: Structure, room: float) -> Structure:
    """S, each rendered component with what the writer chose for it or changed in it; S as it is where it contradicts
    itself."""
    try:
        written = spread(structure)
        plan = make_plan(written, room)
    except ResolveError:
        return structure
    for component in structure.components:
        others = tuple(a for a in component.assumed if a.by != BY)
        own = _decided(structure, written, plan, component.id) if component.origin == "rendered" else ()
        said = {(a.field, a.value) for a in others}
        assumed = (*others, *(a for a in own if (a.field, a.value) not in said))
        if assumed != component.assumed:
            structure = structure.with_component(component.model_copy(update={"assumed": assumed}))
    return structure


def _decided(structure: Structure, written: Structure, plan: Plan, cid: ComponentId) -> Iterator[Assumption]:
    asked, spec = structure[cid].spec, written[cid].spec
    if isinstance(asked, PlaceSpec):  # a lane for ego is no demand
        spec = plan.place if plan.place.lanes != 1 else plan.place.model_copy(update={"lanes": asked.lanes})
        if plan.distance is not None and asked.distance is None:
            spec = spec.model_copy(update={"distance": plan.distance})
    if isinstance(spec, EgoSpec):
        phases = reacting_phases(spec, threatening(written), written, plan)
        spec = spec.model_copy(update={"phases": phases, "speed": _speed(spec, plan)})
    elif isinstance(spec, ObjectSpec):
        speed = spec.speed if is_static(spec) else _speed(spec, plan)
        spec = spec.model_copy(update={"speed": speed, "placement": _placed(spec, plan)})
    rolls = is_rolling(asked)
    if isinstance(asked, ObjectSpec) and (rolls or asked.type in HEIGHT and asked.model is None):
        kind, stands_in = asked.type.replace("_", " "), ROLLING["blueprint"] if rolls else BLUEPRINTS[asked.type][0]
        kind += " that moves" if rolls else ""
        reason = f"CARLA has no {kind}: {stands_in} stands in, as large as one in the dry run{NOTE.get(asked.type, '')}"
        size = f"{LENGTH[asked.type]:g} m long, {HEIGHT.get(asked.type, USUAL_HEIGHT):g} m high"
        yield Assumption(field="model", value=size, reason=reason, by=BY)
    if isinstance(asked, SettingsSpec):
        for i, change in enumerate(asked.light_changes):
            if (when := with_value(change.when)) != change.when:
                said, value = clause(when, "ego", when.of or "the other"), when.value
                yield Assumption(field=f"light_changes.{i}.when", value=said, reason=OPEN, by=BY, amount=value)
    for path, was, now in differences(asked, spec):
        reason = OPEN if was is None else f"written so for {value_in_words(path, was)}"
        if was is None and path.endswith("speed") and (pace := _pace(asked, path)):
            reason = f"what {pace.replace('_', ' ')!r} means of a {asked.type.replace('_', ' ')} (data/paces.yaml)"  # type: ignore[union-attr]
        yield Assumption(field=path, value=value_in_words(path, now), reason=reason, by=BY, amount=amount(now))


def _placed(spec: ObjectSpec, plan: Plan) -> Placement:
    """Where it starts, with the gap that is written for it; where it starts to meet ego, that is no gap."""
    placement = spec.placement
    if placement.gap is not None or placement.position in TIMED or crosses(spec):
        return placement
    gap = default_gap(spec, plan.ego_speed, plan.place)
    return placement.model_copy(update={"gap": round(gap, 1)}) if gap else placement


def _pace(asked: Spec, path: str) -> str | None:
    """The pace that S gives beside a speed."""
    for part in path.split(".")[:-1]:
        asked = asked[int(part)] if part.isdigit() else getattr(asked, part)  # type: ignore[index]
    return getattr(asked, "pace", None)


def _speed(spec: EgoSpec | ObjectSpec, plan: Plan) -> Any:
    """The speed that it starts with; None where it stands at first and S does not say so."""
    speed = speed_of(spec, plan.place)
    return spec.speed if spec.speed is not None or high(speed) == 0 else speed


def differences(asked: Spec, written: Spec, path: str = "") -> Iterator[tuple[str, Any, Any]]:
    """(path, value asked, value written) of every field that differs; phases one by one where the actions are alike."""
    for name in type(asked).model_fields:
        was, now = getattr(asked, name), getattr(written, name)
        if was == now:
            continue
        if isinstance(was, Spec) and isinstance(now, type(was)):
            yield from differences(was, now, f"{path}{name}.")
        elif name == "phases" and [p.action for p in was] == [p.action for p in now]:
            for i, (one, two) in enumerate(zip(was, now, strict=True)):
                yield from differences(one, two, f"{path}phases.{i}.")
        else:
            yield f"{path}{name}", was, now
