"""Scenic's own results for comparison, from a process of its own (stock.py)."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

from c2s_engine import paths

HERE = Path(__file__).parent


def stock(folder: Path, programs: list[Path]) -> dict[str, dict]:
    """Scenic's own results, from copies beside a copy of the map (it writes a cache there)."""
    shutil.copy(paths.shipped("maps", "town.xodr"), folder)
    copies = [str(shutil.copy(p, folder)) for p in programs]
    command = [sys.executable, str(HERE / "stock.py"), str(paths.shipped("standins")), *copies]
    out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return {r["name"]: r for r in map(json.loads, out.splitlines())}
