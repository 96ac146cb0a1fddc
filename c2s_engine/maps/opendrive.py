"""OpenDRIVE as XML, read with care, and its geometry: where (road, s, t) lies and how wide lanes are. Units: m, rad."""

import math
import xml.etree.ElementTree as ET
from bisect import bisect_right
from dataclasses import dataclass
from pathlib import Path
from xml.parsers import expat

MAX_BYTES = 80_000_000
"""Twenty-five times as many as Town04 has."""
MAX_ELEMENTS = 1_000_000
"""Thirty times as many as Town04 has."""
MAX_DEPTH = 40
MAX_LENGTH = 100_000.0
"""m of a road."""
COMPRESSED = (b"PK\x03\x04", b"\x1f\x8b", b"BZh", b"\xfd7zXZ\x00")
"""How zip, gzip, bzip2 and xz files begin."""
DRIVABLE = frozenset({"driving", "entry", "exit", "offRamp", "onRamp", "connectingRamp"})
"""The lane types that Scenic drives on."""


class BrokenMap(ValueError):
    """A map file that cannot be read; the message is one sentence that says why."""


def refuse_large(path: Path) -> None:
    """Raises BrokenMap where a file is larger than any map; OSError."""
    if path.stat().st_size > MAX_BYTES:
        raise BrokenMap(f"{path.name} is larger than {MAX_BYTES // 1_000_000} MB: it is not read as a map.")


def parse(path: Path) -> ET.Element:
    """The root element of an OpenDRIVE file; refuses document types and entities. Raises BrokenMap."""
    builder = ET.TreeBuilder()
    parser = expat.ParserCreate()
    elements = depth = 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal elements, depth
        elements, depth = elements + 1, depth + 1
        if elements > MAX_ELEMENTS or depth > MAX_DEPTH:
            raise BrokenMap(f"{path.name} has more elements, or deeper ones, than any map needs: it is not read.")
        builder.start(tag.rpartition("}")[2], attributes)

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(tag.rpartition("}")[2])

    parser.StartElementHandler = start
    parser.EndElementHandler = end

    def refuse(*_: object) -> None:
        raise BrokenMap(
            f"{path.name} declares a document type or entities, which no OpenDRIVE map needs: it is not read."
        )

    parser.StartDoctypeDeclHandler = refuse
    parser.EntityDeclHandler = refuse
    try:
        refuse_large(path)
        data = path.read_bytes()
        if data.startswith(COMPRESSED):
            raise BrokenMap(f"{path.name} is a compressed file: unpack it, and give the .xodr file that is in it.")
        parser.Parse(data, True)  # at once: a long attribute in pieces takes quadratic time
        root = builder.close()
    except expat.ExpatError as error:
        reason = expat.errors.messages.get(error.code, "no XML")
        raise BrokenMap(f"{path.name} is no well-formed XML: {reason} in line {error.lineno}.") from None
    except OSError as error:
        raise BrokenMap(f"{path.name} cannot be read: {error.strerror or error}.") from None
    if root.tag != "OpenDRIVE":
        raise BrokenMap(f"{path.name} is no OpenDRIVE map: its outermost element is <{root.tag[:40]}>.")
    return root


def number(element: ET.Element, name: str, default: float | None = None) -> float:
    """An attribute as a finite number; raises BrokenMap."""
    text = element.get(name)
    try:
        value = float(text) if text is not None else default
    except ValueError:
        value = None
    if value is None or not math.isfinite(value):
        raise BrokenMap(f"<{element.tag} {name}={(text or '')[:40]!r}> in the map should be a number.")
    return value


@dataclass(frozen=True)
class Piece:
    """One geometry of a reference line, beginning at s."""

    s: float
    x: float
    y: float
    heading: float
    length: float
    kind: str
    terms: tuple[float, ...]

    def at(self, ds: float) -> tuple[float, float, float]:
        """(x, y, heading) that far along."""
        u, v, turn = self._local(max(0.0, min(ds, self.length)))
        c, s = math.cos(self.heading), math.sin(self.heading)
        return self.x + u * c - v * s, self.y + u * s + v * c, self.heading + turn

    def _local(self, ds: float) -> tuple[float, float, float]:
        if self.kind == "arc" and self.terms[0]:
            k = self.terms[0]
            return math.sin(k * ds) / k, (1 - math.cos(k * ds)) / k, k * ds
        if self.kind == "spiral":
            return self._spiral(ds)
        if self.kind == "poly3":
            _, b, c, d = self.terms
            return ds, self.terms[0] + ds * (b + ds * (c + ds * d)), math.atan(b + ds * (2 * c + 3 * d * ds))
        if self.kind == "paramPoly3":
            *t, scale = self.terms
            p = ds / self.length * scale if self.length else 0.0
            u, v = (t[i] + p * (t[i + 1] + p * (t[i + 2] + p * t[i + 3])) for i in (0, 4))
            du, dv = (t[i + 1] + p * (2 * t[i + 2] + 3 * p * t[i + 3]) for i in (0, 4))
            return u, v, math.atan2(dv, du)
        return ds, 0.0, 0.0

    def _spiral(self, ds: float) -> tuple[float, float, float]:
        """By Simpson's rule over the heading."""
        begin, end = self.terms
        rate = (end - begin) / self.length if self.length else 0.0

        def turn(s: float) -> float:
            return begin * s + rate * s * s / 2

        count = 2 * max(2, math.ceil(ds / 4))
        step = ds / count
        weights = [1, *([4, 2] * (count // 2))[:-1], 1]
        u = sum(w * math.cos(turn(i * step)) for i, w in enumerate(weights)) * step / 3
        v = sum(w * math.sin(turn(i * step)) for i, w in enumerate(weights)) * step / 3
        return u, v, turn(ds)


@dataclass(frozen=True)
class Lane:
    """A lane of a section: its signed id, type, and width as (offset in the section, a, b, c, d)."""

    id: int
    type: str
    widths: tuple[tuple[float, ...], ...]

    def width(self, ds: float) -> float:
        return _cubic(self.widths, ds)


@dataclass(frozen=True)
class Section:
    """A lane section that begins at s."""

    s: float
    lanes: tuple[Lane, ...]

    def side(self, sign: int) -> list[Lane]:
        """The lanes left (1) or right (-1) of the reference line, from the middle outwards."""
        return sorted((lane for lane in self.lanes if lane.id * sign > 0), key=lambda lane: abs(lane.id))

    def driving(self, sign: int) -> list[Lane]:
        return [lane for lane in self.side(sign) if lane.type in DRIVABLE]


@dataclass(frozen=True)
class Road:
    """A road's geometry and lanes."""

    id: int
    length: float
    pieces: tuple[Piece, ...]
    offsets: tuple[tuple[float, ...], ...]
    sections: tuple[Section, ...]

    def at(self, s: float, t: float = 0.0) -> tuple[float, float, float]:
        """(x, y, heading of the reference line) at road coordinates, t to the left."""
        piece = self.pieces[max(0, bisect_right([p.s for p in self.pieces], s) - 1)]
        x, y, heading = piece.at(s - piece.s)
        return x - t * math.sin(heading), y + t * math.cos(heading), heading

    def section(self, s: float) -> Section:
        return self.sections[max(0, bisect_right([sec.s for sec in self.sections], s) - 1)]

    def edges(self, s: float, lane: int, section: Section | None = None) -> tuple[float, float]:
        """The inner and outer edge (t) of a lane."""
        section = section or self.section(s)
        sign = 1 if lane > 0 else -1
        t = _cubic(self.offsets, s) if self.offsets else 0.0
        for beside in section.side(sign):
            width = sign * max(0.0, beside.width(s - section.s))
            if beside.id == lane:
                return t, t + width
            t += width
        raise KeyError(lane)


def _cubic(records: tuple[tuple[float, ...], ...], s: float) -> float:
    begin, a, b, c, d = (0.0, 0.0, 0.0, 0.0, 0.0)
    for record in records:
        if record[0] <= s + 1e-9:
            begin, a, b, c, d = record
    ds = s - begin
    return a + ds * (b + ds * (c + ds * d))


def _terms(element: ET.Element, *names: str) -> tuple[float, ...]:
    return tuple(number(element, name, 0.0) for name in names)


def _piece(element: ET.Element) -> Piece:
    shape = element[0] if len(element) else ET.Element("line")
    length = number(element, "length")
    terms: tuple[float, ...] = ()
    if shape.tag == "arc":
        terms = _terms(shape, "curvature")
    elif shape.tag == "spiral":
        terms = _terms(shape, "curvStart", "curvEnd")
    elif shape.tag == "poly3":
        terms = _terms(shape, "a", "b", "c", "d")
    elif shape.tag == "paramPoly3":
        scale = length if shape.get("pRange") == "arcLength" else 1.0
        terms = (*_terms(shape, "aU", "bU", "cU", "dU", "aV", "bV", "cV", "dV"), scale)
    return Piece(number(element, "s"), number(element, "x"), number(element, "y"), number(element, "hdg"), length,
                 shape.tag, terms)  # fmt: skip


def _section(element: ET.Element) -> Section:
    lanes = [
        Lane(int(number(lane, "id")), lane.get("type", "none"),
             tuple(_terms(width, "sOffset", "a", "b", "c", "d") for width in lane.iter("width")))
        for side in ("left", "right")
        for lane in element.findall(f"{side}/lane")
    ]  # fmt: skip
    return Section(number(element, "s"), tuple(lanes))


def read_road(element: ET.Element) -> Road:
    """Geometry and lanes of a <road>; raises BrokenMap."""
    pieces = tuple(_piece(geometry) for geometry in element.findall("planView/geometry"))
    sections = tuple(_section(section) for section in element.findall("lanes/laneSection"))
    rid = int(number(element, "id"))
    if not pieces or not sections:
        missing = "geometry (<planView>)" if not pieces else "lanes"
        raise BrokenMap(f"Road {rid} of the map has no {missing}: export the map again, or take another.")
    length = number(element, "length")
    if not 0 <= length <= MAX_LENGTH or any(not 0 <= piece.length <= MAX_LENGTH for piece in pieces):
        raise BrokenMap(f"Road {rid} of the map has a length that no road has.")
    offsets = tuple(_terms(offset, "s", "a", "b", "c", "d") for offset in element.findall("lanes/laneOffset"))
    return Road(rid, length, pieces, offsets, sections)
