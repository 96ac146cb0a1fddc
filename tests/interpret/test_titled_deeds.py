"""Notes that open with what happens, and only then name who is there."""

import pytest


@pytest.mark.parametrize(
    "text", ["Cut-in. A car cuts in ahead of ego from the left.", "Cut-ins are frequent. Ego drives behind a bus."]
)
def test_what_is_told_again_or_of_nobody(read, text: str) -> None:
    s = read(text)
    assert len(s.objects) == 1 and sum(p.action == "cut_in" for p in s.objects[0].spec.phases) == ("A car" in text)


@pytest.mark.parametrize(
    "text",
    [
        "A car leads, ego follows at 60 km/h. A pickup behind ego overtakes both.",
        "Ego drives behind a tractor. A motorbike behind ego overtakes both of them.",
        "Ego drives behind a tractor. A motorbike comes from behind and passes them both.",
    ],
)
def test_who_overtakes_ego_and_the_one_ahead(read, text: str) -> None:
    s = read(text)
    passes = s.objects[1].spec.phases
    assert [(p.action, p.target) for p in passes] == [("overtake", "ego"), ("overtake", "O1")]
