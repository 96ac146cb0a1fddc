"""The paper's published figures (paper.yaml)."""

from functools import cache
from pathlib import Path
from typing import Any

import yaml


@cache
def paper() -> dict[str, Any]:
    return yaml.safe_load((Path(__file__).parent / "paper.yaml").read_text(encoding="utf-8"))
