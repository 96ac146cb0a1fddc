"""One index of the shipped data for all tests of this room, built once with the real model."""

import os
import shutil
from pathlib import Path

import pytest

from c2s_engine.retrieve.library import Library


@pytest.fixture(scope="session")
def index_folder(tmp_path_factory):
    """A folder with a built index; tests copy it before they write. C2S_TEST_INDEX names one to bring up to date."""
    folder = tmp_path_factory.mktemp("retrieve") / "index"
    if known := os.environ.get("C2S_TEST_INDEX"):
        shutil.copytree(Path(known), folder)
    Library(folder, threads=2).build()
    return folder


@pytest.fixture
def own_index(index_folder, tmp_path):
    """A copy of the index that a test may change."""
    return shutil.copytree(index_folder, tmp_path / "index")
