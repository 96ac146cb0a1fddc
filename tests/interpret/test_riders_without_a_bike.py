"""First persons who ride without naming a motorcycle, and who stand or step onto the road."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "I was riding in a taxi when a car hit us.",
        "I was driving home when a motorcyclist riding behind me braked.",
        "I was riding my bicycle to school when a car overtook me.",
        "I was riding with friends in my car when a bus braked ahead of us.",
    ],
)
def test_who_does_not(read, text: str) -> None:
    assert read(text)["E"].spec.type == "car"
