"""When something begins: a time, or a distance to ego, however it is put."""

import pytest


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("A van is ahead of ego. The van brakes only after 5 s.", "time", 5),
        ("A lorry leads ego and swerves as soon as ego is 20 m behind it.", "distance", 20),
        ("A cyclist is ahead of ego. The cyclist swerves left as soon as I'm 12 m behind him.", "distance", 12),
        ("A pedestrian stands at the kerb. He starts to cross at a distance of 30 m.", "distance", 30),
        ("A truck ahead of ego brakes at a range of about 40 m.", "distance", 40),
    ],
)
def test_triggers(read, text, kind, value):
    (trigger,) = [p.trigger for p in read(text).objects[0].spec.phases if p.trigger]
    assert (trigger.kind, trigger.value) == (kind, value)


@pytest.mark.parametrize("text", ["A cyclist rides 15 m in front of me.", "Two joggers run 15 m ahead of ego."])
def test_who_goes_along_so_far_ahead_does_not_cross(read, text):
    spec = read(text).objects[0].spec
    assert [p.action for p in spec.phases] == ["move_along"] and spec.placement.gap == 15
