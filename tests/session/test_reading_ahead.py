"""A map is read before it is asked for."""

import pytest

from c2s_engine.api import Engine

pytestmark = pytest.mark.asyncio


async def test_a_map_that_is_there_is_read_ahead_and_another_is_not_looked_for():
    async with Engine() as engine:
        assert await engine.warm("town")
        assert not await engine.warm("nowhere")
