"""The typed specs of S: what each component can say, independent of any wording and of Scenic.

The JSON schema that models fill, the vocabulary of the prompts and the documentation are generated from these
classes. All numbers are SI (m, s, m/s, m/s2, rad); km/h appear at the user's face only.
"""

import re
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, field_validator, model_validator

from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.quantity import Quantity, Velocity

Speed = Annotated[Velocity, Field(description="m/s, or [low, high]")]
Metres = Annotated[Quantity, Field(description="m, or [low, high]")]
Seconds = Annotated[Quantity, Field(description="s, or [low, high]")]
Reference = Annotated[str, Field(pattern=r"^(ego|O[1-9][0-9]?)$", description="'ego' or an object's id: O1, O2, ...")]


class Spec(BaseModel):
    """Base of the typed specs: closed, immutable, small when dumped."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Trigger(Spec):
    """When a phase begins. A phase without one begins as soon as the one before it is over."""

    kind: v.TriggerKind = Field(description="what is watched")
    value: Quantity | None = Field(
        None,
        description="distance, apart: m, bumper to bumper; ttc, time: s since the start; place: m before it; "
        "speed: m/s",
    )
    subject: Reference | None = Field(None, description="whom it is about; default: whose phase it is")
    of: Reference | None = Field(
        None,
        description="distance, apart, ttc, passed, seen, contact: to whom (default ego; for ego: the nearest object; "
                    "where the subject is another than the actor: the actor)",
    )
    action: v.Action | None = Field(None, description="action: the action of `of` that is waited for")
    place: v.TriggerPlace | None = Field(None, description="place: what is reached")
    light: v.LightState | None = Field(None, description="light: what the light ahead of `subject` shows")
    delay: Seconds | None = Field(None, description="how long after that the phase begins, s")


class Phase(Spec):
    """One step of a behaviour: an action, how, towards whom, from when."""

    action: v.Action
    speed: Speed | None = Field(None, description="speed to reach or to hold in this phase, m/s")
    pace: v.Pace | None = Field(None, description="that speed in a word, where no number is given")
    rate: Quantity | None = Field(None, description="acceleration or deceleration, a positive number, m/s2")
    side: v.Side | None = Field(
        None, description="lane_change, cut_in, cut_out, swerve, drift, leave_road: towards which side"
    )
    target: Reference | None = Field(None, description="whom it is about: followed, overtaken, yielded to, hit")
    duration: Seconds | None = Field(None, description="how long it lasts, s")
    gap: Metres | None = Field(
        None,
        description="to `target` (default ego), bumper to bumper, m: cut_in, cut_out, lane_change as "
        "it comes over the lane line; overtake as it comes back; brake, stop as it begins; follow all along",
    )
    lateral_speed: Quantity | None = Field(
        None, description="lane_change, cut_in, cut_out, swerve, drift: how fast it moves sideways, m/s"
    )
    part: v.Part | None = Field(None, description="collide: the part of itself that touches first")
    target_part: v.Part | None = Field(None, description="collide: the part of `target` that is struck")
    abandoned: bool = Field(
        False,
        description="begun and broken off: lane_change, cut_in, overtake back to its own lane before it is over; "
        "cross_road as far as the road's edge",
    )
    clearance: Metres | None = Field(
        None,
        description="room to `target`, m: stop as it stands before it; swerve, overtake, keep_lane at least, going by; "
        "cross_road abandoned: to the road's edge",
    )
    trigger: Trigger | None = None
    until: Trigger | None = Field(None, description="what ends it; default: it ends by itself or as the next begins")


class PlaceSpec(Spec):
    """R: the place where it happens, seen from ego."""

    component: Literal["R"] = "R"
    kind: v.PlaceKind = "road"
    arms: Literal[3, 4] | None = Field(None, description="intersection: number of roads that meet")
    control: v.Control | None = Field(None, description="intersection: what regulates it")
    manoeuvre: v.Manoeuvre | None = Field(None, description="ego's way through the intersection")
    lanes: int | None = Field(None, ge=1, le=4, description="at least so many lanes in ego's direction")
    ego_lane: v.EgoLane | None = Field(None, description="which of them ego starts in")
    oncoming: bool | None = Field(None, description="whether a lane of the other direction adjoins (no divider)")
    curve: v.Side | None = Field(None, description="curve: bend to that side")
    shoulder: bool | None = Field(None, description="whether there is a shoulder or parking lane beside ego's lanes")
    sidewalk: bool | None = Field(None, description="whether there is a sidewalk beside ego's lanes")
    crosswalk: bool | None = Field(None, description="whether a crosswalk lies on ego's way")
    speed_limit: float | None = Field(None, gt=0, le=40, description="posted limit, m/s")
    distance: Metres | None = Field(None, description="from ego's start to the intersection, ramp or crosswalk, m")


class EgoSpec(Spec):
    """E: the vehicle under test: how it drives, and how it reacts."""

    component: Literal["E"] = "E"
    type: v.VehicleType = "car"
    model: str | None = Field(None, description="a CARLA blueprint, where the text names one")
    speed: Speed | None = Field(None, description="initial and cruising speed, m/s; 0: it stands at first")
    pace: v.Pace | None = Field(None, description="that speed in a word, where no number is given")
    phases: tuple[Phase, ...] = Field((), description="what it does of its own accord, in order")
    reaction: v.Reaction = Field("none", description="how it answers what the others do")
    react_to: Reference | None = Field(None, description="to whom; default: whatever comes into its way")
    hard: bool = Field(False, description="whether it reacts with an emergency manoeuvre")

    @field_validator("model")
    @classmethod
    def _blueprint(cls, value: str | None) -> str | None:
        return _checked_blueprint(value)


class Placement(Spec):
    """Where an object starts."""

    position: v.Position = "ahead"
    of: Reference = Field("ego", description="seen from whom")
    along: v.Along | None = Field(None, description="lengthwise to `of`; default: what the position says, else ahead")
    side: v.Side | None = Field(
        None, description="beside, roadside, sidewalk, parked, partly_in_lane, intersection_exit: on which side"
    )
    gap: Metres | None = Field(None, description="between the bounding boxes, along the road, m")
    lanes_over: Literal[1, 2] = Field(1, description="left_lane, right_lane: how many lanes over")
    lateral: Metres | None = Field(
        None, description="beside, roadside, partly_in_lane: between its body and that of `of`, across the road, m"
    )
    arrives: Seconds | None = Field(
        None,
        description="where its way meets ego's (oncoming_lane of another: level with that one): how long after ego it "
        "is there if neither reacts, s; 0: together, below 0: before ego",
    )
    later: Seconds | None = Field(
        None,
        description="how much later (below 0: earlier) it starts than follows from the speeds that are said, s: the "
        "planner's correction for what ego does on its way",
    )
    hidden_by: Reference | None = Field(None, description="the object that blocks ego's view of it at first")
    facing: Literal["along", "against", "across"] | None = Field(None, description="its heading against the road's")


class ObjectSpec(Spec):
    """O: another road user, obstacle or thing at the road."""

    component: Literal["O"] = "O"
    name: str = Field("actor", description="a short name in the program, such as lead or pedestrian")
    type: v.ObjectType = "car"
    model: str | None = Field(None, description="a CARLA blueprint, where the text names one")
    count: int = Field(1, ge=1, le=8)
    spacing: Metres | None = Field(None, description="between the members where there are several, m")
    placement: Placement = Placement()
    speed: Speed | None = Field(None, description="initial speed, m/s; 0: it stands at first")
    pace: v.Pace | None = Field(None, description="that speed in a word, where no number is given")
    phases: tuple[Phase, ...] = Field((), description="what it does, in order; none: it keeps on as it started")
    limit: float | None = Field(None, gt=0, le=40, description="speed_sign: what it says, m/s")

    @field_validator("name")
    @classmethod
    def _identifier(cls, value: str) -> str:
        name = re.sub(r"\W+", "_", value.strip().lower()).strip("_")
        return name if name and not name[0].isdigit() else f"object_{name}".rstrip("_")

    @field_validator("model")
    @classmethod
    def _blueprint(cls, value: str | None) -> str | None:
        return _checked_blueprint(value)


class LightChange(Spec):
    """A change of the traffic light that ego faces."""

    to: v.LightState = Field(description="what it shows from then on")
    when: Trigger = Field(description="when it changes; subject: default ego")


class SettingsSpec(Spec):
    """G: the global configuration (the paper's G_settings)."""

    component: Literal["G"] = "G"
    map: str | None = Field(None, description="a CARLA town or a map of the user's; none: the default")
    weather: tuple[v.Weather, ...] = Field((), description="none: the default, clear")
    time: v.TimeOfDay | None = Field(None, description="none: the default, day")
    preset: str | None = Field(None, description="a CARLA weather preset, where the text names one")
    parameters: dict[str, float] = Field({}, description="single CARLA weather parameters that override the rest")
    light: v.LightState | None = Field(None, description="state of the traffic light that ego faces, at first")
    light_changes: tuple[LightChange, ...] = Field((), description="how that light changes during the run, in order")


class Condition(Spec):
    """A condition on the scene or the run."""

    kind: v.ConditionKind
    subject: Reference = "ego"
    other: Reference | None = None
    minimum: float | None = Field(None, description="distance, closest, travelled: m; time: s; at least so much")
    maximum: float | None = Field(None, description="distance, closest, travelled: m; time: s; at most so much")
    action: v.Action | None = None


BOUNDED_IN = "speed: m/s; acceleration, deceleration, lateral_acceleration: m/s2; jerk: m/s3; gap: m; ttc: s"
"""The unit of a limit, by its kind."""


class Limit(Spec):
    """A bound that a run must keep all along: by it a run is judged, nobody does anything for it."""

    kind: v.LimitKind = Field(description="what is bounded")
    subject: Reference = "ego"
    other: Reference | None = Field(None, description="gap, ttc, collision: to whom; default: to everybody")
    minimum: float | None = Field(None, description=f"{BOUNDED_IN}; at least so much")
    maximum: float | None = Field(None, description=f"{BOUNDED_IN}; at most so much")

    @model_validator(mode="after")
    def _bounded(self) -> "Limit":
        if self.kind != "collision" and self.minimum is None and self.maximum is None:
            raise ValueError(f"a limit of {self.kind} needs a minimum or a maximum")
        if self.minimum is not None and self.maximum is not None and self.minimum > self.maximum:
            raise ValueError(f"the limit's minimum {self.minimum:g} is above its maximum {self.maximum:g}")
        return self


class RestrictionsSpec(Spec):
    """T: what must hold at the start and all along, and when the run is over."""

    component: Literal["T"] = "T"
    require: tuple[Condition, ...] = ()
    limits: tuple[Limit, ...] = Field((), description="what the run must keep to all along")
    terminate_when: tuple[Condition, ...] = ()
    duration: float | None = Field(None, gt=0, le=120, description="the run's length, s")


AnySpec = Annotated[
    SettingsSpec | PlaceSpec | EgoSpec | ObjectSpec | RestrictionsSpec, Field(discriminator="component")
]

SPEC_OF = {"G": SettingsSpec, "R": PlaceSpec, "E": EgoSpec, "O": ObjectSpec, "T": RestrictionsSpec}


def _checked_blueprint(value: str | None) -> str | None:
    if value is not None and not re.fullmatch(r"[a-z]+(\.[a-z0-9_]+)+", value):
        raise ValueError(f"{value!r} is no CARLA blueprint (vehicle.maker.model)")
    return value
