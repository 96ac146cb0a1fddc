"""Own cache, and a fake engine that worker processes can import."""

import os
from pathlib import Path

import pytest

OWN = """
- id: mine-01
  source: Mine
  reference: r
  text: rain
  tags: {}
  expect: &expect
    actors: [{as: lead, type: car, does: [stop]}]
    environment: {weather: rain}
- {id: mine-02, source: Mine, reference: r, text: fog, tags: {}, expect: *expect}
- {id: mine-03, source: Yours, reference: r, text: refuse rain, tags: {}, expect: *expect}
"""


@pytest.fixture
def calls(tmp_path, monkeypatch):
    """The file in which the fake engine counts its calls."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("FAKE_CALLS", str(tmp_path / "calls"))
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]))
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    return tmp_path / "calls"


@pytest.fixture
def own(tmp_path):
    """A file with three records: one that the fake engine serves well, one half, one not at all."""
    file = tmp_path / "mine.yaml"
    file.write_text(OWN.replace("tags: {}", "tags: {sce: true, vru: [], traffic_control: [], temporal: true, "
                                "vehicle_behaviors: [], vru_behaviors: []}"))  # fmt: skip
    return file
