"""A map of the size of CARLA's larger towns: the shipped town several times, side by side."""

import copy
import xml.etree.ElementTree as ET
from pathlib import Path

from c2s_engine import paths

TOWNS = 4
APART = 12_000  # m
IDS = 10_000  # between the ids of one town and those of the next


def write(folder: Path) -> Path:
    """Write large.xodr into a folder."""
    tree = ET.parse(paths.shipped("maps", "town.xodr"))
    root = tree.getroot()
    first = [child for child in root if child.tag != "header"]
    for i in range(1, TOWNS):
        for child in first:
            moved = copy.deepcopy(child)
            _move(moved, i)
            root.append(moved)
    path = folder / "large.xodr"
    tree.write(path, encoding="utf-8", xml_declaration=True)
    return path


def _move(child: ET.Element, i: int) -> None:
    """Move one element of the map to the i-th town: its place and all ids that it has or names."""
    for node in child.iter():
        if node.tag == "geometry":
            node.set("x", repr(float(node.get("x", "0")) + i * APART))
        for name in ("elementId", "incomingRoad", "connectingRoad", "junction"):
            if int(node.get(name, "-1")) >= 0:
                node.set(name, str(int(node.get(name, "-1")) + i * IDS))
        if node.tag in ("road", "junction", "junctionGroup", "signal", "signalReference", "object"):
            node.set("id", str(int(node.get("id", "0")) + i * IDS))
