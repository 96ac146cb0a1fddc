"""The descriptions written afresh, and the table of how they end."""

import pytest
import yaml

from c2s_bench.through.run import Description, Outcome, collect, fresh, of_records, table
from c2s_engine.paths import shipped


def test_the_descriptions_differ_and_expect_known_events():
    events = yaml.safe_load(shipped("events.yaml").read_text(encoding="utf-8"))
    descriptions = fresh()
    assert len(descriptions) >= 20
    assert len({d.name for d in descriptions}) == len({d.text for d in descriptions}) == len(descriptions)
    for description in descriptions:
        assert description.events, description.name
        assert {name for name, _ in description.events} <= set(events), description.name


def test_the_reporting_part_keeps_its_names():
    names = [d.name for d in of_records()]
    assert len(names) == 123
    assert names.count("reporting part") == 40


@pytest.mark.full
def test_a_run_and_a_refusal_are_told_apart():
    followed = "The ego follows a truck at 40 km/h on a straight road. The truck brakes hard and the ego brakes."
    expected = (("brake_hard", "O1"), ("hits", "O1"))
    ran, refused = collect([Description("a", followed, expected), Description("b", "Hm.")])
    assert ran.runs and ran.missing == (("hits", "O1"),)
    assert refused.cause.startswith("interpret") and "driving scenario" in refused.sentence
    assert "| runs | 1 |" in table([ran, refused])
    assert not Outcome("c", "sample: rejected").runs
