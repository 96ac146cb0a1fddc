"""Entities and mentions: who is meant, as data."""

from dataclasses import dataclass, field

from c2s_engine.structure import vocabulary

VEHICLES = frozenset(("vehicle", *vocabulary.VEHICLES))
MOTOR = VEHICLES - {"bicycle"}
URGENT = vocabulary.WITH_SIREN
PERSONS = vocabulary.ON_FOOT
MOVERS = VEHICLES | PERSONS
ZONES = frozenset(("construction_zone", "lane_closure"))
DEFINITE = frozenset(("the", "this", "that", "its", "said", "these", "those", "both", "their", "his", "her"))
ORDINALS = {"first": 0, "second": 1, "third": 2, "fourth": 3, "last": -1}


@dataclass
class Mention:
    """A place in the text where an entity is meant."""

    word: int
    start: int
    end: int
    definite: bool = False
    kind: str = "actor"


@dataclass(eq=False)
class Entity:
    """Ego, or another road user or thing of the scene."""

    key: str
    type: str
    noun: str = ""
    count: int = 1
    label: str = ""
    roles: set[str] = field(default_factory=set)
    mentions: list[Mention] = field(default_factory=list)
    typed: bool = False
    ordinal: int | None = None
    group: "Entity | None" = None  # whose member it is ("the second of them")
    names: set[str] = field(default_factory=set)  # of the person who drives it
    manned: bool = False  # whether the person in or on it was spoken of: "he" or "she" may mean it
    sex: str = ""  # "m" or "f", as far as it was told; "i" of who tells the story

    @property
    def ego(self) -> bool:
        return self.key == "ego"

    @property
    def person(self) -> bool:
        return self.type in PERSONS

    @property
    def mover(self) -> bool:
        return self.type in MOVERS


def fits(entity: Entity, kind: str) -> bool:
    """Whether an entity can be meant by a noun of that type."""
    if entity.type == kind:
        return True
    if kind == "vehicle":
        return entity.type in VEHICLES
    if kind == "car":
        return entity.type in ("vehicle", "police_car")
    if {kind, entity.type} == {"truck", "pickup"}:
        return True
    if kind == "rider":
        return entity.type in ("bicycle", "motorcycle")
    if entity.type == "vehicle":
        return kind in MOTOR and not entity.typed
    if kind == "pedestrian":
        return entity.type == "child"
    if kind in ("obstacle", "debris"):
        return not entity.mover and entity.type not in ZONES
    if kind == "ambulance":
        return entity.type in ("fire_truck", "police_car")
    return False
