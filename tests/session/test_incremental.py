"""Random sequences of edits, undos, redos and reopenings: what is written step by step equals writing all anew."""

import asyncio
import shutil
import tempfile
from functools import cache
from pathlib import Path

import pytest
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule
from session_fake import run_machine

from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import map_choice
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure import edits as e
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished, ProgramChanged, Say
from c2s_engine.structure.regenerate import reach, regenerate
from c2s_engine.structure.specs import ObjectSpec, Phase, Placement, Trigger
from c2s_engine.write.typed import TypedWriter

TYPES = ("car", "truck", "pedestrian", "bicycle", "cone", "barrier")
NAMES = ("lead", "other", "walker", "box")
ACTIONS = ("brake", "stop", "cut_in", "lane_change", "cross_road", "accelerate", "stationary", "swerve")
FIELDS = (
    ("G", "weather", (["rain"], ["fog", "wet"], [])),
    ("G", "time", ("night", None)),
    ("R", "kind", ("road", "straight", "curve", "intersection", "motorway")),
    ("R", "manoeuvre", ("left", "straight", None)),
    ("R", "lanes", (1, 2, 3, None)),
    ("E", "speed", (8.0, 13.9, 27.0, None)),
    ("E", "reaction", ("brake", "follow", "none")),
    ("T", "duration", (10.0, 30.0, None)),
)
OBJECT_FIELDS = (
    ("speed", (0.0, 5.0, None)),
    ("placement.gap", (10.0, [15.0, 25.0], None)),
    ("count", (1, 2)),
    ("name", NAMES),
    ("type", TYPES),
)


@cache
def writer():
    library = MapLibrary()
    return TypedWriter(map_choice(library, library.find("town")))


class WriterEngine:
    """The facade's `apply` without a check server: edits, regeneration, assembly."""

    async def apply(self, structure, edits, **_):
        written = []
        try:
            structure, written = regenerate(structure, edits, writer())
        except ValueError as error:
            yield Say(text=str(error), severity="error")
        program = assemble(structure)
        yield ProgramChanged(program=program, rewritten=tuple(written))
        yield Finished(ok=True, structure=structure, program=program, details={"rewritten": written})


def anew(structure):
    """The same specs, with everything that is not by hand written from nothing."""
    for component in structure.components:
        if component.origin == "rendered":
            structure = structure.with_component(component.model_copy(update={"key": "", "code": ""}))
    return regenerate(structure, [], writer())[0]


def specs():
    def made(name, kind, position, of, gap, speed, phases):
        placement = Placement(position=position, of=of, gap=gap)
        return ObjectSpec(name=name, type=kind, placement=placement, speed=speed, phases=phases)

    triggers = st.none() | st.builds(
        Trigger, kind=st.sampled_from(["distance", "time"]), value=st.sampled_from([5, 20])
    )
    phase = st.builds(Phase, action=st.sampled_from(ACTIONS), trigger=triggers)
    return st.builds(
        made, st.sampled_from(NAMES), st.sampled_from(TYPES), st.sampled_from(v.Position.__args__),
        st.sampled_from(["ego", "O1"]), st.sampled_from([None, 12.0, (10.0, 20.0)]),
        st.sampled_from([None, 0.0, 10.0]), st.lists(phase, max_size=2).map(tuple),
    )  # fmt: skip


class Editing(RuleBasedStateMachine):
    """A session beside the plain list of what it went through."""

    def __init__(self):
        super().__init__()
        self.folder = Path(tempfile.mkdtemp())
        self.loop = asyncio.new_event_loop()
        self.sessions = Sessions(self.folder)
        self.session = self.sessions.open("one", WriterEngine())
        self.past, self.future = [self.whole()], []

    def teardown(self):
        self.session.close()
        self.sessions.close()
        self.loop.close()
        shutil.rmtree(self.folder)

    def whole(self):
        return self.session.structure.model_dump_json(), self.session.program.model_dump_json()

    def take(self, events):
        async def collect():
            return [event async for event in events]

        return self.loop.run_until_complete(collect())

    def edit(self, edit):
        before = self.session.structure
        try:
            allowed = set(reach(before, edit, writer()))
        except ValueError:
            allowed = set()
        try:
            events = self.take(self.session.apply(edit))
        finally:
            assert self.session.pending is None
        rewritten = events[-1].details["rewritten"]
        assert set(rewritten) <= allowed, (edit, rewritten, allowed)
        self.changed()

    def changed(self):
        """A turn was done: one that changed something can be undone, and is what is left of the future."""
        if self.whole() != self.past[-1]:
            self.past.append(self.whole())
            self.future = []

    @rule(spec=specs())
    @precondition(lambda self: len(self.session.structure.objects) < 4)
    def add(self, spec):
        self.edit(e.AddObject(spec=spec, description=f"a {spec.type}"))

    @rule(data=st.data())
    def set_field(self, data):
        component, path, values = data.draw(st.sampled_from(FIELDS))
        self.edit(e.SetField(component=component, path=path, value=data.draw(st.sampled_from(values))))

    @rule(data=st.data())
    @precondition(lambda self: self.session.structure.objects)
    def change_object(self, data):
        component = data.draw(st.sampled_from([o.id for o in self.session.structure.objects]))
        path, values = data.draw(st.sampled_from(OBJECT_FIELDS))
        self.edit(e.SetField(component=component, path=path, value=data.draw(st.sampled_from(values))))

    @rule(data=st.data(), index=st.integers(0, 3))
    @precondition(lambda self: self.session.structure.objects)
    def move_or_remove(self, data, index):
        component = data.draw(st.sampled_from([o.id for o in self.session.structure.objects]))
        remove = data.draw(st.booleans())
        self.edit(e.RemoveObject(component=component) if remove else e.MoveObject(component=component, index=index))

    @rule(data=st.data())
    def by_hand(self, data):
        component = data.draw(st.sampled_from(self.session.structure.components))
        code = None if component.origin == "by_hand" else component.code + "# by hand\n"
        self.edit(e.SetCode(component=component.id, code=code))

    @rule(data=st.data())
    def write_anew(self, data):
        chosen = data.draw(st.lists(st.sampled_from(self.session.structure.ids), unique=True))
        before = self.whole()
        self.take(self.session.regenerate(chosen))
        assert before == self.whole() or not before[1].count("##")
        self.changed()

    @rule()
    @precondition(lambda self: len(self.past) > 1)
    def undo(self):
        self.take(self.session.undo())
        self.future.append(self.past.pop())

    @rule()
    @precondition(lambda self: self.future)
    def redo(self):
        self.take(self.session.redo())
        self.past.append(self.future.pop())

    @rule()
    def reopen(self):
        self.session.close()
        self.session = self.sessions.open("one", WriterEngine())

    @invariant()
    def stands_where_it_should(self):
        assert self.whole() == self.past[-1]
        assert (self.session.can_undo, self.session.can_redo) == (len(self.past) > 1, bool(self.future))

    @invariant()
    def equals_writing_all_anew(self):
        if not self.session.program.text:
            return
        fresh = anew(self.session.structure)
        assert assemble(fresh).text == self.session.program.text
        assert [c.key for c in fresh.components] == [c.key for c in self.session.structure.components]


def test_step_by_step_equals_all_anew():
    run_machine(Editing, 6, 8)


@pytest.mark.full
def test_step_by_step_equals_all_anew_at_length():
    run_machine(Editing, 40, 20)


def test_the_weather_is_a_line_of_g_only():
    structure = e.apply(Structure(), e.AddObject(spec=ObjectSpec(name="lead")))
    structure = regenerate(structure, [], writer())[0]
    edit = e.SetField(component="G", path="weather", value=["rain"])
    after, written = regenerate(structure, [edit], writer())
    assert written == ["G"] and after.settings.code != structure.settings.code
