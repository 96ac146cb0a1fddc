"""`c2s bench` end to end over worker processes, with an engine that needs no Scenic."""

import json

import pytest
from typer.testing import CliRunner

from c2s_bench.cli import app
from c2s_bench.records import load
from c2s_bench.results import load_results
from c2s_bench.runner import run
from c2s_bench.store import Store
from c2s_bench.tasks import Outcome, Setup, tasks_for

FAKE = ["--engine", "bench_fake:engine"]


def bench(*arguments, code=0):
    result = CliRunner().invoke(app, [*map(str, arguments)])
    assert result.exit_code == code, (result.output, result.exception)
    return result.output if code else result.stdout


@pytest.mark.full
def test_json_has_the_figures_in_all_by_source_and_by_record(calls, own):
    data = json.loads(bench("--records", own, "--runs", 3, "--jobs", 2, "--json", *FAKE))
    assert data["total"] == pytest.approx(
        {"number": 3, "CSR": 200 / 3, "RT": data["total"]["RT"], "tokens": 120, "RL": None, "TI": None, "TM": None,
         "DO": 100, "EN": 50, "SQ": 75, "FA": 50, "excluded": 0}
    )  # fmt: skip
    assert {s: row["number"] for s, row in data["by_source"].items()} == {"Mine": 2, "Yours": 1}
    rows = data["by_record"]
    assert {i: (r["CSR"], r["SQ"], r["FA"], r["DO"], r["EN"]) for i, r in rows.items()} == {
        "mine-01": (100, 100, 100, 100, 100),
        "mine-02": (100, 50, 50, 100, 0),
        "mine-03": (0, 0, 0, 0, 0),
    }
    assert rows["mine-03"]["reason"] == "compile: no such lane"
    assert data["by_kind"] == {
        "DO presence": {"holds": 2, "of": 2}, "DO stop": {"holds": 2, "of": 2}, "EN weather": {"holds": 1, "of": 2}
    }  # fmt: skip


def test_what_is_known_is_not_run_again(calls, own):
    first = bench("--records", own, "--jobs", 0, *FAKE)
    assert len(calls.read_text()) == 3
    assert bench("--records", own, "--jobs", 0, *FAKE) == first
    assert len(calls.read_text()) == 3
    bench("--records", own, "--jobs", 0, "--seed", 7, *FAKE)
    assert len(calls.read_text()) == 6
    bench("--records", own, "--jobs", 0, "--fresh", *FAKE)
    assert len(calls.read_text()) == 9


def test_results_of_many_files_have_a_name_that_a_disk_takes(calls, own, tmp_path):
    several = [tmp_path / f"{'records' * 6}_{i}.yaml" for i in range(8)]
    for i, file in enumerate(several):
        file.write_text(own.read_text(encoding="utf-8").replace("mine-0", f"mine-{i}"), encoding="utf-8")
    flags = [flag for file in several for flag in ("--records", file)]
    assert json.loads(bench(*flags, "--runs", 1, "--jobs", 0, "--json", *FAKE))["total"]["number"] == 24


@pytest.mark.full
def test_an_interrupted_run_goes_on_where_it_stopped(calls, own):
    tasks = tasks_for(load([own]), Setup(runs=1))
    outcomes = run(tasks, Store(), engine="bench_fake:engine")
    next(outcomes)
    outcomes.close()
    kept = sum(Store().get(t.key) is not None for t in tasks)
    assert kept == 1
    before = len(calls.read_text())
    assert len(list(run(tasks, Store(), engine="bench_fake:engine"))) == 3
    assert len(calls.read_text()) == before + 2


@pytest.mark.full
def test_a_process_that_dies_costs_its_record_only_and_is_tried_again(calls, own):
    own.write_text(own.read_text().replace("text: fog", "text: die").replace("text: refuse rain", "text: raise"))
    tasks = tasks_for(load([own]), Setup(runs=1))
    by_id = {o.id: o for o in run(tasks, Store(), engine="bench_fake:engine")}
    assert by_id["mine-01"].facts and not by_id["mine-01"].error
    assert "its process died" in by_id["mine-02"].error
    assert by_id["mine-03"].error == "RuntimeError: out of order"
    assert [Store().get(t.key) is not None for t in tasks] == [True, False, False]


def test_an_engine_that_cannot_be_started_is_one_sentence(calls, own):
    said = bench("--records", own, "--jobs", 1, "--engine", "bench_fake:nothing", code=1)
    assert "the engine cannot be started" in said and "has no attribute 'nothing'" in said


@pytest.mark.full
def test_nothing_that_could_be_run_is_one_sentence(calls, own):
    own.write_text(own.read_text().replace("text: ", "text: raise "))
    said = bench("--records", own, *FAKE, code=1)
    assert said == "no record could be run with reader: RuntimeError: out of order\n"


def test_explain_shows_each_atom_with_its_share(calls, own):
    said = bench("--records", own, "--explain", "mine-02", "--runs", 4, "--jobs", 0, *FAKE)
    assert "FAILS      0 %  weather rain" in said and "holds    100 %  lead: stop" in said
    assert "(seed 0): lead is lead\n" in said and "lead (car): 1.0 s stop" in said
    assert "# reader: fog" in said
    assert len(calls.read_text()) == 1


def test_the_reporting_part_is_shown_in_sum_only(calls):
    args = ["--split", "test", "--runs", 1, "--jobs", 0, *FAKE]
    data = json.loads(bench(*args, "--json"))
    assert data["total"]["number"] == data["withheld"] == 40 and data["by_record"] == {}
    assert "un-r152-03" not in bench(*args)
    assert "un-r152-03" in json.loads(bench(*args, "--json", "--reveal"))["by_record"]
    assert "--reveal shows it" in bench("--explain", "un-r152-03", *FAKE, code=1)
    assert "no record nothing-01" in bench("--explain", "nothing-01", *FAKE, code=1)


def test_compare_names_records_and_atoms(calls, own, tmp_path):
    bench("--records", own, "--jobs", 0, "--runs", 1, "--out", tmp_path / "a.jsonl", *FAKE)
    own.write_text(own.read_text().replace("text: fog", "text: fog and rain").replace("refuse rain", "fog"))
    bench("--records", own, "--jobs", 0, "--runs", 1, "--out", tmp_path / "b.jsonl", *FAKE)
    said = bench("compare", tmp_path / "a.jsonl", tmp_path / "b.jsonl")
    assert "mine-02: FA 50.0 -> 100.0\n  + EN weather rain" in said
    assert "mine-03: FA 0.0 -> 50.0\n  now runs; before: compile: no such lane" in said
    assert "mine-01" not in said
    assert [r.id for r in load_results(str(tmp_path / "b.jsonl"))] == ["mine-01", "mine-02", "mine-03"]
    assert "there are no results of nothing" in bench("compare", "nothing", tmp_path / "b.jsonl", code=1)


def test_the_papers_tables_are_printed_beside_ours(calls):
    args = ["--split", "dev", "--runs", 1, "--jobs", 0, *FAKE]
    models = bench("table", "--models", "reader", *args)
    assert "| reader | 100.00 |" in models and "| Gemini-3-Flash | 76.42 | 222.11 | 52339 |" in models
    tiers = bench("ablation", "--only", "C4", *args)
    assert "| C4 | yes | - | - | - | - | 100.00 |" in tiers and "| C12 (paper) | yes | yes | yes | yes | yes |" in tiers
    assert "C13 is no configuration" in bench("ablation", "--only", "C13", *args, code=1)


def test_distribution_and_broken_records(own):
    assert "| UN R171 | 36 | 35 | 9 | 3 | 0 | 35 | 8 | 3 |" in bench("distribution")
    own.write_text(own.read_text().replace("[stop]", "[levitate]"))
    said = bench("--records", own, code=1)
    assert "mine.yaml:8: mine-01: expect.actors[0].does[0]: 'levitate'" in said


def test_an_outcome_survives_the_store(tmp_path):
    store = Store(tmp_path)
    outcome = Outcome("abcdef", "x-01", program="p", stages=({"name": "run", "ok": True},), tokens=3)
    store.put(outcome)
    kept = store.get("abcdef")
    assert kept and (kept.program, kept.tokens, list(kept.stages)) == ("p", 3, list(outcome.stages))
    (tmp_path / "ab" / "abcdef.json").write_text("{")
    assert store.get("abcdef") is None


@pytest.mark.full
def test_the_same_on_a_dask_cluster(calls, own):
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        remote = bench("--records", own, "--runs", 2, "--scheduler", cluster.scheduler_address, "--json", *FAKE)
    local = json.loads(bench("--records", own, "--runs", 2, "--fresh", "--json", *FAKE))
    remote = json.loads(remote)
    for data in (remote, local):
        for part in ("by_part", "by_source", "by_record"):
            for row in data[part].values():
                row.pop("RT")
        data["total"].pop("RT")
    assert remote == local
    assert len(calls.read_text()) == 6


@pytest.mark.full
def test_a_scheduler_that_is_not_there_is_one_sentence(calls, own):
    pytest.importorskip("distributed")
    assert "no Dask scheduler answers" in bench("--records", own, "--scheduler", "tcp://127.0.0.1:1", *FAKE, code=1)


def test_an_outcome_is_kept_for_the_settings_that_the_model_was_asked_with(monkeypatch, tmp_path):
    record = load()[:1]
    setup = Setup(method="typed", model="some")
    keys = set()
    for tokens in (256, 512, 256):
        config = tmp_path / str(tokens) / "c2s"
        config.mkdir(parents=True, exist_ok=True)
        (config / "config.toml").write_text(f"[ollama]\nanswer_tokens = {tokens}\n")
        monkeypatch.setenv("XDG_CONFIG_HOME", str(config.parent))
        keys.add(tasks_for(record, setup)[0].key)
    assert len(keys) == 2
