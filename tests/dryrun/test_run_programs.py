"""The tool that lists which programs compile and run."""

import sys

import pytest

from c2s_bench.perf import run_programs
from c2s_bench.perf.bench_dryrun import percentile
from c2s_bench.perf.run_programs import Outcome, table
from c2s_engine import paths

HEAD = "param map = localPath('town.xodr')\nparam carla_map = None\nmodel scenic.simulators.carla.model\n"


def test_the_table_counts_those_that_run_among_those_that_compile():
    outcomes = [Outcome("a", "1", "runs"), Outcome("a", "2", "run", "why"), Outcome("b", "3", "compile", "why")]
    rows = table(outcomes).splitlines()
    assert rows[2:] == ["| a | 2 | 2 | 1 | 50.0 |", "| b | 1 | 0 | 0 | – |", "| all | 3 | 2 | 1 | 50.0 |"]


def test_percentiles_lie_between_the_ranks():
    assert percentile([4.0, 1.0, 3.0, 2.0], 0.5) == 2.5 and percentile([1.0], 0.95) == 1.0


@pytest.mark.full
def test_a_folder_of_programs(tmp_path, monkeypatch, capsys):
    (tmp_path / "good.scenic").write_text(HEAD + "ego = new Car\nterminate after 1 seconds\n")
    (tmp_path / "wrong.scenic").write_text(HEAD + "ego = new Car at nowhere\n")
    (tmp_path / "fails.scenic").write_text(HEAD + "behavior B():\n    take SetSpeedAction(unknown())\n"
                                           "unknown = lambda: 1 / 0\nego = new Car with behavior B()\n")  # fmt: skip
    (tmp_path / "town.xodr").symlink_to(paths.shipped("maps", "town.xodr"))
    monkeypatch.setattr(sys, "argv", ["run_programs", str(tmp_path), "--seeds", "1"])
    assert run_programs.main() == 1
    said = capsys.readouterr().out
    assert "good.scenic" not in said and "wrong.scenic: " in said and "fails.scenic: run: " in said
    assert said.rstrip().endswith("| 3 | 2 | 1 | 50.0 |")
    monkeypatch.setattr(sys, "argv", ["run_programs", str(tmp_path / "none")])
    assert run_programs.main() == 2
