"""Programs show what S says: the structures of combinations.yaml, with all their events in every run."""

import pytest

from tests.write.combinations import combinations, missing

SEEDS = 5


@pytest.mark.nightly
async def test_all_events_are_seen(engine):
    found = {name: await missing(engine, row, SEEDS) for name, row in combinations().items()}
    assert not {name: dict(unseen) for name, unseen in found.items() if unseen}
