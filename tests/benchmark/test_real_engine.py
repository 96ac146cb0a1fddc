"""The benchmark over the real engine: text in, program, rollouts, scores and the raters' sheet out."""

import json

import pytest
import yaml
from typer.testing import CliRunner

from c2s_bench.cli import app

pytestmark = pytest.mark.full

TAGS = "{sce: true, vru: [], traffic_control: [], temporal: true, vehicle_behaviors: [], vru_behaviors: []}"
OWN = f"""
- id: mine-01
  source: Mine
  reference: r
  text: At night in heavy rain, the ego drives at 50 km/h. 30 m ahead in its lane a truck drives, which brakes hard.
  tags: {TAGS}
  expect:
    actors: [{{as: truck, type: truck, starts: {{relation: ahead, lane: same}}, does: [brake_hard]}}]
    environment: {{weather: heavy_rain, time: night}}
- id: mine-02
  source: Mine
  reference: r
  text: At night in heavy rain, the ego drives at 50 km/h behind a truck that is 30 m ahead in its lane.
  tags: {TAGS}
  expect:
    actors: [{{as: bus, type: bus, starts: {{relation: ahead, lane: left}}}}]
    environment: {{weather: fog, time: night}}
"""


def bench(*arguments):
    result = CliRunner().invoke(app, [*map(str, arguments)])
    assert result.exit_code == 0, (result.output, result.exception)
    return result.stdout


def test_from_text_to_scores_and_to_the_raters_sheet(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    (tmp_path / "mine.yaml").write_text(OWN)
    common = ["--records", tmp_path / "mine.yaml", "--runs", 2, "--jobs", 1]
    rows = json.loads(bench(*common, "--json"))["by_record"]
    first, second = rows["mine-01"], rows["mine-02"]
    assert (first["CSR"], first["DO"], first["EN"], first["FA"]) == (100, 100, 100, 100)
    assert second["CSR"] == 100 and second["EN"] == 50 and second["DO"] < 50
    assert 0 < first["RT"] < 60 and first["tokens"] > 0
    bench("rate", *common, "--out", tmp_path / "sheet.yaml", "--split", "all")
    sheet = yaml.safe_load((tmp_path / "sheet.yaml").read_text())
    assert [row["id"] for row in sheet] == ["mine-01", "mine-02"]
    assert "brake_hard" in sheet[0]["events"] and "E" in sheet[0]["picture"] and "ego = new" in sheet[0]["program"]
