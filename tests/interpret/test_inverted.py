"""Sentences with the subject behind the verb say the same as in plain order."""

import pytest

EGO = "The ego drives along a road. "


@pytest.mark.parametrize(
    ("inverted", "plain"),
    [
        ("Coming the other way was a milk float.", "A milk float was coming the other way."),
    ],
)
def test_same_as_in_plain_order(read, inverted: str, plain: str) -> None:
    one, other = read(EGO + inverted), read(EGO + plain)
    assert [p.action for p in one["E"].spec.phases] == [p.action for p in other["E"].spec.phases]
    assert [p.action for p in one["O1"].spec.phases] == [p.action for p in other["O1"].spec.phases]
    assert one["O1"].spec.placement == other["O1"].spec.placement


@pytest.mark.parametrize(
    "text", ["Behind the ego drives a van that follows closely.", "Behind the ego comes a van that follows it."]
)
def test_whom_a_clause_goes_on_to_tell_of(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "behind"


@pytest.mark.parametrize(
    "text",
    [
        "In heavy rain ego follows a lorry.",
        "On a narrow road the ego follows a tractor.",
        "In the left lane V1 follows a truck.",
        "On the motorway I follow a van.",
    ],
)
def test_a_subject_before_the_verb_stays(read, text: str) -> None:
    assert [p.action for p in read(text)["E"].spec.phases] == ["follow"]
