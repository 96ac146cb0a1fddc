"""A packed network has the values and types that Scenic's own pickle has, and gives the same unions."""

import pickle
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy
import pytest
import shapely

from c2s_engine import paths
from c2s_engine.check import networks, packing

pytestmark = pytest.mark.full

TOWN = paths.shipped("maps", "town.xodr")


@pytest.fixture(scope="module")
def parsed() -> Any:
    """The town as Scenic's own pickle gives it."""
    from scenic.domains.driving.roads import Network

    return pickle.loads(pickle.dumps(Network.fromOpenDrive(TOWN)))


@pytest.fixture(scope="module")
def packed(parsed: Any) -> Any:
    return packing.unpack(packing.pack(parsed))


def differences(one: Any, other: Any) -> Iterator[str]:
    """Where two nests of objects differ in value or type; what was compared once is not compared again."""
    todo: list[tuple[str, Any, Any]] = [("", one, other)]
    seen: dict[int, int] = {}
    while todo:
        path, a, b = todo.pop()
        if type(a) is not type(b):
            yield f"{path}: {type(a)} {type(b)}"
        elif isinstance(a, shapely.geometry.base.BaseGeometry):
            if shapely.to_wkb(a) != shapely.to_wkb(b):
                yield f"{path}: {a} {b}"
        elif isinstance(a, shapely.STRtree):
            todo.append((f"{path}.geometries", list(a.geometries), list(b.geometries)))
        elif isinstance(a, tuple | list):
            if len(a) != len(b):
                yield f"{path}: {len(a)} {len(b)}"
            todo += [(f"{path}[{i}]", *pair) for i, pair in enumerate(zip(a, b, strict=False))]
        elif isinstance(a, dict):
            if list(a) != list(b):
                yield f"{path}: {list(a)} {list(b)}"
            todo += [(f"{path}[{key!r}]", a[key], b.get(key)) for key in a]
        elif isinstance(a, type | weakref.ProxyType) or callable(a):
            continue
        elif not hasattr(a, "__dict__"):
            if a != b:
                yield f"{path}: {a!r} {b!r}"
        elif id(a) not in seen:
            seen[id(a)] = id(b)
            names = [n for n in (*vars(a), *packing._MADE) if hasattr(type(a), n) or n in vars(a)]
            names = [n for n in dict.fromkeys(names) if n != packing._HOW]
            todo += [(f"{path}.{name}", getattr(a, name, None), getattr(b, name, None)) for name in names]
        elif seen[id(a)] != id(b):
            yield f"{path}: one object there, two here"


def test_equal_values_and_types(parsed: Any, packed: Any) -> None:
    assert list(differences(parsed, packed)) == []


def test_what_follows_from_shapes_is_not_kept(packed: Any) -> None:
    found = packing.unpack(packing.pack(packed))
    lines = [e.centerline for e in found.elements.values() if hasattr(e, "centerline")]
    assert not any("points" in vars(line) for line in lines)
    assert all(isinstance(line.points, tuple) and "points" in vars(line) for line in lines)
    assert {type(number) for line in lines for point in line.points for number in point[:2]} == {float, numpy.float64}


def test_points_that_do_not_follow_are_kept() -> None:
    from scenic.core.regions import PolylineRegion

    line = PolylineRegion([(0, 0), (3, 0), (3, 4)])
    line.points = ((1, 2, 0),)
    line.orientation = None
    assert packing.unpack(packing.pack(line)).points == ((1, 2, 0),)


@pytest.mark.parametrize("data", [b"", b"x", pickle.dumps((0, [], b"")), pickle.dumps((packing.FORMAT, [], b"x"))])
def test_what_is_no_packed_network_is_refused(data: bytes) -> None:
    with pytest.raises(pickle.UnpicklingError):
        packing.unpack(data)


def test_a_broken_file_is_made_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, parsed: Any) -> None:
    from scenic.core import regions
    from scenic.domains.driving.roads import Network

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(networks, "_networks", {})
    monkeypatch.setattr(networks, "_unions", {})
    monkeypatch.setattr(regions, "polygonUnion", networks.union(regions.polygonUnion))
    load = networks.from_file(lambda *_, **__: parsed)
    assert load(Network, TOWN) is parsed
    (file,) = tmp_path.rglob("*.packed")
    for broken in (b"", file.read_bytes()[:-9]):
        file.write_bytes(broken)
        networks._networks.clear()
        assert len(load(Network, TOWN).lanes) == len(parsed.lanes)
    networks._networks.clear()
    networks._unions.clear()
    found = load(Network, TOWN)
    assert found is not parsed
    ((parts, union),) = networks._unions.values()
    assert any(part is found.drivableRegion.polygons for part in parts)
    assert shapely.to_wkb(union) == shapely.to_wkb(networks.prepare(parsed)[0][-1])
