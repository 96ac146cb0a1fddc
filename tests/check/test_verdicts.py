"""The verdict of a check is Scenic's own, on good and bad programs (what the lint adds is listed)."""

import re
from pathlib import Path

import pytest
import yaml
from tests_of_stock import stock

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest, Limits

HERE = Path(__file__).parent
STRICTER = {"undefined_name", "take_behavior", "do_action", "wrong_keyword", "undeclared_param", "enumeration"}
"""Errors in code that a compile and a sample need not reach: Scenic finds them in a run, or never."""


@pytest.mark.nightly
def test_verdicts_are_scenics(server: SyncCheckClient, tmp_path: Path) -> None:
    table = yaml.safe_load((HERE / "errors.yaml").read_text(encoding="utf-8"))
    programs: dict[str, str] = {}
    for folder in (HERE / "programs", paths.shipped("examples", "programs")):
        programs.update({p.stem: p.read_text(encoding="utf-8") for p in sorted(folder.glob("*.scenic"))})
    for name, row in table["rows"].items():
        if row.get("upto", "sample") == "sample" and not row["is"].startswith("import "):
            programs[re.sub(r"\W+", "_", name)] = ("" if row.get("bare") else table["head"]) + row["code"]
    source = tmp_path / "programs"
    source.mkdir()
    for name, text in programs.items():
        (source / f"{name}.scenic").write_text(text, encoding="utf-8")
    (tmp_path / "stock").mkdir()
    expected = stock(tmp_path / "stock", sorted(source.glob("*.scenic")))
    differing = []
    for name, text in programs.items():
        request = CheckRequest(
            program=text, folder=str(paths.shipped("maps")), seed=3, limits=Limits(iterations=300, sample_seconds=60)
        )
        report = server.check(request)
        codes = {d.code for s in report.stages for d in s.diagnostics if d.severity == "error"}
        if report.ok != ("scene" in expected[name]) and not codes & STRICTER:
            differing.append((name, report.ok, codes, expected[name].get("error")))
    assert len(programs) >= 40
    assert differing == []
