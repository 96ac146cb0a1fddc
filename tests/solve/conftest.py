"""One engine a test."""

import pytest

from c2s_engine.api import Engine


@pytest.fixture
async def engine():
    async with Engine() as started:
        yield started
