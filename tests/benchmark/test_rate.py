"""The sheet for scores by hand: what raters see, and the agreement with the executed scores."""

import pytest
import yaml
from bench_scenes import record, run, thing

from c2s_bench.rate import markdown, read_sheet, write_sheet
from c2s_bench.records import BenchmarkError
from c2s_bench.results import result_of
from c2s_bench.tasks import Outcome

EXPECT = "actors: [{as: lead, type: car, does: [stop]}]\nenvironment: {weather: rain}"


@pytest.fixture
def sheet(tmp_path):
    """A sheet of three records, of which one did not run, with EN executed 100 and 0 and DO 100 and 100."""
    records = [record(EXPECT, f"own-0{k}") for k in (1, 2, 4)]
    rain, dry = (run(thing("lead", does=("stop",)), weather=w) for w in (("rain",), ("clear",)))
    results = []
    for item, facts in zip(records, ([rain], [dry], []), strict=True):
        rows = tuple(f.model_dump(mode="json") for f in facts)
        results.append(result_of(item, Outcome("k", item.id, program="ego = new Car \n", facts=rows), 1))
    file = tmp_path / "sheet.yaml"
    shown = {"own-01": rain, "own-02": dry}
    assert write_sheet(file, records, results, shown, lambda identity: f"a picture of {identity}  \n ^") == 2
    return file


def fill(sheet, scores):
    rows = yaml.safe_load(sheet.read_text())
    for row, given in zip(rows, scores, strict=True):
        row["scores"] = given
    sheet.write_text(yaml.safe_dump(rows))


def test_raters_see_the_scenario_and_not_the_executed_scores(sheet):
    first, second = yaml.safe_load(sheet.read_text())
    assert first["id"] == "own-01" and first["text"] == "A text." and first["program"] == "ego = new Car"
    assert "lead (car): 1.0 s stop" in first["events"] and "weather: rain" in first["events"]
    assert first["picture"] == "a picture of own-01\n ^"
    assert first["scores"] == second["scores"] == {"DO": None, "EN": None}


def test_agreement_of_the_filled_sheet(sheet):
    fill(sheet, [{"DO": 100, "EN": 95}, {"DO": 50, "EN": None}])
    found = read_sheet(sheet)
    assert set(found) == {"DO", "EN", "SQ"}
    do, en, sq = found["DO"], found["EN"], found["SQ"]
    assert (do.number, do.by_hand, do.executed, do.difference, do.near) == (2, 75, 100, 25, 50)
    assert (en.number, en.difference, en.near, en.correlation) == (1, 5, 100, None)
    assert (sq.by_hand, sq.executed) == ((97.5 + 50) / 2, 100)
    assert "| DO | 2 | 75.0 | 100.0 | 25.0 | 50 | - |" in markdown(found)


def test_agreement_is_perfect_where_both_say_the_same(sheet):
    fill(sheet, [{"DO": 100, "EN": 100}, {"DO": 100, "EN": 0}])
    found = read_sheet(sheet)
    assert found["EN"].correlation == pytest.approx(1) and found["SQ"].difference == 0


@pytest.mark.parametrize(
    ("scores", "complaint"),
    [
        ({"EN": 120}, "EN must be a number from 0 to 100"),
        ({"EN": "good"}, "EN must be a number"),
        ({"RL": 50}, "says nothing about RL"),
        ({}, "no score is filled in"),
    ],
)
def test_a_sheet_filled_in_wrongly_is_refused(sheet, scores, complaint):
    fill(sheet, [scores, {}])
    with pytest.raises(BenchmarkError, match=complaint):
        read_sheet(sheet)
