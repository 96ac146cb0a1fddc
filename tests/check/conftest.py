"""One warm check server for all tests of this folder, with a runner that stands still."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from c2s_engine.check.client import SyncCheckClient

RUNNER = "standing_runner:run_scene"


@pytest.fixture(scope="session", autouse=True)
def _runner_path() -> Iterator[None]:
    """Let the server's process find the runner of these tests."""
    with pytest.MonkeyPatch.context() as patch:
        here = str(Path(__file__).parent)
        patch.setenv("PYTHONPATH", os.pathsep.join(p for p in (here, os.environ.get("PYTHONPATH")) if p))
        yield


@pytest.fixture(scope="session")
def server(_runner_path: None) -> Iterator[SyncCheckClient]:
    with SyncCheckClient(runner=RUNNER) as client:
        yield client
