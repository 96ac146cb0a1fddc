"""The unknowns of S: fields that the text left open, with the value that is written for each now."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass

from c2s_engine.structure.components import FITTED, READ, Assumption, Component, ComponentId, Structure
from c2s_engine.structure.edits import EditError, SetField, apply
from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.objects import SLOWS, is_ahead
from c2s_engine.structure.quantity import Quantity, in_words, middle
from c2s_engine.structure.sentences import with_updated_sentences
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed.tables import APPROACH_ANGLE
from c2s_engine.write.typed.usual_values import Usual
from c2s_engine.write.typed.watching import METRES, SECONDS

PLANNER = "planner"
"""Who chose, in `assumed`."""
REASON = "left open: chosen so that the run shows what is described"
BY_OTHERS = (
    "wait", "stationary", "cross_road", "yield", "follow", "go_straight", "turn_left", "turn_right", "collide",
    "keep_lane", "move_along",
)  # fmt: skip
"""First phases whose moment follows from where others are or from the place, or that have none."""
STANDS_FOR = 3.0
"""s for which one waits first, where nothing says how long."""
LIMITS = {"gap": (2.0, 400.0), "speed": (1.0, 36.0), "rate": (1.0, 9.0), "duration": (1.0, 60.0),
          "distance": (15.0, 190.0), "trigger": (1.0, 15.0), "later": (-30.0, 30.0), "value": (1.0, 190.0)}  # fmt: skip
"""What may be chosen, by the last part of the path: m, m/s, m/s2, s, m, s, s, m or s."""
NEAR = {"distance": METRES, "ttc": SECONDS}
"""How near is near, by what a condition watches, where S does not say: m, s."""
_UNITS = {"distance": "m", "ttc": "s", "time": "s"}
HEADWAY = 0.9
"""s behind another that drives in the same lane below which no open gap is chosen."""
FASTER = 3.0
"""m/s by which one overtakes at least."""
STRAYS = 0.3
"""The share of what is usual by which a speed may be higher or lower."""


@dataclass(frozen=True)
class Unknown:
    """A field that is open. `value`: what is written for it now, SI units; for a trigger the s since the start;
    `usual`: what is usual there, from which it does not stray; `least`: below which it is not brought."""

    component: ComponentId
    path: str
    value: float
    usual: float | None = None
    least: float = 0.0

    @property
    def limits(self) -> tuple[float, float]:
        least, most = LIMITS[self.path.rsplit(".", 1)[-1]]
        least = max(least, min(self.least, self.value)) if self.least else least
        if not self.usual:
            return least, most
        low, high = (1 - STRAYS) * self.usual, (1 + STRAYS) * self.usual
        return max(least, min(self.value, low)), min(most, max(self.value, high))

    def set_to(self, value: float, digits: int = 1) -> Move:
        """The move that gives it `value`, within its limits and rounded; none where that changes nothing."""
        within = self.within(value, digits)
        return ((self, within),) if within != round(self.value, digits) else ()

    def within(self, value: float, digits: int = 1) -> float:
        """`value`, or the limit beyond which it is, rounded where that keeps it within them."""
        low, high = self.limits
        found = min(max(value, low), high)
        return rounded if low <= (rounded := round(found, digits)) <= high else found


Setting = tuple[Unknown, float]
"""An unknown and a value for it."""
Move = tuple[Setting, ...]
"""What is tried at once."""


def find(open_: Sequence[Unknown], component: ComponentId, path: str) -> Unknown | None:
    """The unknown of a component at a path, if that is open."""
    return next((u for u in open_ if (u.component, u.path) == (component, path)), None)


Field = tuple[ComponentId, str]
"""A component and a path in its spec."""


def unknowns(structure: Structure, usual: Usual, freed: Container[Field] = ()) -> tuple[Unknown, ...]:
    """What is open of the components that are written from S, and what is to count as open though the text says it
    (`freed`); `usual`: what the writer takes where S says nothing."""
    found: list[Unknown] = []
    for component in structure.components:
        if component.origin == "rendered":
            found += _of(component, usual, freed)
    steady = {(cid, "speed") for cid in _followed(structure)}
    return tuple(u for u in found if (u.component, u.path) not in steady or (u.component, u.path) in freed)


def _followed(structure: Structure) -> set[str]:
    """Those who are followed from the start by one whose speed is said: theirs is no other."""
    found = set()
    for component in structure.components:
        spec, open_ = component.spec, any(a.field == "speed" for a in component.assumed)
        if isinstance(spec, EgoSpec | ObjectSpec) and spec.speed is not None and not open_:
            found |= {str(p.target) for p in spec.phases[:1] if p.action == "follow" and p.trigger is None}
    return found


class Everything(Container[Field]):
    """All fields."""

    def __contains__(self, _: object) -> bool:
        return True


def said(structure: Structure, usual: Usual) -> tuple[Unknown, ...]:
    """The numbers that the text says, of the fields that may be unknowns."""
    open_ = {(u.component, u.path) for u in unknowns(structure, usual)}
    found = (u for u in unknowns(structure, usual, Everything()) if (u.component, u.path) not in open_)
    return tuple(u for u in found if not u.path.endswith("trigger") or _is_timed(structure, u))


def _is_timed(structure: Structure, unknown: Unknown) -> bool:
    """Whether a trigger is a time since the start, so that a time may stand in for it."""
    trigger = structure[unknown.component].spec.phases[0].trigger  # type: ignore[union-attr]
    return trigger is not None and trigger.kind == "time"


def chosen(structure: Structure, unknown: Unknown, value: Quantity, reason: str = REASON,
           by: str = PLANNER, was: str = "") -> Structure:  # fmt: skip
    """S with a value or a range for an unknown, said in `assumed` (`was`: what was said in its place); S as it is where
    the field cannot take it."""
    kept = structure[unknown.component].assumed
    field = unknown.path
    setting = {"kind": "time", "value": value} if field.endswith("trigger") else value
    try:
        changed = apply(structure, SetField(component=unknown.component, path=field, value=setting))
    except EditError:
        return structure
    said = in_words(field, value)
    if field.endswith(".value"):
        said += f" {_UNITS[value_at(structure[unknown.component].spec, field.removesuffix('value') + 'kind')]}"  # type: ignore[index]
    note = Assumption(field=field, value=said, reason=reason, by=by, was=was)
    others = tuple(a for a in kept if a.field != field)
    changed = changed.with_component(changed[unknown.component].model_copy(update={"assumed": (*others, note)}))
    return with_updated_sentences(structure, changed)


def _of(component: Component, usual: Usual, freed: Container[Field]) -> Iterator[Unknown]:
    spec, cid = component.spec, component.id
    assumed = {a.field for a in component.assumed if a.by not in (FITTED, READ)}

    def is_open(path: str, value: object) -> bool:
        return value is None or path in assumed or (cid, path) in freed

    if isinstance(spec, EgoSpec | ObjectSpec):
        speed = usual.speeds.get(cid, 0.0)
        follows = bool(spec.phases) and spec.phases[0].action == "follow"  # as fast as whom it follows
        if speed > 0 and spec.pace is None and is_open("speed", spec.speed) and not follows:
            yield Unknown(cid, "speed", speed, None if (cid, "speed") in freed else usual.typical.get(cid))
        for i, phase in enumerate(spec.phases):
            by_place = isinstance(spec, ObjectSpec) and spec.placement.position in APPROACH_ANGLE
            late = phase.action == "brake" and any(p.action == "collide" for p in spec.phases[i + 1 : i + 2])
            timed = cid in usual.later or by_place or late
            by_contact = late and phase.rate is None  # that says how hard it brakes
            before_it = [p.action for p in spec.phases[i + 1 : i + 3] if p.trigger is None] == ["brake", "collide"]
            untimed = is_open(f"phases.{i}.trigger", phase.trigger) and not timed and not before_it
            hits = any(p.action == "collide" and (p.speed is not None or p.pace) for p in spec.phases[i + 1 : i + 2])
            yield from _nearnesses(cid, i, phase, is_open)
            if phase.action != "accelerate" or not hits:  # that says how fast it is by then
                own = _of_phase(cid, i, phase, usual.speeds, untimed and not _answers(spec, phase), is_open)
                yield from (u for u in own if not (by_contact and u.path.endswith("rate")))
    if isinstance(spec, ObjectSpec) and cid in usual.gaps and is_open("placement.gap", spec.placement.gap):
        follows = spec.placement.position in ("ahead", "behind") and spec.placement.facing != "against"
        yield Unknown(cid, "placement.gap", usual.gaps[cid], least=HEADWAY * usual.speeds.get(cid, 0.0) * follows)
    if isinstance(spec, ObjectSpec) and cid in usual.later and is_open("placement.later", spec.placement.later):
        yield Unknown(cid, "placement.later", usual.later[cid])
    if cid == "G":
        yield from _changes(component)
    at_line = usual.speeds.get("E") == 0  # where ego stands at first
    if cid == "R" and usual.distance and not at_line and is_open("distance", getattr(spec, "distance", None)):
        yield Unknown(cid, "distance", usual.distance)
    if cid == "T" and is_open("duration", getattr(spec, "duration", None)) and not getattr(spec, "terminate_when", ()):
        yield Unknown(cid, "duration", usual.duration)


def _changes(component: Component) -> Iterator[Unknown]:
    """When ego's light changes, where S says only that it does: s since the start."""
    for i, change in enumerate(getattr(component.spec, "light_changes", ())):
        when, path = change.when, f"light_changes.{i}.when.value"
        assumed = any(a.field == path for a in component.assumed)
        if when.kind == "time" and when.subject is None and (when.value is None or assumed):
            yield Unknown(component.id, path, SECONDS * (i + 1) if when.value is None else middle(when.value))


def _nearnesses(cid: ComponentId, i: int, phase: Phase, is_open: Callable[[str, object], bool]) -> Iterator[Unknown]:
    """How near somebody has to be for a phase to begin or to end, where S says only that it is."""
    for name, condition in (("trigger", phase.trigger), ("until", phase.until)):
        if condition is not None and condition.kind in NEAR and is_open(f"phases.{i}.{name}.value", condition.value):
            value = NEAR[condition.kind] if condition.value is None else middle(condition.value)
            yield Unknown(cid, f"phases.{i}.{name}.value", value)


def _answers(spec: EgoSpec | ObjectSpec, phase: Phase) -> bool:
    """Whether one brakes, or stops, for somebody: as that one comes into its way."""
    reacts = isinstance(spec, EgoSpec) and spec.reaction != "none" and phase.speed is None
    named = phase.target is not None and not is_ahead(spec, phase.target)
    return phase.action in SLOWS and (named or reacts)


def _of_phase(cid: ComponentId, i: int, phase: Phase, speeds: Mapping[str, float], untimed: bool,
              is_open: Callable[[str, object], bool]) -> Iterator[Unknown]:  # fmt: skip
    path, speed = f"phases.{i}", speeds.get(cid, 0.0)
    moves = speed > 0 or phase.action in ("enter_road", "start", "reverse")
    if i == 0 and untimed and moves and phase.action not in BY_OTHERS:
        value = middle(phase.trigger.value) if phase.trigger and phase.trigger.value is not None else 3.0
        yield Unknown(cid, f"{path}.trigger", value)
    if i == 0 and phase.action == "wait" and untimed and is_open(f"{path}.duration", phase.duration):
        yield Unknown(cid, f"{path}.duration", middle(phase.duration) if phase.duration is not None else STANDS_FOR)
    if phase.action in SLOWS and is_open(f"{path}.rate", phase.rate):
        yield Unknown(cid, f"{path}.rate", middle(phase.rate) if phase.rate is not None else 3.5)
    if phase.action in ("overtake", "accelerate") and is_open(f"{path}.speed", phase.speed):
        least = speeds.get("E" if phase.target == "ego" else str(phase.target), 0.0) + FASTER
        faster = max(speed, least if phase.action == "overtake" else 5.0)
        yield Unknown(cid, f"{path}.speed", middle(phase.speed) if phase.speed is not None else faster,
                      least=least if phase.action == "overtake" else 0.0)  # fmt: skip
