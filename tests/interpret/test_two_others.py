"""Two others in one text, joined in many manners: each with its own place and its own deed."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter


@pytest.mark.parametrize(
    ("text", "types", "acts"),
    [
        ("The driver ahead turns left.", ["car"], [["turn_left"]]),
        ("The driver behind honks and overtakes.", ["car"], [["overtake"]]),
        ("The motorist in the left lane cuts in.", ["car"], [["cut_in"]]),
        ("Neither the van ahead nor the bus behind brakes.", ["bus", "van"], [[], []]),
        ("The car ahead almost stops and then accelerates.", ["car"], [["brake", "accelerate"]]),
    ],
)
def test_who_is_there_and_who_is_not(text: str, types: list[str], acts: list[list[str]]) -> None:
    structure = EmbeddedInterpreter().interpret(text).structure
    assert sorted(o.spec.type for o in structure.objects) == types
    assert [[p.action for p in o.spec.phases] for o in structure.objects] == acts
