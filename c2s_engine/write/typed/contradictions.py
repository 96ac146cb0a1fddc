"""What cannot be together in a structure: the rows of data/contradictions.yaml, and the first that one breaks."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import yaml

from c2s_engine.paths import shipped
from c2s_engine.structure.facts import called
from c2s_engine.structure.specs import EgoSpec, LightChange, ObjectSpec, PlaceSpec


class ResolveError(ValueError):
    """Specs that contradict each other; `fields` names them."""

    def __init__(self, message: str, fields: tuple[str, ...]):
        super().__init__(message)
        self.fields = fields


@dataclass(frozen=True)
class Contradiction:
    """One row: all that is given must hold for it to apply; `places`, `positions` and `actions` are alternatives."""

    because: str
    fields: tuple[str, ...]
    places: frozenset[str] = frozenset()
    positions: frozenset[str] = frozenset()
    actions: frozenset[str] = frozenset()
    oncoming: bool = False
    sidewalk: bool = False
    said: str = ""  # a field of the placement that S gives
    of_another: bool = False  # placed by another than ego
    triggered: bool = False  # what it does first waits for something

    def holds(self, place: PlaceSpec, ego: EgoSpec, objects: Iterable[ObjectSpec]) -> bool:
        """Whether a structure's specs break it."""
        if self.places and place.kind not in self.places:
            return False
        if self.oncoming and not place.oncoming or self.sidewalk and not place.sidewalk:
            return False
        if self.said:
            return any(self._says(o) for o in objects)
        acting = [(o.placement.position, {p.action for p in o.phases}) for o in objects]
        if self.positions:
            return any(
                position in self.positions and (not self.actions or actions & self.actions)
                for position, actions in acting
            )
        if self.actions:
            return any(actions & self.actions for _, actions in [("", {p.action for p in ego.phases}), *acting])
        return True

    def _says(self, o: ObjectSpec) -> bool:
        given = getattr(o.placement, self.said) is not None
        waits = bool(o.phases) and o.phases[0].trigger is not None
        there = not self.positions or o.placement.position in self.positions
        return given and there and (waits or not self.triggered) and (o.placement.of != "ego" or not self.of_another)

    def pairs(self, place: str | None = None, position: str | None = None, action: str | None = None) -> bool:
        """Whether it rules a pair of names out by itself (with everything else open)."""
        wanted = ((self.places, place), (self.positions, position), (self.actions, action))
        return not (self.oncoming or self.sidewalk or self.said) and all(
            name in names if names else True for names, name in wanted if names or name
        )


@cache
def contradictions() -> tuple[Contradiction, ...]:
    """All rows, in the order in which they are looked up."""
    rows = yaml.safe_load(shipped("contradictions.yaml").read_text(encoding="utf-8"))
    return tuple(
        Contradiction(
            because=row["because"],
            fields=tuple(row["fields"]),
            places=frozenset(row.get("places", ())),
            positions=frozenset(row.get("positions", ())),
            actions=frozenset(row.get("actions", ())),
            oncoming=row.get("oncoming", False),
            sidewalk=row.get("sidewalk", False),
            said=row.get("said", ""),
            of_another=row.get("of_another", False),
            triggered=row.get("triggered", False),
        )
        for row in rows
    )


FITS = {
    "gap": ("cut_in", "cut_out", "lane_change", "overtake", "brake", "stop", "follow"),
    "lateral_speed": ("lane_change", "cut_in", "cut_out", "swerve", "drift"),
    "abandoned": ("lane_change", "cut_in", "overtake", "cross_road"),
    "clearance": ("stop", "swerve", "overtake", "keep_lane", "cross_road"),
}
"""The actions of which a phase can say a field."""
OVER_BY_ITSELF = ("turn_left", "turn_right", "go_straight", "u_turn", "run_red", "run_stop", "collide", "cut_in")
"""What is over when it is done: nothing else can end it."""
AT_JUNCTION = ("stop_line", "in_intersection", "past_intersection")
OF_TWO = ("apart", "passed", "seen", "contact")


def misplaced(actors: dict[str, EgoSpec | ObjectSpec], ramp: bool) -> ResolveError | None:
    """The first field of a phase that means nothing for its action, or there; `ramp`: whether somebody merges."""
    for cid, spec in actors.items():
        for i, phase in enumerate(spec.phases):
            path, action = f"{cid}.phases.{i}", phase.action.replace("_", " ")
            for name, actions in FITS.items():
                if getattr(phase, name) not in (None, False) and phase.action not in actions:
                    known = ", ".join(actions).replace("_", " ")
                    why = f"{path}.{name} says nothing of a {action}: it is for {known}"
                    return ResolveError(f"{why}. Leave it out, or change the action", (f"{path}.{name}",))
            if phase.until is not None and phase.action in OVER_BY_ITSELF:
                why = f"{path}.until ends no {action}: it is over when it is done"
                return ResolveError(f"{why}. Leave it out, or give the next phase a trigger", (f"{path}.until",))
            if phase.clearance is not None and phase.target is None and phase.action != "cross_road":
                why = f"{path}.clearance is the room to somebody: say to whom by its target"
                return ResolveError(why, (f"{path}.clearance", f"{path}.target"))
            if phase.trigger is not None and phase.trigger.place == "merge_end" and not ramp:
                why = f"{path} waits for the end of an acceleration lane, and nobody comes up a ramp"
                return ResolveError(f"{why}: place somebody on one", (f"{path}.trigger.place", "O.placement.position"))
    return None


def unwatchable(
    place: PlaceSpec, actors: dict[str, EgoSpec | ObjectSpec], changes: tuple[LightChange, ...]
) -> ResolveError | None:
    """The first trigger of which nothing can come at that place."""
    watched = [
        (f"{cid}.phases.{i}.{name}", called(cid), t)
        for cid, spec in actors.items() for i, phase in enumerate(spec.phases)
        for name, t in (("trigger", phase.trigger), ("until", phase.until)) if t is not None
    ]  # fmt: skip
    watched += [(f"G.light_changes.{i}.when", "ego", c.when) for i, c in enumerate(changes)]
    for path, own, t in watched:
        if t.kind in OF_TWO and t.of is not None and t.of == (t.subject or own):
            why = f"{path} is about {t.of} and itself: it takes two road users"
            return ResolveError(f"{why}. Change of or subject", (f"{path}.of", f"{path}.subject"))
        if t.kind == "light" and t.light is None:
            return ResolveError(f"{path} waits for a light: say in light what it shows", (f"{path}.light",))
        if t.kind == "light" and place.control != "signal":
            why = f"{path} waits for a traffic light, and there is none: set R.control to 'signal'"
            return ResolveError(why, ("R.control", f"{path}.kind"))
        if t.place in AT_JUNCTION and place.kind not in ("intersection", "roundabout"):
            why = f"{path} waits for an intersection, and there is none: set R.kind to 'intersection'"
            return ResolveError(why, ("R.kind", f"{path}.place"))
        if t.place == "bend" and place.kind != "curve":
            why = f"{path} waits for a bend, and there is none: set R.kind to 'curve'"
            return ResolveError(why, ("R.kind", f"{path}.place"))
    if changes and place.control != "signal":
        why = "G.light_changes needs a traffic light: set R.control to 'signal'"
        return ResolveError(why, ("R.control", "G.light_changes"))
    return None


def first(place: PlaceSpec, ego: EgoSpec, objects: Iterable[ObjectSpec]) -> Contradiction | None:
    """The first row that the specs break."""
    objects = tuple(objects)
    return next((c for c in contradictions() if c.holds(place, ego, objects)), None)
