"""What must be kept to all along is a limit of T: nobody does anything by it, and its value goes nowhere else."""

import pytest

from c2s_engine.structure.account import account

FOLLOWS = "Ego follows a truck at 50 km/h. The truck brakes. "


@pytest.mark.parametrize(
    ("text", "limits"),
    [
        (FOLLOWS + "Ego must brake with no more than 6 m/s2 and shall not collide.",
         [("deceleration", "ego", None, None, 6.0), ("collision", "ego", None, None, None)]),
        (FOLLOWS + "Ego's deceleration must not exceed 5 m/s2.", [("deceleration", "ego", None, None, 5.0)]),
        (FOLLOWS + "Ego must keep at least 20 m distance.", [("gap", "ego", None, 20.0, None)]),
        (FOLLOWS + "Ego's speed shall not exceed 54 km/h.", [("speed", "ego", None, None, 15.0)]),
        (FOLLOWS + "Ego must stop without a collision.", [("collision", "ego", None, None, None)]),
        ("Ego drives at 50 km/h. The car ahead brakes with at most 4 m/s2.", [("deceleration", "O1", None, None, 4.0)]),
    ],
)  # fmt: skip
def test_limits(read, text: str, limits: list[tuple]) -> None:
    s = read(text)
    found = [(li.kind, li.subject, li.other, li.minimum, li.maximum) for li in s.restrictions.spec.limits]
    assert found == limits
    assert all(p.rate is None or p.rate != limits[0][-1] for c in (s.ego, *s.objects) for p in c.spec.phases)
    last = account(s)[-1]
    assert last.status == "understood" and f"T.limits.{len(limits) - 1}" in last.fields


@pytest.mark.parametrize(
    "text",
    ["Ego drives at 50 km/h. A truck ahead brakes with 6 m/s2.",
     "Ego drives at at most 50 km/h behind a truck.",
     "A car 20 m ahead of ego collides with a van. Ego does not brake."],
)  # fmt: skip
def test_what_is_told_to_happen_is_no_limit(read, text: str) -> None:
    assert read(text).restrictions.spec.limits == ()
