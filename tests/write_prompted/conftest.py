"""The scripted server, and the real check server, for tests of the writers that ask a model."""

import asyncio
from collections.abc import Iterator

import pytest

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckReport, CheckRequest, Limits, PlacesReport, PlacesRequest
from tests.models.fixtures import client_of, server

__all__ = ["client_of", "server"]


LIMITS = Limits(sample_seconds=30, iterations=150)


class Checker:
    """The check server, to be called from plain and from async code; `asked` counts."""

    def __init__(self, client: SyncCheckClient) -> None:
        self.client = client
        self.asked = 0

    def check(self, text, spans=(), upto="sample") -> CheckReport:
        self.asked += 1
        folder = str(paths.shipped("maps"))
        return self.client.check(
            CheckRequest(program=text, spans=tuple(spans), upto=upto, folder=folder, limits=LIMITS)
        )

    async def places(self, request: PlacesRequest) -> PlacesReport:
        return await asyncio.to_thread(self.client.places, request)

    async def __call__(self, text, spans=(), upto="sample") -> CheckReport:
        return await asyncio.to_thread(self.check, text, spans, upto)


@pytest.fixture(scope="session")
def checker() -> Iterator[Checker]:
    with SyncCheckClient() as client:
        yield Checker(client)
