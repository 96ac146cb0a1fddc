"""What a run showed: the facts that events, scores and requirements are read from.

Derived in the check process (dryrun/), judged anywhere: nothing here needs Scenic. All values are SI but those whose
name says otherwise. The vocabulary is that of benchmark/records/FORMAT.md.
"""

from typing import Literal

from pydantic import BaseModel, ConfigDict

EGO = "ego"


def component_of(who: str) -> str:
    """The id of the component of somebody whom S, a requirement or a run names."""
    return "E" if who == EGO else who


def called(cid: str) -> str:
    """How S, requirements and runs call the one of a component."""
    return EGO if cid == "E" else cid


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class EventFact(_Frozen):
    """An event that an object showed: its name in FORMAT.md, the other party where there is one, when (s)."""

    event: str
    time: float
    other: str | None = None


class StartFact(_Frozen):
    """How an object stands to another at the start (FORMAT.md `starts`).

    `relations`: every half-plane and quadrant that holds. `lanes`: every lane relation that holds (`crossing` with
    `crossing_left` or `crossing_right`: the side from which that road joins the other's).
    `gap`: m between the two bounding boxes, along the road where both are on it.
    """

    relations: tuple[str, ...] = ()
    lanes: tuple[str, ...] = ()
    gap: float = 0.0


class ObjectFacts(_Frozen):
    """One object of the scene. `name` is its variable in the program (`queue[1]` for a member of a list); `line`: the
    line of the program at which its behavior was when the run ended."""

    name: str
    component: str | None = None
    types: tuple[str, ...]  # every type of FORMAT.md that it is: ("car", "vehicle"), ("pedestrian", "vru"), ...
    blueprint: str = ""
    length: float
    width: float
    height: float = 1.5
    moves: bool
    held_speed: float | None = None  # the speed held for the longest while in motion, m/s
    starts: dict[str, StartFact] = {}  # by the other object's name
    hidden_behind: tuple[str, ...] = ()
    events: tuple[EventFact, ...] = ()
    line: int | None = None

    def shows(self, event: str, other: str | None = None) -> bool:
        """Whether it showed that event (towards that other object, where one is named)."""
        return any(e.event == event and (other is None or e.other == other) for e in self.events)


class ContactFact(_Frozen):
    """The first contact of two objects: when (s), the part of each that is hit, and how fast they close (m/s).

    `at_one`, `at_other`: where, m ahead of and to the left of the middle of each.
    """

    time: float
    one: str
    other: str
    part_one: Literal["front", "rear", "left", "right"]
    part_other: Literal["front", "rear", "left", "right"]
    closing: float = 0.0
    at_one: tuple[float, float] | None = None
    at_other: tuple[float, float] | None = None


class RoadFacts(_Frozen):
    """The road on ego's path (FORMAT.md `road`)."""

    lanes_same_direction: int = 0
    oncoming_lane: bool = False
    intersection: Literal["none", "3way", "4way", "other"] = "none"
    signalized: bool = False
    curve: bool = False
    straight: bool = False
    speed_limit_kmh: float | None = None


class RunFacts(_Frozen):
    """One rollout: the scene that was sampled and what happened in it."""

    seed: int
    duration: float
    ended_by: Literal["time", "terminated", "collision", "rejected", "error", "cancelled"]
    reason: str = ""
    road: RoadFacts = RoadFacts()
    light: str | None = None  # red, yellow, green when ego first comes within 30 m; "" : a light, never so near
    infrastructure: tuple[str, ...] = ()  # traffic_light, stop_sign, yield_sign, crosswalk on ego's path
    speed_limits_kmh: tuple[float, ...] = ()  # the map's for ego's road, those on sign props and scene parameters
    temporary: tuple[str, ...] = ()  # construction_zone, cones, barrier, debris, lane_closure, warning_sign
    weather: tuple[str, ...] = ()
    time: tuple[str, ...] = ()  # day, dawn, dusk, night (dawn and dusk are alike to the sun)
    objects: tuple[ObjectFacts, ...] = ()
    contacts: tuple[ContactFact, ...] = ()

    @property
    def ran(self) -> bool:
        """Whether it ran to its end, to a collision, or to the program's own termination (FORMAT.md, CSR)."""
        return self.ended_by in ("time", "terminated", "collision")


class Stay(_Frozen):
    """From when (s) an object's middle is in a lane: which, and how that lane lies to ego's way.

    `lane`: the map's index, -1 for none. `kind`: what is under it. `to_ego`: ego's own way, the lanes beside it in the
    same direction, those of the other direction, ways that cross it. `against`: it faces against the lane.
    """

    time: float
    lane: int = -1
    kind: Literal["lane", "junction", "shoulder", "sidewalk", "off"] = "lane"
    to_ego: Literal["own", "left", "right", "oncoming", "crossing", "other"] = "other"
    against: bool = False


class Mark(_Frozen):
    """A junction, crosswalk, stop line or the lane in which a ramp goes on, on an object's own way: from where to
    where, m along it.

    `name`: the junction; of a line `junction/road`, as in `Trajectories.lights`, with what regulates it.
    """

    kind: Literal["junction", "crosswalk", "line", "merge"]
    start: float
    end: float
    name: str = ""
    control: Literal["", "signal", "stop", "yield"] = ""


class Course(_Frozen):
    """Where an object is on the road, a value `every` s up to its first contact: m along and m to the left of its own
    way and of ego's. A walker's own way is what it has walked.

    `sight`: changes (s, whether ego can see it past the other objects' boxes).
    """

    every: float = 0.2
    along: tuple[float, ...] = ()
    aside: tuple[float, ...] = ()
    ego_along: tuple[float, ...] = ()
    ego_aside: tuple[float, ...] = ()
    stays: tuple[Stay, ...] = ()
    marks: tuple[Mark, ...] = ()
    sight: tuple[tuple[float, bool], ...] = ()


class Track(_Frozen):
    """An object's way: position (m), heading (rad, Scenic's: 0 is north, anticlockwise), speed (m/s) per step."""

    name: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    heading: tuple[float, ...]
    speed: tuple[float, ...]
    length: float
    width: float
    kind: str = "car"
    course: Course | None = None


class Trajectories(_Frozen):
    """The ways of all objects, one sample a step, and the lights' states as changes (time, intersection, state)."""

    step: float
    tracks: tuple[Track, ...]
    lights: tuple[tuple[float, str, str], ...] = ()
    outline: dict[str, tuple[tuple[tuple[float, float], ...], ...]] = {}  # kind of road part -> polygons around it, m
