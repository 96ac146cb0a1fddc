"""What a newcomer types first, from the README itself: a program without findings that shows all that is required."""

import re
from pathlib import Path

import pytest

README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
TEXTS = [
    re.search(r'\$ c2s generate "([^"]+)"', README)[1],  # type: ignore[index]
    " ".join(re.search(r"1\. Type `([^`]+)`", README)[1].split()),  # type: ignore[index]
]


@pytest.mark.parametrize("text", TEXTS, ids=["command", "app"])
async def test_the_first_texts_of_the_readme(engine, text):
    async for event in engine.generate(text):
        last = event
    assert last.ok and not last.diagnostics, last.diagnostics
    assert last.results and not [r for r in last.results if not r.holds]
