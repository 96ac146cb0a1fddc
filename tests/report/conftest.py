"""One engine for the dossiers' tests."""

from collections.abc import AsyncIterator

import pytest_asyncio

from c2s_engine.api import Engine
from c2s_engine.config import Settings


@pytest_asyncio.fixture(scope="module")
async def engine() -> AsyncIterator[Engine]:
    async with Engine(Settings(offers=False)) as started:
        yield started
