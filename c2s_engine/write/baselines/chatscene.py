"""Retrieve and assemble (after ChatScene): one adversary is described, the nearest snippets are taken as they are.

One call extracts adversary, behaviour, geometry and position (without a model: the learned reader's sentences). The
nearest place, ego and adversary of the snippet store are concatenated, unchanged; what does not fit together fails.
"""

from collections.abc import Callable
from typing import Any

from pydantic import BaseModel, ConfigDict

from c2s_engine.interpret.llm import fallback
from c2s_engine.interpret.llm.asking import Asker
from c2s_engine.models.client import OllamaClient
from c2s_engine.structure.components import Component, Link, Structure
from c2s_engine.structure.progress import Progress
from c2s_engine.structure.regenerate import digest
from c2s_engine.structure.specs import SPEC_OF, ObjectSpec
from c2s_engine.write import by_hand
from c2s_engine.write.prompted.checking import with_code
from c2s_engine.write.prompted.header import Ground
from c2s_engine.write.prompted.repair import Search
from c2s_engine.write.prompted.texts import fill

EGO = "Ego keeps its lane at a constant speed."


class Extract(BaseModel):
    """What the one call gives."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    adversary: str
    behavior: str
    geometry: str
    position: str

    @property
    def object(self) -> str:
        """The adversary as one sentence, to be looked up."""
        return " ".join(f"{s.rstrip('.')}." for s in (self.adversary, self.behavior, self.position) if s)


class ChatScene:
    """The method; `client` may be None."""

    name = "chatscene"

    def __init__(
        self, client: OllamaClient | None, retriever: Search, reader: Any, ground: Ground | None = None
    ) -> None:
        self.client, self.search, self.reader, self.ground = client, retriever, reader, ground or Ground()

    async def interpret(self, text: str, on_event: Callable[[Progress], None] | None = None) -> Structure:
        """S with the sentences that are looked up; raises ModelError, or the learned reader's refusal."""
        if self.client is None:
            return _one_adversary(self.reader(text).structure)
        schema = {
            "type": "object",
            "properties": {n: {"type": "string", "maxLength": 300} for n in Extract.model_fields},
            "required": list(Extract.model_fields),
            "additionalProperties": False,
        }
        found = await Asker(self.client, on_event).form(
            fill("chatscene"), text, schema, purpose="extract", build=Extract.model_validate
        )
        stand_in = fallback.StandIn(self.reader, text).structure
        spec = stand_in.objects[0].spec if stand_in.objects else ObjectSpec()
        structure = Structure(text=text, settings=stand_in.settings, objects=(Component(id="O1", spec=spec),))
        sentences = {"R": found.geometry, "E": EGO, "O1": found.object}
        for cid, sentence in sentences.items():
            structure = structure.with_component(structure[cid].model_copy(update={"description": sentence}))
        return structure

    async def write(self, structure: Structure, on_event: Callable[[Progress], None] | None = None) -> Structure:
        """The nearest snippet of each component, under a plain header; code by hand stays, and where it is said in
        other words than those it was written upon, the snippet is offered beside it."""
        given = by_hand.with_marks(structure)
        header = (
            f"param map = localPath('{self.ground.map_file}')\nparam carla_map = {self.ground.carla_map!r}\n"
            "param use2DMap = True\nparam timestep = 0.1\nparam weather = 'ClearNoon'\n"
            "model scenic.simulators.carla.model"
        )
        structure = structure.with_component(with_code(structure.settings, header))
        queries = [("R", structure.place.description or "A straight lane."), ("E", EGO)]
        queries += [(o.id, o.description) for o in structure.objects[:1]]
        for cid, query in queries:
            found = await self.search(query, kind="snippet", component=cid[0], limit=1)
            if not found:
                continue
            if on_event:
                on_event(found[0])
            component = with_code(structure[cid], found[0].text)
            links = (*component.links, Link(kind="snippet", label=found[0].title))
            structure = structure.with_component(component.model_copy(update={"links": links}))
        outdated = by_hand.outdated(given, words=True)
        for component in structure.components:
            kept = given[component.id]
            if kept.origin not in by_hand.OWN:
                kept = component.model_copy(update={"key": digest(component.code)})
            structure = structure.with_component(kept)
            if component.id in outdated:
                structure = by_hand.with_offer(structure, component.id, component.code)
        return structure


def _one_adversary(structure: Structure) -> Structure:
    """Only the first object that moves (else the first): the method knows one adversary."""
    objects = structure.objects
    chosen = next((o for o in objects if getattr(o.spec, "phases", ())), objects[0] if objects else None)
    kept: tuple[Component, ...] = ()
    if chosen is not None:
        spec = fallback.without_references(chosen.spec)
        kept = (chosen.model_copy(update={"id": "O1", "spec": spec}),)
    blank = {"E": SPEC_OF["E"](), "T": SPEC_OF["T"]()}
    structure = structure.model_copy(update={"objects": kept})
    for cid, spec in blank.items():
        structure = structure.with_component(structure[cid].model_copy(update={"spec": spec}))
    return structure
