"""Pictures of a run: what must be in them."""

import subprocess
import sys
import xml.etree.ElementTree as ET

from c2s_engine.dryrun.outline import box_of, map_outline
from c2s_engine.dryrun.picture import frames, png_picture, svg_picture, text_frames, text_picture
from c2s_engine.dryrun.recording import Recording
from c2s_engine.dryrun.runner import tracks_of


def made(town):
    ways = [
        town.ride("ego", town.lane(43, 1), 300, 20.0),
        town.ride("lead<1>", town.lane(43, 1), 340, 15.0),
        town.prop("cone", town.lane(43, 0), 400),
    ]
    recording = Recording(0.1, ways)
    outline = map_outline(town.network, box_of(recording), town.extras)
    return tracks_of(recording).model_copy(update={"outline": outline})


def test_svg_shows_roads_trails_boxes_and_names(town):
    root = ET.fromstring(svg_picture(made(town), frame=100))
    tags = [element.tag.rpartition("}")[2] for element in root.iter()]
    texts = [element.text for element in root.iter() if element.tag.endswith("text")]
    assert tags.count("polygon") >= 3 + 3 and tags.count("polyline") >= 2
    assert {"ego", "lead<1>", "cone", "10.0 s"} <= set(texts)


def test_png(town):
    assert png_picture(made(town)).startswith(b"\x89PNG")


def test_text_moves_from_frame_to_frame(town):
    ways = made(town)
    first, last = text_picture(ways, 0, 80, 20), text_picture(ways, -1, 80, 20)
    for picture in (first, last):
        lines = picture.splitlines()
        assert len(lines) <= 20 and max(map(len, lines)) <= 80
        assert "E" in picture and "A" in picture and "b" in picture and "░" in picture
    assert first != last and "72 km/h" in last
    assert len(list(text_frames(ways, 80, 20, 1.0))) == (frames(ways) + 9) // 10


def test_the_front_draws_without_scenic():
    heavy = "any(m.split('.')[0] in ('scenic', 'shapely') for m in sys.modules)"
    code = f"import sys, c2s_engine.dryrun.picture; sys.exit({heavy})"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
