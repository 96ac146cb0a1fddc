"""`c2s bench` with a model: its worker processes ask the scripted server over HTTP, programs are checked and run."""

import json

import pytest
from typer.testing import CliRunner

from c2s_bench.cli import app
from tests.models.fake_ollama import FakeOllama, said
from tests.write_prompted.programmer import TEXT, Programmer, asked_for

RECORD = {
    "id": "mine-01", "source": "Mine", "reference": "r", "text": TEXT,
    "tags": {"sce": True, "vru": ["pedestrian"], "traffic_control": [], "temporal": True, "vehicle_behaviors": [],
             "vru_behaviors": []},
    "expect": {"actors": [{"as": "walker", "type": "pedestrian", "does": ["cross_road"]}]},
}  # fmt: skip


@pytest.fixture
def records(tmp_path, monkeypatch, server):
    """One record in a file; caches and the index in folders of their own."""
    for name in ("CACHE", "DATA", "CONFIG"):
        monkeypatch.setenv(f"XDG_{name}_HOME", str(tmp_path / name.lower()))
    monkeypatch.setenv("OLLAMA_HOST", server.host)
    (tmp_path / "config" / "c2s").mkdir(parents=True)
    (tmp_path / "config" / "c2s" / "config.toml").write_text("[ollama]\nprobe = false\nnum_ctx = 16384\n")
    file = tmp_path / "mine.yaml"
    file.write_text(json.dumps([RECORD]))
    return file


def bench(*arguments):
    result = CliRunner().invoke(app, [*map(str, arguments)])
    assert result.exit_code == 0, (result.output, result.exception)
    return result.stdout


def asked(server: FakeOllama) -> list[str]:
    return [a for a in map(asked_for, server.requests) if a]


@pytest.mark.nightly
def test_the_paper_s_rows_and_tables_are_one_command(records, server):
    server.respond = Programmer()
    common = ["--records", records, "--runs", 1, "--jobs", 1]
    figures = json.loads(bench(*common, "--method", "chat2scenic:C11", "--model", "small", "--json"))
    row = figures["by_record"]["mine-01"]
    assert (row["CSR"], row["DO"], row["FA"]) == (100, 100, 100), row
    assert row["tokens"] > 5000 and row["RT"] > 0 and row["share"] == figures["share"] == 1
    assert asked(server) == ["G", "R", "E", "O1", "O2", "T"]
    prompt = next(said(r) for r in server.requests if asked_for(r) == "O1")
    assert "Code of similar components" in prompt, "CodeICL comes from the real index"

    server.requests.clear()
    table = bench("ablation", "--model", "small", "--only", "C1,C11", *common)
    assert asked(server) == ["G", "R", "E", "O1", "O2", "T"], "C11 is known from before"
    rows = {cells[1].strip(): cells for line in table.splitlines() if len(cells := line.split("|")) > 8}
    assert {"C1", "C1 (paper)", "C10 (paper)", "C11", "C12 (paper)"} <= rows.keys() and "C12" not in rows
    models = bench("table", "--models", "small", "--method", "chat2scenic:C11", "--no-baselines", *common)
    assert "| small | 100.00 |" in models and len(asked(server)) == 6
