"""The scripted server and clients for it, as fixtures: `from tests.models.fixtures import server` in a conftest."""

from collections.abc import Callable, Iterator

import pytest

from c2s_engine.models import ModelSettings, OllamaClient
from tests.models.fake_ollama import FakeOllama


@pytest.fixture
def server() -> Iterator[FakeOllama]:
    with FakeOllama() as running:
        yield running
        assert not running.violations


@pytest.fixture
def client_of() -> Callable[..., OllamaClient]:
    """A client for a server, with quick tries and without the probe."""

    def make(server: FakeOllama, **settings) -> OllamaClient:
        return OllamaClient(
            ModelSettings(**{"model": "small", "host": server.host, "backoff": 0.001, "probe": False, **settings})
        )

    return make
