"""The paper's Interpreter: a text to one sentence per component (R, E, O1..N, T, and what is said of G)."""

import re
from typing import Any, get_args

from pydantic import BaseModel, ConfigDict

from c2s_engine.interpret.llm.asking import Asker, prompt
from c2s_engine.interpret.llm.schema import limits
from c2s_engine.interpret.llm.units import annotate, plain
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Link


class ObjectSentence(BaseModel):
    model_config = ConfigDict(frozen=True)

    type: str
    sentence: str
    still: bool = False
    """Whether it never moves."""


class Sentences(BaseModel):
    """What the text says of each component; empty where it says nothing."""

    model_config = ConfigDict(frozen=True)

    settings: str = ""
    place: str = ""
    ego: str = ""
    objects: tuple[ObjectSentence, ...] = ()
    restrictions: str = ""

    def of(self, cid: str) -> str:
        """A component's sentence."""
        if cid.startswith("O"):
            return self.objects[int(cid[1:]) - 1].sentence
        return {"G": self.settings, "R": self.place, "E": self.ego, "T": self.restrictions}[cid]

    @property
    def ids(self) -> list[str]:
        return ["G", "R", "E", *(f"O{i + 1}" for i in range(len(self.objects))), "T"]

    def listed(self, but: str = "") -> str:
        """`O1 (van): sentence` lines of all that is said (of the others than one), for a prompt."""
        kinds = {f"O{i + 1}": f" ({o.type})" for i, o in enumerate(self.objects)}
        said = [cid for cid in self.ids if self.of(cid) and cid != but]
        return "\n".join(f"{cid}{kinds.get(cid, '')}: {self.of(cid)}" for cid in said) or "nothing else is described"


def sentences_schema() -> dict[str, Any]:
    """The schema of the answer; everything but the settings and restrictions is asked for."""
    sentence = {"type": "string", "maxLength": limits()["lengths"]["sentence"]}
    item = {
        "type": "object",
        "properties": {
            "type": {"type": "string", "enum": list(get_args(v.ObjectType))},
            "still": {"type": "boolean"},
            "sentence": sentence,
        },
        "required": ["type", "sentence"],
        "additionalProperties": False,
    }
    return {
        "type": "object",
        "properties": {
            "settings": sentence,
            "place": sentence,
            "ego": sentence,
            "objects": {"type": "array", "items": item, "maxItems": limits()["lengths"]["objects"]},
            "restrictions": sentence,
        },
        "required": ["objects"],
        "additionalProperties": False,
    }


def instructions() -> str:
    """What the splitter is told."""
    return prompt("components", types=", ".join(get_args(v.ObjectType)))


async def read_components(text: str, asker: Asker, strict: bool = False) -> Sentences:
    """The sentences of a text; raises ModelError. `strict`: sentences copied from the instructions are refused, for
    those who have something to put in their place."""
    if not text.strip():
        return Sentences()
    told = instructions()

    def build(value: dict[str, Any]) -> Sentences:
        found = _tidy(value)
        for cid in found.ids:
            if strict and _copied(found.of(cid), told, text):
                raise ValueError(f'"{found.of(cid)}" is of the example, the text does not say it')
        return found

    return await asker.form(told, annotate(text), sentences_schema(), purpose="interpret", build=build)


def _copied(sentence: str, instructions: str, text: str) -> bool:
    """Whether a sentence stands in the instructions (a small model repeats their examples) and is not of the text."""
    said = {w[:4] for w in _content(text)}
    own = {w[:4] for w in _content(sentence)}
    return bool(own) and sentence in instructions and 2 * len(own & said) < len(own)


def _tidy(value: dict[str, Any]) -> Sentences:
    longest = limits()["lengths"]["sentence"]

    def clean(words: str) -> str:
        return re.sub(r"\s+", " ", plain(words)).strip()[:longest]

    told = [
        ObjectSentence(type=o["type"], sentence=clean(o["sentence"]), still=o.get("still", False))
        for o in value["objects"]
    ]
    objects = tuple(dict.fromkeys(o for o in told if o.sentence))  # one that is said again is the same one
    told_of = {name: clean(value.get(name, "")) for name in ("settings", "place", "ego", "restrictions")}
    if not objects and not told_of["ego"] and not told_of["place"]:
        raise ValueError("nothing is said of ego, the place or any object")
    return Sentences(objects=objects, **told_of)


_SENTENCE = re.compile(r"[^.!?;]+(?:[.](?=\d)[^.!?;]+)*[.!?;]?")


def link(text: str, sentence: str) -> tuple[Link, ...]:
    """The part of the user's text that a component's sentence rests on: that with most words in common."""
    wanted = _content(sentence)
    best, score = None, 0
    for match in _SENTENCE.finditer(text):
        common = len(wanted & _content(match[0]))
        if common > score:
            best, score = match, common
    if best is None:
        return ()
    start = best.start() + len(best[0]) - len(best[0].lstrip())
    return (Link(kind="text", label=text[start : best.end()].strip(), span=(start, best.end())),)


LONGEST = 240
"""Characters of a text up to which it is shown whole to each form."""


def excerpt(text: str, sentence: str) -> str:
    """The sentences of a text that a component's sentence has words in common with, in their order, the best of them
    first where not all find room; a short text as it is."""
    if len(text) <= LONGEST:
        return text
    wanted = _content(sentence)
    parts = [(m[0].strip(), len(wanted & _content(m[0]))) for m in _SENTENCE.finditer(text)]
    chosen: set[int] = set()
    room = LONGEST
    for i in sorted(range(len(parts)), key=lambda i: -parts[i][1]):
        if parts[i][1] and (len(parts[i][0]) <= room or not chosen):
            chosen.add(i)
            room -= len(parts[i][0])
    return " ".join(parts[i][0] for i in sorted(chosen)) or sentence


def _content(text: str) -> set[str]:
    return {w for w in re.findall(r"[a-z0-9]{3,}", text.lower()) if w not in _COMMON}


_COMMON = {"the", "and", "ego", "its", "that", "when", "with", "from", "which", "for", "has", "are", "was", "vehicle"}
