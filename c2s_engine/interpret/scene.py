"""Fifth stage: the scene as a whole, as data: who is there, what each does, where, how fast."""

from dataclasses import dataclass, field

from c2s_engine.interpret.reading import scan, syntax
from c2s_engine.interpret.surroundings import environment
from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.surroundings.settings import Settings
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.stated_limits import StatedLimit
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.where.relations import Places, Where
from c2s_engine.interpret.who.mentions import Cast, Entity

__all__ = ["ACTIVE", "Scene", "side"]

ACTIVE = frozenset(
    [
        "brake",
        "brake_stop",
        "stop",
        "accelerate",
        "start",
        "lane_change",
        "cut_in",
        "cut_out",
        "overtake",
        "follow",
        "swerve",
        "drift",
        "turn",
        "u_turn",
        "go_straight",
        "cross_road",
        "move_along",
        "enter_road",
        "leave_road",
        "exit_road",
        "reverse",
        "oncoming",
        "run_red",
        "run_stop",
        "yield",
        "lose_control",
        "collide",
        "cross_path",
        "approach",
        "keep_lane",
        "evade",
        "travel",
        "stationary",
        "lead",
        "held_up",
        "pass_by",
    ]
)


@dataclass
class Scene:
    """Everything that was understood of a text, before it becomes specs."""

    text: str
    plain: str
    sentences: list[tuple[int, int]]
    words: list[syntax.Word]
    cast: Cast
    clauses: Clauses
    places: Places
    road: Road
    settings: Settings
    light: list[environment.Found]
    actors: list[Entity] = field(default_factory=list)
    speeds: dict[Entity, tuple[float, float, int, int]] = field(default_factory=dict)
    by_ego: dict[Entity, tuple[float, float]] = field(default_factory=dict)  # speeds by ego's: (times, plus m/s)
    spans: list[scan.Span] = field(default_factory=list)
    ids: dict[Entity, str] = field(default_factory=dict)  # who is which component of S: ego, O1, ...
    limits: list[StatedLimit] = field(default_factory=list)  # what must be kept to all along
    endings: list[tuple[int, int]] = field(default_factory=list)  # where the conditions stand that end the run

    def events(self, entity: Entity) -> list[Event]:
        """What the entity is said to do, in order, without what is denied or only imagined."""
        return [
            e
            for e in self.clauses.events
            if (e.agent is entity or entity in e.also and e.patient is not entity) and e.done and e.act in ACTIVE
        ]

    def does(self, entity: Entity, *acts: str) -> Event | None:
        """The first event of that entity with one of those acts."""
        return next((e for e in self.events(entity) if e.act in acts), None)

    def where(self, entity: Entity) -> Where:
        return self.places.of.get(entity) or Where()
