"""Random edits of a session whose fragments a model writes, on recorded answers: what is written step by step equals
writing all anew, and nothing is asked for that the read-relation does not require.
"""

import asyncio
import hashlib
import re
import shutil
import tempfile
from pathlib import Path

import pytest
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule
from session_fake import run_machine

from c2s_engine.models import ModelSettings, OllamaClient
from c2s_engine.session.sessions import Sessions
from c2s_engine.structure import edits as e
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.regenerate import dirty
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write import by_hand
from c2s_engine.write.prompted.method import PromptedMethod
from tests.models.fake_ollama import FakeOllama, said

NAMES = ("lead", "other", "walker", "bus")
SENTENCES = st.builds(
    "A car called {} stands {} metres from {}.".format,
    st.sampled_from(NAMES), st.sampled_from([5, 20]), st.sampled_from(("ego", *NAMES)),
)  # fmt: skip
MORE = st.sampled_from(["It is said in other words.", "It rains.", "The road is wide.", "Near lead it ends."])


def recorded(request):
    """The recorded answer: the same component under the same sentence is always written the same."""
    asked = f"{said(request)}\nNow write component G: it"
    cid, sentence = re.search(r"Now write component (\w+): ?(.*)", asked).groups()
    names = re.search(r"called (\w+) stands (\d+) metres from (\w+)", sentence)
    number = int(hashlib.sha256(sentence.encode()).hexdigest()[:4], 16)
    near = "lead" if "lead" in sentence else "ego"
    code = {
        "G": "param map = localPath('town.xodr')\nmodel scenic.simulators.carla.model",
        "R": f"spot_{number} = new OrientedPoint on road",
        "E": f"ego = new Car with tag {number}",
        "T": f"require (distance from ego to {near}) < {number}",
    }.get(cid)
    if code is None and names:
        code = f"{names[1]} = new Car ahead of {names[3]} by {names[2]}, with tag '{cid}'"
    return f"```scenic\n{code or f'thing = new Car with tag {number}'}\n```"


class ModelEngine:
    """The facade's `apply` with a method that asks a model."""

    def __init__(self, server):
        client = OllamaClient(ModelSettings(model="small", host=server.host, backoff=0.001, probe=False))
        self.method = PromptedMethod("C1", client)

    async def apply(self, structure, edits, **_):
        for edit in edits:
            structure = e.apply(structure, edit)
        structure = await self.method.write(structure)
        yield Finished(ok=True, structure=structure, program=assemble(structure))


class Describing(RuleBasedStateMachine):
    """A session under a scripted server."""

    def __init__(self):
        super().__init__()
        self.server = FakeOllama(recorded).__enter__()
        self.folder = Path(tempfile.mkdtemp())
        self.loop = asyncio.new_event_loop()
        self.engine = ModelEngine(self.server)
        self.sessions = Sessions(self.folder)
        self.session = self.sessions.open("one", self.engine)
        self.past, self.future = [self.session.program.text], []

    def teardown(self):
        self.session.close()
        self.sessions.close()
        self.loop.run_until_complete(self.engine.method.client.close())
        self.loop.close()
        self.server.__exit__()
        shutil.rmtree(self.folder)

    def take(self, events):
        async def collect():
            return [event async for event in events]

        return self.loop.run_until_complete(collect())

    def edit(self, edit):
        keys, first = self.engine.method.keys, len(self.server.requests)
        changed = e.apply(self.session.structure, edit)
        touched = {*dirty(changed, keys), *by_hand.outdated(changed, words=True)}
        before = self.session.structure
        self.take(self.session.apply(edit))
        after = self.session.structure
        asked = [re.search(r"Now write component (\w+):", said(r)) for r in self.server.requests[first:]]
        written = [a[1] if a else "G" for a in asked]
        assert len(written) == len(set(written)), written
        for cid in written:
            read = {*keys.reads(after, cid), *(keys.reads(before, cid) if cid in before else ())}
            assert cid in touched or read & {*written, *touched, edit_component(edit)}, (edit, cid, written)
        if self.session.structure != before:
            self.past.append(self.session.program.text)
            self.future = []

    @rule(sentence=SENTENCES)
    @precondition(lambda self: len(self.session.structure.objects) < 4)
    def add(self, sentence):
        self.edit(e.AddObject(spec=ObjectSpec(), description=sentence))

    @rule(data=st.data())
    def describe(self, data):
        cid = data.draw(st.sampled_from(self.session.structure.ids))
        words = data.draw(SENTENCES if cid.startswith("O") else MORE)
        self.edit(e.SetDescription(component=cid, description=words))

    @rule(data=st.data())
    @precondition(lambda self: self.session.structure.objects)
    def remove(self, data):
        self.edit(e.RemoveObject(component=data.draw(st.sampled_from([o.id for o in self.session.structure.objects]))))

    @rule(data=st.data())
    @precondition(lambda self: self.session.program.text)
    def by_hand(self, data):
        component = data.draw(st.sampled_from(self.session.structure.components))
        code = None if component.origin == "by_hand" else component.code.replace("lead", "first") + "# by hand\n"
        self.edit(e.SetCode(component=component.id, code=code))

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

    @invariant()
    def stands_where_it_should(self):
        assert self.session.program.text == self.past[-1]

    @invariant()
    def nothing_is_stale(self):
        structure, keys = self.session.structure, self.engine.method.keys
        if self.session.program.text:
            assert dirty(structure, keys) == [] and by_hand.outdated(structure, words=True) == []

    @invariant()
    def equals_writing_all_anew(self):
        structure = self.session.structure
        if not self.session.program.text:
            return
        for component in structure.components:
            if component.origin == "generated":
                structure = structure.with_component(component.model_copy(update={"key": "", "code": ""}))
        fresh = self.loop.run_until_complete(self.engine.method.write(structure))
        assert assemble(fresh).text == self.session.program.text


def edit_component(edit):
    return getattr(edit, "component", None)


def test_step_by_step_equals_all_anew_with_a_model():
    run_machine(Describing, 3, 6)


@pytest.mark.nightly
def test_step_by_step_equals_all_anew_with_a_model_at_length():
    run_machine(Describing, 40, 15)
