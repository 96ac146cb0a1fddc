"""Turns upon scenes: what was meant counts, what was not meant counts against it, and each turn names what is there."""

import pytest

from c2s_bench.interpret import suite, turns


def holds(scene: str, turn: str, expect: object) -> list[bool]:
    return [v.holds for v in turns.judge({"scene": scene, "turn": turn, "expect": expect})]


@pytest.mark.parametrize(
    ("turn", "expect", "found"),
    [
        ("make the lead a truck", {"O1.type": "truck"}, [True]),
        ("make the lead a truck", {"O1.type": "bus"}, [False]),
        ("make the lead a truck", {"O2.type": "pedestrian"}, [True, False]),  # O1 is another, too
        ("make the lead a truck", {"O1": {"may": "change"}, "O2": "gone"}, [False]),
        ("remove the pedestrian", {"O2": "gone"}, [True]),
        ("10 m closer", {"O1.placement.gap": [14, 16]}, [True]),
        ("why does it brake?", "question", [True]),
        ("undo", "redo", [False]),
        ("undo", {"O1.type": "truck", "O2": "gone"}, [False, False]),
    ],
)
def test_verdicts(turn, expect, found):
    assert holds("street", turn, expect) == found


def test_every_entry_is_about_a_scene_and_its_components():
    found = suite.entries(turns.STAGE)
    assert len(found) == 744
    for entry in found:
        known = {*turns.scenes()[entry["scene"]].ids, "new"}
        if not isinstance(entry["expect"], str):
            assert {key.split(".")[0] for key in entry["expect"]} <= known, entry["turn"]
