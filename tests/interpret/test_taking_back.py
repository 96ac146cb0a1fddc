"""However somebody says it: the last change is taken back or done again, and what only sounds like it is not."""

import pytest

from c2s_engine.interpret.turn import route

SCENE = "Ego follows a bus at 40 km/h in the rain. A woman crosses from the right and a scooter follows ego."


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("undo", "undo"),
        ("Hmm, that's worse. Take it back please.", "undo"),
        ("could you revert the last edit", "undo"),
        ("back to how it was before", "undo"),
        ("leave it the way it was", "undo"),
        ("sorry, that was a mistake, roll back", "undo"),
        ("I changed my mind", "undo"),
        ("redo", "redo"),
        ("ok, apply it again", "redo"),
        ("undo the undo", "redo"),
        ("put the change back in", "redo"),
        ("no, repeat what you took back", "redo"),
    ],
)
def test_the_last_change(read, text: str, kind: str) -> None:
    assert route(text, read(SCENE)).kind == kind


@pytest.mark.parametrize(
    "text",
    [
        "the bus goes back to the right lane",
        "put the woman back by 5 m",
        "reverse the direction of the bus",
        "cancel the rain",
        "forget the scooter",
        "go back to dry weather",
    ],
)
def test_what_only_sounds_like_it(read, text: str) -> None:
    assert route(text, read(SCENE)).kind not in ("undo", "redo")


@pytest.mark.parametrize(
    "text",
    [
        "ok drop this whole thing, next one: ego follows a van that brakes.",
        "Forget all that. New scenario: ego follows a van that brakes.",
        "Scrap this, a new one: ego follows a van that brakes.",
    ],
)
def test_what_only_begins_anew_is_no_part_of_the_scene(read, text: str) -> None:
    s = read(text)
    assert [o.spec.type for o in s.objects] == ["van"]
    assert not [u for c in s.components for u in c.unmet]
