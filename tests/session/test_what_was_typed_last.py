"""A turn is read beside what was typed last, so that it can correct that."""

import pytest
from session_fake import FakeEngine

from c2s_engine.session.sessions import Sessions


class Listening(FakeEngine):
    def __init__(self):
        super().__init__()
        self.heard = []

    async def say(self, structure, text, *, last=None, **options):
        self.heard.append((text, last and (last[0], [o.description for o in last[1].objects])))
        async for event in super().say(structure, text, **options):
            yield event


@pytest.fixture
def sessions(tmp_path):
    made = Sessions(tmp_path / "sessions")
    yield made
    made.close()


async def take(events):
    return [event async for event in events]


async def test_the_turn_before_and_the_scene_before_it(sessions) -> None:
    engine = Listening()
    session = sessions.open("one", engine)
    for text in ("car", "bus", "no, the other one"):
        await take(session.say(text))
    assert engine.heard == [("car", None), ("bus", ("car", [])), ("no, the other one", ("bus", ["car"]))]


async def test_not_of_what_was_taken_back(sessions) -> None:
    engine = Listening()
    session = sessions.open("one", engine)
    for text in ("car", "bus"):
        await take(session.say(text))
    await take(session.undo())
    await take(session.say("van"))
    assert engine.heard[-1] == ("van", ("car", []))


async def test_a_long_turn_corrects_nothing(sessions) -> None:
    engine = Listening()
    session = sessions.open("one", engine)
    await take(session.say("car"))
    await take(session.say(" ".join(["a long text of many words"] * 3)))
    assert engine.heard[-1][1] is None
