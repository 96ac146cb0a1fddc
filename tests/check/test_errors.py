"""Each row of the table of errors: provoked, located, explained and, where that is certain, mended."""

from pathlib import Path

import pytest
import yaml

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.fixes import apply_fixes
from c2s_engine.check.protocol import CheckRequest, Limits
from c2s_engine.structure.program import FragmentSpan

HERE = Path(__file__).parent
TABLE = yaml.safe_load((HERE / "errors.yaml").read_text(encoding="utf-8"))
LIMITS = Limits(iterations=60, wall=30)


def request(row: dict, program: str) -> CheckRequest:
    count = TABLE["head"].count("\n")
    spans = (
        FragmentSpan(component="G", first=1, last=count),
        FragmentSpan(component="O1", first=count + 1, last=count + max(1, row["code"].count("\n"))),
    )
    return CheckRequest(
        program=program, folder=str(paths.shipped("maps")), spans=spans, limits=LIMITS, upto=row.get("upto", "sample")
    )


@pytest.mark.parametrize("name", [n for n, row in TABLE["rows"].items() if "runner" not in row])
def test_row(server: SyncCheckClient, name: str) -> None:
    provoke(server, TABLE["rows"][name])


@pytest.mark.full
def test_rows_of_the_dry_run() -> None:
    with SyncCheckClient(runner="c2s_engine.dryrun.runner:run_scene") as server:
        for row in TABLE["rows"].values():
            if "runner" in row:
                provoke(server, row)


def provoke(server: SyncCheckClient, row: dict) -> None:
    head = "" if row.get("bare") else TABLE["head"]
    program = head + row["code"]
    report = server.check(request(row, program))
    found = [d for s in report.stages for d in s.diagnostics if d.code == row["is"]]
    assert found, [(d.code, d.message) for s in report.stages for d in s.diagnostics]
    first = found[0]
    assert first.stage == row["stage"]
    assert report.ok == (first.severity != "error")
    if "line" in row:
        assert first.line == row["line"] + head.count("\n")
        assert first.text == program.split("\n")[first.line - 1].strip()
        if head:
            assert first.component == "O1"
    for facts in report.facts:
        assert facts.ran or facts.reason in [d.message for s in report.stages for d in s.diagnostics]
    assert len(first.message) > 15
    assert first.fix
    if row.get("mended"):
        mended = apply_fixes(program, found)
        assert mended != program
        after = server.check(request(row, mended))
        assert row["is"] not in [d.code for s in after.stages for d in s.diagnostics]
        assert after.ok, [(d.line, d.code, d.message) for s in after.stages for d in s.diagnostics]
    elif first.severity == "error" and "mended" not in row:
        assert first.edit is None
