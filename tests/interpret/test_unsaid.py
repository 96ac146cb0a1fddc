"""Agents and patients that a clause leaves unsaid."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "V1 did not see that V2 had slowed down and hit it.",
        "Ego failed to realise that a van had stopped and hit its rear.",
    ],
)
def test_who_did_not_notice_strikes(read, text: str) -> None:
    found = read(text)
    assert [(p.action, p.target) for p in found.ego.spec.phases] == [("collide", "O1")]
    assert not any(p.action == "collide" for o in found.objects for p in o.spec.phases)


@pytest.mark.parametrize("how", ["obstructed by", "hidden by", "screened by"])
def test_who_is_obstructed_is_hidden(read, how: str) -> None:
    found = read(f"A pedestrian, {how} a parked van, crosses from the right.")
    person = next(o.spec for o in found.objects if o.spec.type == "pedestrian")
    assert person.placement.hidden_by == next(o.id for o in found.objects if o.spec.type == "van")
