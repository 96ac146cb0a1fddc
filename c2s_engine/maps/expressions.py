"""Places as Scenic code: the one source for what a PlaceSpec selects on a map, in programs and in counts.

    code = place_code(spec, read_extras(map_file.path))    # -> PlaceCode(yields, expression, comment, missing)

`expression` is one static list expression, valid as Scenic and as Python, over `network`, `ManeuverType`, `Vector` and
builtins only (no random values), so that a program holds it as it is and the check server counts it as it is. It yields

- "maneuvers" for intersection, roundabout, on_ramp, off_ramp: scenic Maneuver objects of ego's way (`m.startLane`:
  ego's approach lane, `m.connectingLane`, `m.endLane`, `m.intersection`, `m.conflictingManeuvers`);
- "lanes" for road, straight, curve, motorway: scenic Lane objects in which ego starts;
- "spots" for crosswalk: points (scenic Vector, m) where a crosswalk crosses the middle of a lane that ego drives; ego
  starts `following roadDirection from spot for -distance`, the lane is `network.laneAt(spot)`.

A program then draws: `place = Uniform(*EXPRESSION)`. `room` (m) asks for lanes at least that long (approaches too).
Where stock Scenic knows nothing (stop, yield, limits, crosswalks, ramps, motorways), ids from the map's file stand
in the expression, with `comment` to say so. Where they say that there is no such place, it is `[]`, and `missing`
says why.

Mind that stock Scenic orders `group.lanes` from the kerb inwards for forward lanes only; for a road's backward lanes
it runs from the middle outwards. `sections[0]._fasterLane` / `._slowerLane` are right in both.

The texts stand in data/maps/places.yaml, this module puts them together.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import yaml

from c2s_engine import paths
from c2s_engine.maps.extras import MapExtras
from c2s_engine.maps.spots import approaches_with_crosswalk, crosswalk_spots, has_room_crosswalk
from c2s_engine.structure.specs import PlaceSpec

Yields = Literal["lanes", "maneuvers", "spots"]
LIMIT_TOLERANCE = 0.55  # m/s
FAST = 24.0
"""m/s: from this limit on a plain road may be a carriageway of a motorway."""
MARGIN = 15.0
"""m of approach beyond the distance that a spec asks for."""


@dataclass(frozen=True)
class PlaceCode:
    """An expression that gives the places; `missing` says in a sentence why it can only give none."""

    yields: Yields
    expression: str
    comment: str = ""
    missing: str = ""


@lru_cache(maxsize=1)
def _table() -> dict[str, Any]:
    return yaml.safe_load(paths.shipped("maps", "places.yaml").read_text(encoding="utf-8"))


class _Where:
    """Conditions as they are gathered, and what they rest on."""

    def __init__(self, yields: Yields) -> None:
        entry = _table()["lists"][yields]
        self.text, self.names = entry["text"], {"lane": entry["lane"], "section": entry["section"]}
        self.parts: list[str] = []
        self.notes: list[str] = []
        self.missing = ""

    def add(self, text: str, **values: Any) -> None:
        for name, value in {**self.names, **values}.items():
            text = text.replace("{" + name + "}", str(value))
        if text not in self.parts:
            self.parts.append(text)

    def add_ids(self, text: str, ids: set[Any], note: str, missing: str = "") -> None:
        """A condition on ids from the map's file; an empty set with `missing` means that there is no place."""
        if not ids and missing:
            self.missing = self.missing or missing
            return
        self.add(text, values="{" + ", ".join(map(str, sorted(ids))) + "}")
        self.notes.append(note)

    def code(self, yields: Yields) -> PlaceCode:
        where = f" if {' and '.join(self.parts)}" if self.parts else ""
        expression = self.text.replace(" if {where}", where)
        comment = f"From the map's file: {'; '.join(dict.fromkeys(self.notes))}." if self.notes else ""
        if self.missing:
            return PlaceCode(yields, "[]", missing=self.missing)
        return PlaceCode(yields, expression, comment)


def place_code(spec: PlaceSpec, extras: MapExtras, *, room: float = 0.0, exit_room: float = 0.0) -> PlaceCode:
    """What a place selects on the map at hand.

    `room`: least length (m) of ego's lane (up to the junction); `exit_room`: of the lane behind the junction.
    """
    kind = _table()["kinds"][spec.kind]
    yields: Yields = kind["yields"]
    if yields == "spots":
        return _spots(spec, extras, room)
    where = _Where(yields)
    if yields == "lanes":
        _lanes(where, spec, kind, extras)
    else:
        _ways(where, spec, kind, extras)
    _common(where, spec, extras, yields)
    fields = _table()["fields"]
    least = max(room, _high(spec.distance) + MARGIN if yields == "maneuvers" and spec.distance is not None else 0.0)
    if least:
        where.add(fields["room"], n=_plain(least))
    if exit_room and yields == "maneuvers":
        where.add(fields["exit_room"], n=_plain(exit_room))
    return where.code(yields)


def place_expression(spec: PlaceSpec, extras: MapExtras, *, room: float = 0.0, exit_room: float = 0.0) -> str:
    """The expression alone."""
    return place_code(spec, extras, room=room, exit_room=exit_room).expression


def survey(extras: MapExtras) -> dict[str, str]:
    """What is counted on a map for its overview: name -> expression."""
    return {name: place_expression(PlaceSpec(**fields), extras) for name, fields in _table()["survey"].items()}


def relaxed(spec: PlaceSpec) -> dict[str, PlaceSpec]:
    """The specs that leave out one field, by the field's name: where a place is missing, one of them may be near."""
    kept = {"component", "kind"}
    return {
        name: spec.model_copy(update={name: None})
        for name in type(spec).model_fields
        if name not in kept and getattr(spec, name) is not None
    }


def nearest(spec: PlaceSpec, counts: dict[str, int]) -> str:
    """A sentence on which single field, left out, gives places (`counts` of `relaxed(spec)` by name)."""
    found = [f"without {name} = {getattr(spec, name)} there are {n}" for name, n in counts.items() if n]
    return "; ".join(found)[:1].upper() + "; ".join(found)[1:] + "." if found else "No single field is the cause."


def _lanes(where: _Where, spec: PlaceSpec, kind: dict[str, Any], extras: MapExtras) -> None:
    fields = _table()["fields"]
    if spec.kind == "motorway":
        ids = {r.id for r in extras.roads.values() if r.junction is None and r.motorway}
        where.add_ids(kind["where"][0], ids, "motorways", "The map has no motorway.")
    elif _two_way(spec):
        where.add(fields["two_way"])
    elif spec.lanes in (None, 1):
        ramps = {j.ramp for j in extras.junctions.values() if j.ramp is not None}
        if ramps:
            where.add_ids(fields["no_ramp"], ramps, "ramps are left out")
    if spec.kind == "curve":
        text = kind[spec.curve] if spec.curve else kind["where"][0]
        where.add(text.replace("{bend}", kind["bend"]))
    elif spec.kind == "straight":
        where.add(kind["where"][0])
    if spec.crosswalk is not None:
        ids = {c.road for c in extras.crosswalks if has_room_crosswalk(extras, c)}
        where.add_ids(fields["crosswalk_on_road"][spec.crosswalk], ids, "roads with a crosswalk",
                      "The map has no mid-block crosswalk." if spec.crosswalk else "")  # fmt: skip


def _two_way(spec: PlaceSpec) -> bool:
    """Whether a plain road means one with both directions: motorways and ramps are asked for by kind or by fields."""
    return spec.oncoming is not False and (spec.lanes or 1) < 3 and (spec.speed_limit or 0.0) < FAST


def _ways(where: _Where, spec: PlaceSpec, kind: dict[str, Any], extras: MapExtras) -> None:
    fields = _table()["fields"]
    if spec.kind == "roundabout":
        rings = extras.of_kind("roundabout")
        pairs = {(j, r) for j in rings for r in extras.junctions[j].incoming if r in extras.junctions[j].outgoing}
        where.add_ids(kind["where"][0], pairs, "ways into the roundabout", "The map has no roundabout.")
        return
    if spec.kind in ("on_ramp", "off_ramp"):
        _ramp(where, spec, kind, extras)
        return
    if spec.arms:
        where.add(fields["arms"][spec.arms])
    if spec.control == "signal":
        where.add(fields["signal_among_signs" if extras.signs_on_ways else "signal"])
    elif spec.control == "none":
        regulated = {c.junction for c in extras.controls}
        free = {j for j in extras.of_kind("intersection") if j not in regulated}
        where.add_ids(fields["no_signal"], free, "intersections without lights and signs",
                      "The map has no uncontrolled intersection.")  # fmt: skip
    elif spec.control:
        pairs = {(j, r) for j in extras.of_kind("intersection") for r in extras.junctions[j].incoming
                 if extras.control(j, r) == spec.control}  # fmt: skip
        where.add_ids(fields["signs"], pairs, f"approaches with a {spec.control} sign",
                      f"The map has no intersection with {spec.control} signs.")  # fmt: skip
    others = extras.of_kind("roundabout", "on_ramp", "off_ramp", "transition")
    if others and spec.arms != 4 and spec.control is None:
        real = extras.of_kind("intersection")
        where.add_ids(fields["junctions"], real, "intersections, not ramps", "The map has no intersection.")
    if spec.manoeuvre:
        where.add(fields["manoeuvre"][spec.manoeuvre])
    if spec.crosswalk is not None:
        pairs = approaches_with_crosswalk(extras)
        where.add_ids(fields["crosswalk_at_junction"][spec.crosswalk], pairs, "approaches with a crosswalk",
                      "The map has no crosswalk at an intersection." if spec.crosswalk else "")  # fmt: skip


def _ramp(where: _Where, spec: PlaceSpec, kind: dict[str, Any], extras: MapExtras) -> None:
    """Ego's way over a ramp; with several lanes asked for at an on-ramp, or another than the rightmost lane at an
    off-ramp, ego keeps to the motorway."""
    ids = extras.of_kind(spec.kind)
    ramps = {extras.junctions[j].ramp for j in ids}
    word = "on-ramps" if spec.kind == "on_ramp" else "off-ramps"
    missing = f"The map has no {word[:-1]}."
    stays = spec.ego_lane in ("leftmost", "middle") or (spec.kind == "on_ramp" and (spec.lanes or 1) > 1)
    if not stays:
        where.add_ids(kind["where"][0], ramps, word, missing)
        return
    main = {r for j in ids for r in extras.junctions[j].incoming if r not in ramps}
    where.add_ids(_table()["fields"]["junctions"], ids, word, missing)
    where.add_ids("m.startLane.road.id in {values}", main, f"the motorway at {word}", missing)


def _common(where: _Where, spec: PlaceSpec, extras: MapExtras, yields: Yields) -> None:
    fields = _table()["fields"]
    if spec.lanes and spec.lanes > 1:
        where.add(fields["lanes"], n=spec.lanes)
    for name in ("ego_lane", "oncoming", "shoulder", "sidewalk"):
        value = getattr(spec, name)
        if value is not None:
            where.add(fields[name][value])
    if spec.speed_limit is not None:
        ids = {r.id for r in extras.roads.values() if r.junction is None and r.limit is not None
               and abs(r.limit - spec.speed_limit) <= LIMIT_TOLERANCE}  # fmt: skip
        limit = f"{spec.speed_limit * 3.6:.0f} km/h"
        where.add_ids(fields["speed_limit"], ids, f"roads with a limit of {limit}",
                      f"The map has no road with a limit of {limit}.")  # fmt: skip


def _spots(spec: PlaceSpec, extras: MapExtras, room: float) -> PlaceCode:
    before = max(room, _high(spec.distance) + MARGIN if spec.distance is not None else 0.0)
    spots = crosswalk_spots(extras, spec, before)
    if not spots:
        return PlaceCode("spots", "[]", missing="The map has no crosswalk of that kind.")
    text = ", ".join(f"Vector({x:.1f}, {y:.1f})" for x, y in spots)
    return PlaceCode("spots", f"[{text}]", "From the map's file: where crosswalks cross lanes.")


def _high(value: Any) -> float:
    return float(value[1] if isinstance(value, tuple | list) else value)


def _plain(value: float) -> str:
    return f"{value:.0f}" if value == int(value) else f"{value:.1f}"
