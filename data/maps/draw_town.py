"""Draws docs/town.svg: `python data/maps/draw_town.py [OUT]`."""

import sys
from pathlib import Path

from c2s_engine.maps.drawing import sheet
from c2s_engine.maps.extras import read_extras

HERE = Path(__file__).parent
VIEWS = [
    ("Signalised, two lanes each way", (-600.0, 0.0), 110.0),
    ("Roundabout", (1150.0, 500.0), 130.0),
    ("Roundabout of three lanes", (-2250.0, 1450.0), 190.0),
    ("Crosswalk between junctions", (-300.0, 500.0), 70.0),
    ("Exit of the motorway", (-610.0, -1520.0), 240.0),
]

if __name__ == "__main__":
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent.parent / "docs" / "town.svg"
    out.write_text(sheet(read_extras(HERE / "town.xodr"), VIEWS) + "\n")
