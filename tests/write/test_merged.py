"""Code by hand and code for other fields, merged upon what both came from."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from c2s_engine.write.merged import alike, merged, without_numbers

BASE = """## O1: A car ahead, at 50 km/h.
CAR_SPEED = 13.89  # m/s
CAR_AT = EGO_AT + 13.33 + 5  # m along the lane

behavior CarBehavior():
    line = route(place.lane)
    do Drive(line, CAR_SPEED) for 3 seconds

car = new Car at place.lane.centerline.pointAlongBy(CAR_AT),
    with blueprint Uniform(*CARS),
    with behavior CarBehavior()
"""
OTHER = (
    BASE.replace("car", "bus").replace("Car", "Bus").replace("CAR", "BUS").replace("(*BUSS)", "(*BUSES)")
    .replace("13.89", "12.5").replace("50 km/h", "45 km/h")
    .replace("bus,", "bus,\n    with regionContainedIn everywhere,")
)  # fmt: skip
LINES = BASE.rstrip("\n").split("\n")


@given(st.lists(st.tuples(st.integers(1, len(LINES)), st.sampled_from(["# mine", "    # 漢字: ä", ""]))))
def test_comments_stay_and_nothing_else_is_kept_from_the_new(put):
    own = list(LINES)
    for at, line in sorted(put, reverse=True):
        own.insert(at, line)
    code = merged(BASE, "\n".join(own) + "\n", OTHER)
    assert code is not None and alike(code, OTHER)
    assert [line for line in code.split("\n") if line.lstrip().startswith("#") and "##" not in line] == [
        line for line in own if line.lstrip().startswith("#") and "##" not in line
    ]


@pytest.mark.parametrize(
    ("mine", "theirs", "becomes"),
    [
        (("13.33", "20"), ("13.89", "12.5"), (("13.33", "20"), ("13.89", "12.5"))),
        (("13.89", "13.890"), ("13.89", "12.5"), (("13.89", "12.5"),)),
        (("for 3 seconds", "for 4 seconds"), (" for 3 seconds", ""), None),
        (("13.89", "15"), ("13.89", "12.5"), None),
        (("## O1: A car ahead, at 50 km/h.", "## O1: mine"), ("13.89", "12.5"),
         (("## O1: A car ahead, at 50 km/h.", "## O1: mine"), ("13.89", "12.5"))),
        (("behavior CarBehavior():", "behavior Mine():"), ("behavior CarBehavior():", "behavior Theirs():"), None),
    ],
)  # fmt: skip
def test_what_both_changed_is_not_merged(mine, theirs, becomes):
    wanted = BASE
    for swap in becomes or ():
        wanted = wanted.replace(*swap)
    assert merged(BASE, BASE.replace(*mine), BASE.replace(*theirs)) == (wanted if becomes else None)


def test_numbers_are_put_back_where_a_line_has_no_other_change():
    own = BASE.replace("13.89", "15").replace("behavior", "# mine\nbehavior").replace("for 3", "until 3")
    assert without_numbers(BASE, own) == own.replace("15", "13.89")


def test_a_sign_in_a_string_is_no_comment():
    assert alike("a = 'x # y'  # z\n\nb = 1.0", "a = 'x # y'\nb = 1") and not alike("a = 'x # y'", "a = 'x # z'")
