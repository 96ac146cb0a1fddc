"""From answers to code."""

import pytest

from c2s_engine.models.errors import AnswerUnusable
from c2s_engine.write.prompted.parsing import code_of

CODE = "spot = new OrientedPoint ahead of ego by 10\nlead = new Car at spot,\n    with name 'lead'"


@pytest.mark.parametrize(
    "answer",
    [
        CODE,
        f"```scenic\n{CODE}\n```",
        f"```\n{CODE}\n```",
        f"```python\n{CODE}",
        f"<think>```scenic\nego = 1\n```</think>Here:\n```scenic\n{CODE}\n```\nThat is all.",
        f"1. Select Car.\n```scenic\nwrong = 1\n```\nBetter:\n```scenic\n{CODE}\n```",
        f"```scenic\n## O1: A car.\n{CODE}\n```",
        f"```scenic\nparam map = localPath('x.xodr')\nmodel scenic.simulators.carla.model\n{CODE}\n```",
        "   ```scenic\n" + "\n".join("    " + line for line in CODE.splitlines()) + "\n   ```",
        CODE.replace("    ", "\t"),
    ],
)
def test_the_code_is_found(answer):
    assert code_of(answer, "O") == CODE


def test_what_the_code_so_far_holds_is_not_written_twice():
    before = "EGO_SPEED = 10\n\nego = new Car at start,\n    with behavior Drives()\n"
    answer = (
        f"```scenic\nEGO_SPEED = 10\nego = new Car at start,  # as before\n    with behavior Drives()\n\n{CODE}\n```"
    )
    assert code_of(answer, "O", before) == CODE


@pytest.mark.parametrize(
    "answer",
    [
        "",
        "   ",
        "I cannot do that.",
        "```scenic\n```",
        "```\n# only a comment\n```",
        "<think>ego = 1",
        "Yes.\nNo.\nMaybe.",
    ],
)
def test_no_code_is_said(answer):
    with pytest.raises(AnswerUnusable, match="no code"):
        code_of(answer, "O")


def test_a_header_keeps_its_map():
    header = "param map = localPath('town.xodr')\nmodel scenic.simulators.carla.model"
    assert code_of(f"```scenic\n{header}\n```", "G") == header
