"""What the embedded interpreter says of each clause of a text."""

from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from c2s_engine.interpret.embedded import EmbeddedInterpreter, InterpretError
from c2s_engine.structure.account import account

CASES = yaml.safe_load(Path(__file__).with_suffix(".yaml").read_text("utf-8"))


@pytest.mark.parametrize("case", CASES, ids=lambda c: c["text"][:40])
def test_clauses(read: Any, case: dict[str, Any]) -> None:
    found = account(read(case["text"]))
    for words, (status, fields) in case["clauses"].items():
        at = case["text"].index(words)
        clause = next(c for c in found if c.span[0] <= at < c.span[1])
        assert (clause.status, *(f for f in fields if f not in clause.fields)) == (status,), clause
        assert clause.reason or status == "understood"


SENTENCES = [
    "Ego drives at 50 km/h.", "A van brakes hard, and ego stops.", "the truck, which was parked, wobbles", "(rain)",
    "Two men were hurt!", "- ped X-ing @ zebra", "E/B unit 1 -> struck by V2;", "\n\n", "“No,” she said...", "🚗",
]  # fmt: skip


@settings(max_examples=20, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.sampled_from(SENTENCES) | st.text(max_size=12), min_size=1, max_size=4))
def test_nothing_of_any_text_is_outside_the_account(pieces: list[str]) -> None:
    text = " ".join(pieces)
    try:
        structure = EmbeddedInterpreter().interpret(text).structure
    except InterpretError:
        return
    found = account(structure)
    held = {i for c in found for i in range(*c.span)}
    assert all(text[i].isspace() for i in set(range(len(text))) - held)
    assert all(c.text == text[slice(*c.span)] for c in found)
    assert all(c.components or c.lost for c in found), "a clause of which nothing is said"
