"""Golden files: what is made must not drift unseen. C2S_GOLDEN=1 writes them anew: look at the difference."""

import os
from pathlib import Path


def assert_same(text: str, file: Path) -> None:
    """The text is as its golden file has it; with C2S_GOLDEN set the file is written anew first."""
    if os.environ.get("C2S_GOLDEN"):
        file.parent.mkdir(exist_ok=True)
        file.write_text(text, encoding="utf-8")
    assert file.exists(), f"{file.name} is missing: set C2S_GOLDEN=1 to write it, and look at it"
    assert text == file.read_text(encoding="utf-8"), f"{file.name} changed; if that is meant, set C2S_GOLDEN=1"
