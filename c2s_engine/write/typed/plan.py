"""What a structure needs of its place, and what fragments may refer to in it: decided before any line is written."""

from dataclasses import dataclass, field

from c2s_engine.structure.specs import PlaceSpec
from c2s_engine.write.typed.tables import JUNCTION, RAMP


@dataclass(frozen=True)
class Plan:
    """The place as the writer will ask for it, and what the fragments may refer to in it."""

    place: PlaceSpec
    duration: float  # s
    ego_speed: float  # m/s, the middle of it
    ego_top: float  # m/s, the highest of it: who is ahead leaves room for that
    before: float  # m of lane wanted behind ego's start
    after: float  # m wanted ahead of it
    fastest: float  # m/s of whoever is the fastest on the road
    distance: float | tuple[float, float] | None  # m from ego's start to the junction or ramp
    offsets: frozenset[int]  # lane offsets from ego's (+1: one to the left) that fragments refer to
    base: int  # index of ego's lane in its group (0: rightmost, -1: leftmost)
    approaches: tuple[tuple[str, str], ...] = ()  # (position, turn type) that objects need
    pocketed: dict[str, str] = field(default_factory=dict)  # who waits on an approach -> who drives past it there
    pockets: tuple[tuple[str, str], ...] = ()  # (position, turn type of who drives past) of those
    oncoming: bool = False
    single: bool = False  # a road with one lane each way
    ordinary: bool = False  # a road as most are: nothing says how many lanes it has, and nobody needs a second one
    ramp: bool = False
    stops: tuple[str, ...] = ()  # positions of those who pass a stop sign of their own
    priority: tuple[str, ...] = ()  # positions of those who cross and need not stop where ego has a sign
    exit_room: float = 0.0  # m of lane wanted behind the junction; 0: nobody stands there
    reach: float = 0.0  # m that objects take of ego's road ahead of its start
    lengths: dict[str, float] = field(default_factory=dict)  # m that rows take of lanes that end where they meet ego's
    lane_of: dict[str, int | None] = field(default_factory=dict)  # object id -> lane offset at the start
    set_out: frozenset[str] = frozenset()  # who stand before the junction and set out into ego's way
    parked: bool = False  # whether somebody is: on a road with a parking lane or shoulder, where the map has one
    also: tuple[str, ...] = ()  # manoeuvre types by which others leave ego's lane
    across: bool = False  # whether ego may start on the other side of another junction, where roads are short
    leads: dict[str, tuple[str, ...]] = field(default_factory=dict)  # object id -> who is ahead of it in its lane

    @property
    def ways_of_others(self) -> tuple[tuple[str, str], ...]:
        """(position, turn type) of all ways by which others reach the junction."""
        return tuple(dict.fromkeys((*self.approaches, *self.pockets)))

    @property
    def turning(self) -> bool:
        """Whether ego's way takes a manoeuvre that the place names (`place.turn`)."""
        return self.junction or self.ramp or self.place.kind in RAMP

    @property
    def junction(self) -> bool:
        return self.place.kind in JUNCTION
