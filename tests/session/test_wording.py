"""Reading in a process apart, and what new sentences of components mean for their fields."""

import asyncio
import os
import signal
from types import SimpleNamespace

import pytest

from c2s_engine.session.reader import Reader, Unreadable, route
from c2s_engine.session.reader import read as asked
from c2s_engine.session.wording import reworded
from c2s_engine.structure.edits import SetDescription, SetField, apply

TEXT = "Ego drives at 50 km/h on a road with two lanes in the rain. A van in the left lane cuts in 15 m ahead."
IN_PROCESS = SimpleNamespace(extra={})


async def read(text, tools):
    """S of a text."""
    return (await asked(text, tools)).structure


async def said(structure, cid, sentence, tools=IN_PROCESS):
    """S after a sentence, and what was answered."""
    edits, replies = await reworded(structure, [SetDescription(component=cid, description=sentence)], tools)
    for edit in edits:
        structure = apply(structure, edit)
    return structure, replies[0]


@pytest.mark.parametrize(
    ("cid", "sentence", "field", "value", "told"),
    [
        ("O1", "A truck in the left lane cuts in 15 m ahead of ego.", "type", "truck", "the sentence was read; type"),
        ("E", "Ego drives at 72 km/h.", "speed", 20.0, "speed"),
        ("G", "It is night and it rains.", "time", "night", "time changed"),
        ("T", "The run ends after 30 s.", "duration", 30.0, "duration changed"),
    ],
)
async def test_a_new_sentence_changes_the_fields_of_its_component_only(cid, sentence, field, value, told):
    before = await read(TEXT, IN_PROCESS)
    after, reply = await said(before, cid, sentence)
    assert getattr(after[cid].spec, field) == value and told in reply
    assert after[cid].description == sentence
    assert [c for c in after.components if c.id != cid] == [c for c in before.components if c.id != cid]


async def test_a_field_edit_of_the_sentence_is_the_same():
    before = await read(TEXT, IN_PROCESS)
    edit = SetField(component="E", path="description", value="Ego drives at 72 km/h.")
    edits, _ = await reworded(before, [edit], IN_PROCESS)
    assert edits[1:] == [SetField(component="E", path="speed", value=20.0)]


async def test_what_the_words_leave_as_it_was_is_left():
    structure = await read(TEXT, IN_PROCESS)
    edited = structure.objects[0].model_copy(
        update={"spec": structure.objects[0].spec.model_copy(update={"count": 3, "name": "mine"})}
    )
    structure = structure.with_component(edited)
    after, _ = await said(structure, "O1", structure["O1"].description.replace("15 m", "25 m"))
    assert (after["O1"].spec.count, after["O1"].spec.name, after["O1"].spec.placement.gap) == (3, "mine", 25.0)
    after, reply = await said(structure, "O1", "Lorem ipsum dolor.")
    assert after["O1"].spec == structure["O1"].spec and "fields are unchanged" in reply


@pytest.mark.parametrize(
    ("cid", "more", "lost"),
    [
        ("O1", ", then runs back", "runs back"),
        ("O1", " with a smile", "with a smile"),
        ("E", " and listens to the radio", "listens to the radio"),
        ("O1", " after 3 s", ""),
    ],
)
async def test_new_words_that_are_in_no_field_are_kept_and_marked(cid, more, lost):
    before = await read(TEXT, IN_PROCESS)
    old = before[cid].description.rstrip(".")
    after, reply = await said(before, cid, f"{old}{more}.")
    assert after[cid].description == f"{old}{more}."
    assert [u.text for u in after[cid].unmet] == [lost] * bool(lost)
    assert ("is not in S" in reply) is bool(lost)
    again, _ = await said(after, cid, f"{old.replace('50', '60')}.")
    assert not again[cid].unmet, "what is no longer said is no longer marked"


@pytest.mark.full
@pytest.mark.model
async def test_the_process_apart_reads_the_same_and_a_killed_one_is_replaced():
    reader = Reader()
    apart = SimpleNamespace(extra={"reader": reader})
    try:
        here, there = await asyncio.gather(read(TEXT, IN_PROCESS), read(TEXT, apart))
        assert here == there
        asked = await route("make the van a truck", there, apart)
        assert asked.kind == "edit" and asked == await route("make the van a truck", there, IN_PROCESS)
        with pytest.raises(Unreadable, match="driving scenario"):
            await read("Lorem ipsum.", apart)
        waiting = asyncio.ensure_future(read(TEXT, apart))
        while not reader._waiting:
            await asyncio.sleep(0.001)
        os.kill(reader._process.pid, signal.SIGKILL)
        with pytest.raises(Unreadable, match="send it again"):
            await waiting
        await reader._process.wait()
        waiting = asyncio.ensure_future(read(TEXT, apart))  # cancelled: its answer must not reach the next
        await asyncio.sleep(0)
        waiting.cancel()
        assert await read(TEXT, apart) == here
    finally:
        await reader.close()
