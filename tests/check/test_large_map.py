"""The benchmark's large map is the town several times over, with links of its own in each."""

import xml.etree.ElementTree as ET
from collections import Counter
from pathlib import Path

from c2s_bench.perf import large_map
from c2s_engine import paths


def test_every_id_is_used_once_and_every_link_leads_somewhere(tmp_path: Path) -> None:
    root = ET.parse(large_map.write(tmp_path)).getroot()
    town = ET.parse(paths.shipped("maps", "town.xodr")).getroot()
    for tag in ("road", "junction"):
        ids = [e.get("id") for e in root.findall(tag)]
        assert len(set(ids)) == len(ids) == large_map.TOWNS * len(town.findall(tag))
    roads, junctions = ({e.get("id") for e in root.findall(tag)} for tag in ("road", "junction"))
    for link in root.iterfind("road/link/*"):
        assert link.get("elementId") in (roads if link.get("elementType") == "road" else junctions)
    for connection in root.iter("connection"):
        assert {connection.get("incomingRoad"), connection.get("connectingRoad")} <= roads
    assert {r.get("junction") for r in root.findall("road")} <= junctions | {"-1"}
    places = Counter((g.get("x"), g.get("y")) for g in root.iter("geometry"))
    assert len(places) == large_map.TOWNS * len({(g.get("x"), g.get("y")) for g in town.iter("geometry")})
