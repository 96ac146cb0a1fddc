"""The paper's generation: interpreter, header, then the components one by one, each with the code so far (Algorithm 1).

Beyond the paper, and only where asked for: every fragment is checked as soon as it is written, and repaired.
"""

from collections.abc import Callable
from typing import Any

from c2s_engine.interpret.llm import fallback
from c2s_engine.interpret.llm.asking import FATAL, Asker
from c2s_engine.interpret.llm.components import Sentences, link, read_components
from c2s_engine.interpret.llm.settings import detect
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import AnswerTruncated, AnswerUnusable, ModelError
from c2s_engine.models.messages import Message, Question
from c2s_engine.retrieve.terms import terms_of
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import references
from c2s_engine.structure.objects import distinct_names
from c2s_engine.structure.progress import ComponentState, Passage, Progress, Say
from c2s_engine.structure.regenerate import code_references, dirty, key_of, order
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write import by_hand
from c2s_engine.write.by_hand import used
from c2s_engine.write.prompted import header
from c2s_engine.write.prompted.checking import Check, Fix, Verdict, with_code
from c2s_engine.write.prompted.configuration import configuration, default
from c2s_engine.write.prompted.fitting import fitted
from c2s_engine.write.prompted.header import Ground, settings_text
from c2s_engine.write.prompted.influence import rests_on, sources
from c2s_engine.write.prompted.parsing import code_of
from c2s_engine.write.prompted.prompt import code_so_far, generator_question
from c2s_engine.write.prompted.repair import Repairer, Search
from c2s_engine.write.prompted.texts import fill

OnEvent = Callable[[Progress], None]
USUAL_END = "terminate after 20 seconds"
WIDER = 4
"""How many times as many snippets are looked at as are shown: not all fit the names of the code so far."""
LONGEST_QUERY = 400


class Keys:
    """The method as the regeneration sees it (structure.regenerate): whose names a fragment uses, when it is stale.

    A fragment is up to date while its sentence, its fields, the method, and what the components whose names it uses
    define are what they were at the end of the writing that it comes from. So nothing is stale when writing has ended,
    but what the model failed to write.
    """

    def __init__(self, name: str, model: str, ground: Ground) -> None:
        self.name, self.model, self.ground = name, model, ground

    def config(self) -> dict[str, Any]:
        ground = [self.ground.map_file, self.ground.carla_map]
        return {"writer": self.name, "version": 1, "model": self.model, "reads_descriptions": True, "ground": ground}

    def inputs(self, structure: Structure, cid: ComponentId) -> Any:
        """The header rests on the settings as the HeaderGenerator is told them; the rest is in words and names."""
        return settings_text(structure, self.ground) if cid == "G" else []

    def reads(self, structure: Structure, cid: ComponentId) -> frozenset[ComponentId]:
        """A component's dependents are those whose code uses its names."""
        return code_references(structure, cid)

    def write(self, structure: Structure, cid: ComponentId) -> Component:
        """A model's fragments are written by PromptedMethod.write, which can be waited for and cancelled."""
        raise TypeError(f"{cid} is written by a model: use PromptedMethod.write")


class PromptedMethod:
    """Generator_R, _E, _O, _T and the HeaderGenerator under one of the twelve configurations.

    `checker` and `fix` are used for repair only; without a checker nothing is checked and nothing repaired. The map
    that headers name is `ground`.
    """

    def __init__(
        self,
        config_id: str | None,
        client: OllamaClient,
        retriever: Search | None = None,
        checker: Check | None = None,
        *,
        reader: Any = None,
        fix: Fix | None = None,
        ground: Ground | None = None,
    ) -> None:
        self.configuration = configuration(config_id or default())
        self.client = client
        self.search = retriever
        self.reader = reader
        self.ground = ground or Ground()
        self.name = f"chat2scenic:{self.configuration.name}"
        self.verdicts: dict[ComponentId, Verdict] = {}
        self.repairer: Repairer | None = None
        self._on_event: OnEvent | None = None
        if checker is not None:
            self.name += "+repair"
            self.repairer = Repairer(self._ask, checker, fix, retriever, self.configuration)
        self.keys = Keys(self.name, client.settings.model, self.ground)

    # The method

    async def generate(
        self, text: str, structure: Structure | None = None, on_event: OnEvent | None = None
    ) -> Structure:
        """S with its code, for a text or for an S that was read before; raises ModelError where no model answers."""
        if structure is None:
            structure = await self.interpret(text, on_event)
        return await self.write(structure, on_event)

    async def interpret(self, text: str, on_event: OnEvent | None = None) -> Structure:
        """The Interpreter and the SettingsDetector; specs are the learned reader's, for panes and edits."""
        asker = Asker(self.client, on_event)
        sentences = await read_components(text, asker)
        detected = await detect(text, asker)
        structure = _structure(text, sentences, self.reader)
        settings = structure.settings.model_copy(
            update={"spec": detected.spec, "assumed": detected.assumed, "unmet": detected.unmet}
        )
        structure = structure.with_component(settings)
        if detected.ego_model:
            spec = structure.ego.spec.model_copy(update={"model": detected.ego_model})
            structure = structure.with_component(structure.ego.model_copy(update={"spec": spec}))
        return structure

    async def write(self, structure: Structure, on_event: OnEvent | None = None) -> Structure:
        """Every component that is out of date, in Algorithm 1's order; the given S stays as it was.

        A component is written a second time where a name that it uses is gone since. What the model fails to write
        keeps its code of before, and stays to be written.
        """
        self._on_event = on_event
        written: dict[ComponentId, dict[str, str]] = {}
        again: set[ComponentId] = set()
        failed: set[ComponentId] = set()
        for component in structure.components:
            if component.key == by_hand.TAKEN:
                written[component.id] = used(structure, component.id)
        while cid := self._next(structure, written, again):
            before = structure[cid]
            structure = await self.write_component(structure, cid, on_event)
            if not structure[cid].code:
                failed.add(cid)
                structure = structure.with_component(before.model_copy(update={"key": ""}))
                if before.code:
                    self._emit(
                        Say(text=f"{cid} keeps its code of before, and stays to be written.", severity="warning")
                    )
            again |= {cid} & written.keys()
            written[cid] = used(structure, cid)
        for cid in written.keys() - failed:
            settled = structure[cid].model_copy(update={"key": key_of(structure, cid, self.keys)})
            structure = structure.with_component(settled)
        return await self._with_offers(structure)

    def _next(
        self, structure: Structure, written: dict[ComponentId, dict[str, str]], again: set[ComponentId]
    ) -> ComponentId | None:
        """What is to be written next. `written`: what was, with the names of others that it used; `again`: twice."""
        lost = {c for c, was in written.items() if c not in again and not was.items() <= used(structure, c).items()}
        stale = order(structure, dirty(structure, self.keys), self.keys)
        return next((c for c in stale if c not in written or c in lost), None)

    async def _with_offers(self, structure: Structure) -> Structure:
        """Code by hand stays; where what it rests on changed, what the model would write is offered beside it."""
        structure = by_hand.with_marks(structure)
        for cid in by_hand.outdated(structure, words=True):
            offered = (await self.write_component(structure, cid, self._on_event))[cid]
            self._emit(ComponentState(component=structure[cid], state="by_hand"))
            if offered.code:
                structure = by_hand.with_offer(structure, cid, offered.code)
        return structure

    async def write_component(
        self, structure: Structure, cid: ComponentId, on_event: OnEvent | None = None
    ) -> Structure:
        """One component, with what stands before it as its context."""
        self._on_event = on_event
        self._emit(ComponentState(component=structure[cid], state="writing"))
        passages: tuple[list[Passage], list[Passage]] = ([], [])
        plain = self._unasked(structure, cid)
        if not plain:
            passages = await self._retrieved(structure, cid)
        code = plain or await self._asked(structure, cid, passages)
        if code and self.repairer:
            found = await self.repairer.settle(structure, cid, code)
            self.verdicts[cid] = found
            code = found.code
            if found.diagnostic:
                self._emit(Say(text=f"{cid} does not pass: {found.diagnostic.message}", severity="warning"))
        component = with_code(structure[cid], code) if code else structure[cid].model_copy(update={"code": ""})
        if plain:
            component = component.model_copy(update={"origin": "rendered"})
        structure = structure.with_component(component)
        shown = [p for found in passages for p in found]
        if self.repairer:
            shown += self.repairer.shown.get(cid, [])
        update = {
            "key": key_of(structure, cid, self.keys),
            "links": rests_on(component, sources(shown, component.code)),
            "assumed": tuple(a for a in component.assumed if a.field != "*"),
        }
        component = component.model_copy(update=update)
        failed = bool(self.repairer and not self.verdicts.get(cid, Verdict("", 0)).ok) or not code
        self._emit(ComponentState(component=component, state="failed" if failed else "clean"))
        return structure.with_component(component)

    def _unasked(self, structure: Structure, cid: ComponentId) -> str:
        """The code of a component of which nothing is said: the default header, the usual end. Else empty."""
        if cid == "G" and header.is_default_header(structure):
            return header.plain(structure, self.ground)
        return USUAL_END if cid == "T" and not structure[cid].description else ""

    async def _asked(
        self, structure: Structure, cid: ComponentId, passages: tuple[list[Passage], list[Passage]]
    ) -> str:
        """A component's code by the model; empty where it has none. Raises fatal ModelErrors."""
        asked = generator_question(
            structure, cid, self.configuration, *passages,
            settings=settings_text(structure, self.ground) if cid == "G" else "",
        )  # fmt: skip
        try:
            return await self._code(asked, structure, cid)
        except FATAL:
            raise
        except ModelError as error:
            self._emit(Say(text=f"{cid}: {error}", severity="warning"))
            self._emit(ComponentState(component=structure[cid], state="failed"))
            return ""

    async def _retrieved(self, structure: Structure, cid: ComponentId) -> tuple[list[Passage], list[Passage]]:
        """CodeICL and DocICL: what the configuration asks for, by the component's sentence; snippets also by what it is
        and does as read by the learned reader (without one, by the sentence alone)."""
        config, query = self.configuration, structure[cid].description
        if cid == "R" and not query:  # the others tell what the place must have
            told = (c.description for c in (structure.ego, *structure.objects))
            query = " ".join(filter(None, told))[:LONGEST_QUERY]
        if self.search is None or not query or cid == "G":
            return [], []
        snippets, chunks = [], []
        try:
            if config.has("CodeICL"):
                about = terms_of(structure, cid) if self.reader is not None else ()
                limit = WIDER * config.snippets
                found = await self.search(query, kind="snippet", component=cid[0], limit=limit, terms=about)
                snippets = fitted(found, code_so_far(structure, cid))[: config.snippets]
            if config.has("DocICL"):
                chunks = await self.search(query, kind="doc", component=None, limit=config.chunks)
        except Exception as error:  # whatever retrieval says: the component is written without it, and that is told
            self._emit(Say(text=f"{cid} is written without retrieved passages. {error}", severity="warning"))
        for passage in (*snippets, *chunks):
            self._emit(passage)
        return snippets, chunks

    async def _code(self, asked: Question, structure: Structure, cid: ComponentId) -> str:
        before = code_so_far(structure, cid)
        try:
            return code_of(await self._ask(asked), cid[0], before)
        except (AnswerUnusable, AnswerTruncated):
            more = (*asked.messages, Message(role="user", content=fill("empty")))
            again = asked.model_copy(update={"messages": more, "purpose": f"{asked.purpose} again"})
            return code_of(await self._ask(again), cid[0], before)

    async def _ask(self, asked: Question) -> str:
        return (await self.client.chat(asked, self._on_event)).text

    def _emit(self, event: Progress) -> None:
        if self._on_event:
            self._on_event(event)


def _structure(text: str, sentences: Sentences, reader: Any) -> Structure:
    """S of sentences; the specs are those of the learned reader, where one is given."""
    stand_in = fallback.StandIn(reader, text) if reader is not None else None
    empty = Structure(text=text)

    def component(cid: str) -> Component:
        if stand_in is not None:
            spec = stand_in.spec(cid, sentences)
        elif cid.startswith("O"):
            spec = ObjectSpec.model_validate({"type": sentences.objects[int(cid[1:]) - 1].type})
        else:
            spec = empty[cid].spec
        sentence = sentences.of(cid)
        return Component(id=cid, description=sentence, spec=spec, links=link(text, sentence) if sentence else ())

    made = {cid: component(cid) for cid in sentences.ids}
    structure = Structure(
        text=text, settings=made["G"], place=made["R"], ego=made["E"], restrictions=made["T"],
        objects=tuple(made[c] for c in sentences.ids if c.startswith("O")),
    )  # fmt: skip
    return _in_order(distinct_names(structure))


def _in_order(structure: Structure) -> Structure:
    """The objects so that each follows those that it reacts to, as far as they do not react to each other."""
    left = list(structure.objects)
    done: list[Component] = []
    while left:
        known = {"ego", "E", *(o.id for o in done)}
        free = next((o for o in left if references(o) <= known | {o.id}), left[0])
        left.remove(free)
        done.append(free)
    return structure.model_copy(update={"objects": tuple(done)})


__all__ = ["PromptedMethod"]
