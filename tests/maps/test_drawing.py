"""Pictures of maps: well-formed, within their frame, and the README's is up to date."""

import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from c2s_engine import paths
from c2s_engine.maps.drawing import close_up, overview

PICTURE = Path(__file__).parents[2] / "docs" / "town.svg"


def test_the_picture_in_the_documentation_is_up_to_date(tmp_path):
    out = tmp_path / "town.svg"
    script = paths.shipped("maps", "draw_town.py")
    subprocess.run([sys.executable, str(script), str(out)], check=True, timeout=60)
    assert out.read_text() == PICTURE.read_text()


def test_the_overview_shows_every_road_and_kind_of_place(extras):
    picture = ElementTree.fromstring(overview(extras))
    lines = [each for each in picture if each.tag.endswith("polyline")]
    assert len(lines) == len(extras.roads)
    words = {each.text for each in picture if each.tag.endswith("text")}
    assert {"motorway", "rural", "town", "signal", "stop", "yield", "uncontrolled", "roundabout", "crosswalk"} <= words


@pytest.mark.parametrize("centre", [(-600, 0), (1150, 500), (700, -1500)])
def test_close_views_stay_in_their_frame(extras, centre):
    picture = close_up(extras, centre, 100, pixels=200)
    points = re.findall(r"(-?[0-9.]+),(-?[0-9.]+)", " ".join(re.findall(r'<polygon points="([^"]+)"', picture)))
    assert len(points) > 50
    assert all(0 <= float(number) <= 200 for point in points for number in point)
