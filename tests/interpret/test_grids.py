"""Tables with a row for each road user."""


def test_other_lists_stay_as_they_are(read) -> None:
    s = read("A bus, a van, and a car wait at the lights.\nThe bus, slow, and late, turns left ahead of ego.")
    assert {c.spec.type for c in s.objects} == {"bus", "van", "car"}
