"""Full-script generation (after NL2Scenic): one prompt with the nearest whole programs as few-shots, no repair."""

import re
from collections.abc import Awaitable, Callable, Sequence
from typing import Literal, get_args

from c2s_engine.interpret.mentions import mentions
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.messages import question
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.progress import Progress
from c2s_engine.structure.regenerate import digest
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.vocabulary import ObjectType
from c2s_engine.write.baselines.own import with_own
from c2s_engine.write.by_hand import GIVEN_BACK, OWN, TAKEN
from c2s_engine.write.prompted.checking import Check, with_code
from c2s_engine.write.prompted.examples import Example, Fragment, examples, fragments
from c2s_engine.write.prompted.header import Ground
from c2s_engine.write.prompted.parsing import program_of
from c2s_engine.write.prompted.texts import fill

Variant = Literal["zero", "few", "cot"]
Embed = Callable[[Sequence[str]], Awaitable[list[list[float]]]]
VARIANTS: tuple[Variant, ...] = ("zero", "few", "cot")
SHOTS = 3


class NL2Scenic:
    """The method in one of its variants; `embed` ranks the examples (without it, words in common do).

    `check` says whether code by hand still fits a program that has no component for it; the model's own is not checked.
    """

    def __init__(
        self, client: OllamaClient, embed: Embed | None = None, variant: Variant = "few", ground: Ground | None = None,
        check: Check | None = None,
    ) -> None:  # fmt: skip
        self.client, self.embed, self.variant, self.ground = client, embed, variant, ground or Ground()
        self.check = check
        self.name = f"nl2scenic:{variant}"

    async def interpret(self, text: str, on_event: Callable[[Progress], None] | None = None) -> Structure:
        """Nothing is interpreted: the text goes into the one prompt as it is."""
        return Structure(text=text)

    async def write(self, structure: Structure, on_event: Callable[[Progress], None] | None = None) -> Structure:
        """The whole program where it is not written yet or given back; code by hand stays. Raises ModelError, or
        ValueError where code by hand has no place in what the model wrote."""
        key = digest([self.name, self.client.settings.model, structure.text])
        for taken in (c for c in structure.components if c.key == TAKEN):
            structure = structure.with_component(taken.model_copy(update={"key": key}))
        if _stands(structure, key):
            return structure
        shots = await self.nearest(structure.text) if self.variant != "zero" else []
        told = "\n".join(
            fill("nl2scenic_example", description=e.description, program=self._grounded(e.text)) for e in shots
        )
        system = fill(
            "nl2scenic", map_file=self.ground.map_file, carla_map=repr(self.ground.carla_map),
            examples=f"\nExamples:\n\n{told}\n" if told else "",
            plan=fill("nl2scenic_cot") if self.variant == "cot" else "",
        )  # fmt: skip
        asked = question(system, f"Description: {structure.text}", purpose="generate program")
        written = taken_apart(structure, program_of((await self.client.chat(asked, on_event)).text))
        whole = await with_own(structure, written, self.check)
        for component in (c for c in whole.components if c.origin not in OWN):
            whole = whole.with_component(component.model_copy(update={"key": key}))
        return whole

    async def nearest(self, text: str, count: int = SHOTS) -> list[Example]:
        """The example programs whose descriptions are nearest to a text, the nearest first."""
        known = list(examples().values())
        if self.embed is None:
            words = _words(text)
            scores = [len(words & _words(e.description)) / len(words | _words(e.description)) for e in known]
        else:
            wanted, *rest = await self.embed([text, *(e.description for e in known)])
            scores = [sum(a * b for a, b in zip(wanted, v, strict=True)) for v in rest]
        ranked = sorted(zip(scores, known, strict=True), key=lambda pair: -pair[0])
        return [example for _, example in ranked[:count]]

    def _grounded(self, program: str) -> str:
        return re.sub(r"localPath\('[^']*'\)", f"localPath('{self.ground.map_file}')", program).strip()


def taken_apart(structure: Structure, program: str) -> Structure:
    """S of a whole program: by its borders where they are all there in order, else all of it as ego's fragment."""
    parts = list(fragments(program))
    ids = [p.id for p in parts]
    if not _in_order(ids) or not program.lstrip().startswith("## G"):
        parts, ids = [Fragment(id="E", sentence="The whole program.", code=program)], ["E"]
    said = {p.id: _type_of(p.sentence) for p in parts if p.id.startswith("O")}
    objects = tuple(Component(id=i, spec=ObjectSpec(name=f"object{i[1:]}", type=said[i])) for i in ids if i in said)
    structure = structure.model_copy(update={"objects": objects})
    for part in parts:
        component = structure[part.id].model_copy(update={"description": part.sentence})
        structure = structure.with_component(with_code(component, part.code))
    return structure


def _type_of(sentence: str) -> ObjectType:
    """The type of the first object that a sentence names; a car where it names none."""
    types: tuple[ObjectType, ...] = get_args(ObjectType)
    named = [m.type for m in mentions(sentence)]
    return next((kind for name in named for kind in types if kind == name), "car")


def _stands(structure: Structure, key: str) -> bool:
    """Whether the program is written, as far as it is the model's."""
    theirs = [c for c in structure.components if c.origin not in OWN]
    known = not theirs or any(c.key == key for c in theirs)
    return known and all(c.key == key if c.code else c.key != GIVEN_BACK for c in theirs)


def _in_order(ids: list[str]) -> bool:
    """Whether borders are those of Algorithm 1, each once: G, R, E, O1..N, T."""
    objects = [i for i in ids if i.startswith("O")]
    return ids == ["G", "R", "E", *(f"O{n + 1}" for n in range(len(objects))), "T"]


def _words(text: str) -> set[str]:
    return set(re.findall(r"[a-z]{4,}", text.lower()))
