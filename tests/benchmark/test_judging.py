"""Dossiers for judges, and what their verdicts say together."""

from pathlib import Path

import pytest
import yaml
from typer.testing import CliRunner

from c2s_bench.cli import app
from c2s_bench.judging.verdicts import kappa

TEXTS = [
    {"id": "truck", "text": "The ego follows a truck at 50 km/h. The truck brakes hard.", "matters": "it brakes hard"},
    {"id": "poem", "text": "Roses are red and violets are blue."},
]


def judge(*arguments: object, code: int = 0) -> str:
    result = CliRunner().invoke(app, ["judge", *map(str, arguments)])
    assert result.exit_code == code, (result.output, result.exception)
    return result.output


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("judging")
    (folder / "texts.yaml").write_text(yaml.safe_dump(TEXTS))
    said = judge(folder / "texts.yaml", "--out", folder / "out")
    assert "2 dossiers in" in said and "1 did not run: poem" in said
    return folder / "out"


def given(folder: Path, scenario: str, judge_name: str, verdict: str, **more: object) -> None:
    content = f"judge: {judge_name}\nverdict: {verdict}\n{yaml.safe_dump(more) if more else ''}"
    (folder / scenario / f"verdict-{judge_name}.yaml").write_text(content)


def test_judges_see_the_rubric_and_no_scores(written: Path) -> None:
    text = (written / "truck" / "report.md").read_text()
    assert text.startswith("## How to judge") and TEXTS[0]["text"] in text and "it brakes hard" in text
    assert "reader" not in text and "equirement" not in text
    assert (written / "truck" / "moments.png").is_file() and not list(written.rglob("*.json.gz"))


def test_verdicts_are_counted_and_compared(written: Path) -> None:
    given(written, "truck", "ann", "yes", readability=4, loss_said=True)
    given(written, "truck", "bob", "minor", faults=[{"layer": "realism", "what": "ends late"}], readability=2)
    given(written, "poem", "ann", "no", faults=[{"layer": "actors", "what": "nobody"}])
    given(written, "poem", "bob", "no", loss_said=False)
    said = judge("--read", written)
    assert "| ann | 2 | 1 | 0 | 1 | 4.00 | 100% |" in said and "| bob | 2 | 0 | 1 | 1 | 2.00 | 0% |" in said
    assert "- no by every judge: 1: poem" in said and "- judges differ: 1: truck" in said
    assert "| realism | 1 | 1 | truck |" in said
    assert "- yes / minor / no: 50% of 2, kappa 0.33" in said
    assert "“All requirements hold” agrees with “yes” in" in said and "of 4 verdicts" in said


def test_a_judge_may_hand_in_one_list(written: Path) -> None:
    entries = [{"id": "truck", "judge": "cem", "verdict": "minor"}, {"id": "poem", "judge": "cem", "verdict": "no"}]
    file = written / "verdicts-cem.yaml"
    file.write_text(yaml.safe_dump(entries))
    assert "| cem | 2 | 0 | 1 | 1 |" in judge("--read", written)
    file.unlink()


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("verdict: perhaps", "verdict: Input should be 'yes', 'minor' or 'no'"),
        ("verdict: no\nfaults: [{layer: looks}]", "faults.0.layer: Input should be"),
        ("verdict: no\nreadability: 9", "readability: Input should be less than or equal to 5"),
        ("just words", "must be a map with judge"),
        ("verdict: [", "no YAML"),
        ("id: nowhere\nverdict: no", "there is no scenario 'nowhere'"),
    ],
)
def test_verdicts_that_cannot_be_used(written: Path, content: str, says: str) -> None:
    file = written / "truck" / "verdict-zoe.yaml"
    file.write_text(content)
    try:
        assert says in judge("--read", written, code=1)
    finally:
        file.unlink()


@pytest.mark.parametrize(
    ("arguments", "says"),
    [((), "say either RECORDS --out FOLDER"), (("--read", "/nowhere/at/all"), "write the dossiers first"),
     (("/nowhere.yaml", "--out", "/tmp/x"), "There is no file")],
)  # fmt: skip
def test_sentences_for_what_is_missing(arguments: tuple[str, ...], says: str) -> None:
    assert says in " ".join(judge(*arguments, code=1).split())


def test_kappa() -> None:
    assert kappa([("yes", "yes"), ("no", "no")]) == 1
    assert kappa([("yes", "no"), ("no", "yes")]) == -1
    assert kappa([("yes", "yes"), ("yes", "no"), ("no", "yes"), ("no", "no")]) == 0
    assert kappa([("no", "no")]) is None and kappa([]) is None
