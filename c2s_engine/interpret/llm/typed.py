"""The typed way: the text into components, then each component's spec, every answer held to a JSON schema.

Where an answer cannot be used, the learned reader's answer for that component stands in: marked in `assumed`,
counted in `fallbacks`, said in `notes`. Whatever the model answers, the result is a valid S.
"""

from collections.abc import Callable
from typing import Any

from pydantic import BaseModel, ConfigDict

from c2s_engine.interpret.llm import fallback, rendered_sentences, words
from c2s_engine.interpret.llm.asking import Asker, OnEvent, prompt
from c2s_engine.interpret.llm.components import Sentences, excerpt, link, read_components
from c2s_engine.interpret.llm.forms import form_of
from c2s_engine.interpret.llm.offered import asks, pop_inapplicable_fields
from c2s_engine.interpret.llm.schema import spec_class
from c2s_engine.interpret.llm.settings import BLUEPRINT, Detected, detect
from c2s_engine.interpret.llm.units import annotate
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.structure.components import Assumption, Component, Structure, Unmet
from c2s_engine.structure.objects import distinct_names, in_order
from c2s_engine.structure.progress import Say
from c2s_engine.structure.specs import SPEC_OF, AnySpec, EgoSpec, SettingsSpec

_KINDS = {"G": "settings", "R": "place", "E": "ego", "T": "restrictions"}


class Reading(BaseModel):
    """What was understood with a model. `fallbacks`: component -> why the learned reader's answer stands there."""

    model_config = ConfigDict(frozen=True)

    structure: Structure
    fallbacks: dict[str, str] = {}
    notes: tuple[str, ...] = ()

    @property
    def share(self) -> float:
        """The share of components that the model itself filled in."""
        return 1 - len(self.fallbacks) / len(self.structure.components)


async def interpret(
    text: str,
    *,
    client: OllamaClient,
    reader: fallback.Reader,
    on_event: OnEvent | None = None,
) -> Reading:
    """S for a text; never raises ModelError (what went wrong is in `notes`).

    Where no answer of the model can be used and the learned reader refuses the text, its refusal is raised.
    """
    return await TypedReader(client, reader, on_event).read(text)


class TypedReader:
    """Reads one text."""

    def __init__(self, client: OllamaClient, reader: fallback.Reader, on_event: OnEvent | None = None) -> None:
        self.asker = Asker(client, on_event)
        self.reader = reader
        self.on_event = on_event

    async def read(self, text: str) -> Reading:
        """The whole text into S."""
        stand_in = fallback.StandIn(self.reader, text)
        try:
            sentences = await read_components(text, self.asker, strict=True)
        except ModelError as error:
            return self._all_stand_in(text, stand_in.strict(), str(error))
        structure = Structure(text=text)
        fallbacks: dict[str, str] = {}
        components: dict[str, Component] = {}
        try:
            detected = await self._settings(text, sentences)
        except ModelError as error:
            fallbacks["G"] = str(error)
            detected = Detected.model_validate({"spec": stand_in.structure.settings.spec})
        components["G"] = self._component(
            "G", sentences, text, detected.spec, detected.assumed, detected.unmet, fallbacks.get("G")
        )
        for cid in sentences.ids[1:]:
            try:
                spec, unmet = await self._spec(cid, text, sentences)
                components[cid] = self._component(cid, sentences, text, spec, (), unmet)
            except ModelError as error:
                fallbacks[cid] = str(error)
                spec = stand_in.spec(cid, sentences)
                components[cid] = self._component(cid, sentences, text, spec, (), (), str(error))
        ego = components["E"]
        if detected.ego_model and isinstance(ego.spec, EgoSpec) and not ego.spec.model:
            spec = ego.spec.model_copy(update={"model": detected.ego_model})
            components["E"] = ego.model_copy(update={"spec": spec})
        objects = tuple(components[c] for c in sentences.ids if c.startswith("O"))
        structure = Structure(
            text=text, settings=components["G"], place=components["R"], ego=components["E"], objects=objects,
            restrictions=components["T"],
        )  # fmt: skip
        structure = in_order(distinct_names(structure))
        said = {cid: sentences.of(cid) for cid in sentences.ids}
        return self._done(rendered_sentences.with_rendered_sentences(structure, said), fallbacks)

    def _done(self, structure: Structure, fallbacks: dict[str, str]) -> Reading:
        notes: tuple[str, ...] = ()
        if fallbacks:
            which, reason = ", ".join(fallbacks), next(iter(fallbacks.values()))
            notes = (f"{which}: read by the learned reader instead of the model. {reason}",)
        self._say(notes)
        return Reading(structure=structure, fallbacks=fallbacks, notes=notes)

    def _all_stand_in(self, text: str, structure: Structure, reason: str) -> Reading:
        structure = structure.model_copy(update={"text": text})
        for component in structure.components:
            marked = component.model_copy(update={"assumed": (*component.assumed, _mark(reason))})
            structure = structure.with_component(marked)
        notes = (f"The whole text was read by the learned reader instead of the model. {reason}",)
        self._say(notes)
        return Reading(structure=structure, fallbacks=dict.fromkeys(structure.ids, reason), notes=notes)

    def _say(self, notes: tuple[str, ...]) -> None:
        for note in notes:
            if self.on_event:
                self.on_event(Say(text=note, severity="warning"))

    def _component(
        self, cid: str, sentences: Sentences, text: str, spec: AnySpec, assumed: tuple[Assumption, ...],
        unmet: tuple[Unmet, ...], failed: str | None = None,
    ) -> Component:  # fmt: skip
        sentence = sentences.of(cid)
        marks = (*assumed, _mark(failed)) if failed else assumed
        return Component(
            id=cid, description=sentence, spec=spec, links=link(text, sentence) if sentence else (), assumed=marks,
            unmet=unmet,
        )  # fmt: skip

    async def _settings(self, text: str, sentences: Sentences) -> Detected:
        """The detector looks at the whole text: settings are often said in passing."""
        if not sentences.settings and not asks("G", text):
            return Detected(spec=SettingsSpec())
        return await detect(text, self.asker)

    async def _spec(self, cid: str, text: str, sentences: Sentences) -> tuple[AnySpec, tuple[Unmet, ...]]:
        if not sentences.of(cid):
            return SPEC_OF[cid[0]](), ()
        return await self.fill(cid, sentences.of(cid), text, sentences)

    async def fill(self, cid: str, sentence: str, text: str, sentences: Sentences) -> tuple[AnySpec, tuple[Unmet, ...]]:
        """The spec of one component by its sentence; raises ModelError."""
        form = form_of(cid, text, sentences)
        about = annotate(excerpt(text, sentence))
        user = prompt("ask", text=about, components=sentences.listed(but=cid), id=cid, sentence=annotate(sentence))
        purpose = "object" if cid.startswith("O") else _KINDS[cid]
        still = cid.startswith("O") and sentences.objects[int(cid[1:]) - 1].still
        build = _builder(cid, still)
        return await self.asker.form(form.system, user, form.schema, purpose=purpose, component=cid, build=build)


def _builder(cid: str, still: bool = False) -> Callable[[dict[str, Any]], tuple[AnySpec, tuple[Unmet, ...]]]:
    def build(value: dict[str, Any]) -> tuple[AnySpec, tuple[Unmet, ...]]:
        left = value.pop("unmet", "")
        if "model" in value and not BLUEPRINT.fullmatch(value["model"]):
            del value["model"]
        for name in ("require", "terminate_when"):
            if name in value:
                value[name] = [c for c in value[name] if _says_something(c)]
        if "limits" in value:
            value["limits"] = [c for c in value["limits"] if _bounds_something(c)]
        if still and not words.is_thing(value["type"]):
            value["speed"] = 0
        unmet: tuple[Unmet, ...] = (Unmet(text=left, reason="the form has no field for it"),) if left.strip() else ()
        misplaced = pop_inapplicable_fields(value)
        unmet += tuple(Unmet(text=said, reason="the field it belongs to cannot hold it") for said in misplaced)
        return spec_class(cid[0]).model_validate(value), unmet  # type: ignore[return-value]

    return build


def _says_something(condition: dict[str, Any]) -> bool:
    """Whether a condition is about two objects where it must be; turned bounds are set right."""
    low, high = condition.get("minimum"), condition.get("maximum")
    if low is not None and high is not None and low > high:
        condition["minimum"], condition["maximum"] = high, low
    if condition["kind"] in _OF_TWO:
        condition.setdefault("other", "ego")
    return condition["kind"] not in _OF_TWO or condition["other"] != condition.get("subject", "ego")


def _bounds_something(limit: dict[str, Any]) -> bool:
    """Whether a limit says how much; turned bounds are set right."""
    low, high = limit.get("minimum"), limit.get("maximum")
    if low is not None and high is not None and low > high:
        limit["minimum"], limit["maximum"] = high, low
    if limit.get("other") == limit.get("subject", "ego"):
        limit.pop("other", None)
    return limit["kind"] == "collision" or low is not None or high is not None


def share_without_fallback(structure: Structure) -> float:
    """The share of components for which the reader does not stand in, by the marks in `assumed`."""
    marked = [c.id for c in structure.components if any(a.field == "*" for a in c.assumed)]
    return 1 - len(marked) / len(structure.components)


def _mark(reason: str) -> Assumption:
    return Assumption(field="*", value="learned reader", reason=reason)


_OF_TWO = {"distance", "visible", "not_visible", "collision"}
