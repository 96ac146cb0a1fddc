"""The sentence of a component, made from the spec that was written, and what of the model's own sentence it lost."""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

from c2s_engine.interpret.llm import words
from c2s_engine.interpret.llm.units import quantities
from c2s_engine.structure import sentences as describe
from c2s_engine.structure.components import ComponentId, Structure, Unmet
from c2s_engine.structure.leaves import leaves
from c2s_engine.structure.quantity import high, in_words, low
from c2s_engine.structure.specs import AnySpec, Condition, EgoSpec, ObjectSpec, Phase, PlaceSpec, RestrictionsSpec

CLOSE = 0.05
"""How far a number of the sentence may lie from that of the spec (it was rounded)."""
LOST = "the form was filled in without it"
_PARTS = re.compile(r"[,;:]\s+|\s+(?:and|but|while|when|because|as|which|who|so that|until|before|after)\s+")
_MANNER = re.compile(r"\b(?!(?:early|only|suddenly|directly|finally|initially|immediately|currently)\b)[a-z]{3,}ly\b")
_PLAIN = {"the", "and", "its", "that", "with", "from", "for", "has", "are", "was", "then", "into", "onto", "his", "her",
          "their", "them", "there", "this", "being", "been", "other"}  # fmt: skip


def with_rendered_sentences(structure: Structure, said: Mapping[ComponentId, str]) -> Structure:
    """S with sentences made from its specs, where the model had one; what that one says beyond them is `unmet`."""
    specs = structure
    for component in specs.components:
        if own := said.get(component.id):
            made = sentence(component.id, component.spec, specs)
            structure = structure.with_component(component.model_copy(update={"description": made}))
    for cid, own in said.items():
        if own and cid in structure:
            unmet = (*structure[cid].unmet, *lost(own, cid, structure))
            structure = structure.with_component(structure[cid].model_copy(update={"unmet": unmet}))
    return structure


def sentence(cid: ComponentId, spec: AnySpec, structure: Structure) -> str:
    """A component's sentence by its spec among those of S."""
    names = {o.id: o.spec.name for o in structure.objects if isinstance(o.spec, ObjectSpec)}
    if isinstance(spec, ObjectSpec):
        made, more = describe.obj(spec, names), [*_placed(spec), *_steps(spec.phases, names)]
    elif isinstance(spec, EgoSpec):
        made = describe.ego(spec, names)
        more = [*_steps(spec.phases, names)]
    elif isinstance(spec, PlaceSpec):
        made, more = describe.place(spec), [*_around(spec)]
    elif isinstance(spec, RestrictionsSpec):
        made = describe.restrictions(spec, names) if spec.limits or spec.terminate_when or spec.duration else ""
        held = [_condition(c, names) for c in spec.require]
        return " ".join(s for s in (f"At the start {' and '.join(held)}." if held else "", made) if s)
    else:
        return describe.settings(spec)  # type: ignore[arg-type]
    return f"{made.removesuffix('.')} ({'; '.join(more)})." if more else made


def _placed(spec: ObjectSpec) -> Iterator[str]:
    if spec.spacing is not None:
        yield f"{_number(spec.spacing)} m between them"
    if spec.placement.facing:
        yield f"facing {spec.placement.facing} the road"
    if spec.limit:
        yield f"it says {spec.limit * 3.6:.0f} km/h"


def _around(spec: PlaceSpec) -> Iterator[str]:
    if beside := [n for n in ("shoulder", "sidewalk") if getattr(spec, n)]:
        yield f"with a {' and a '.join(beside)}"
    if spec.oncoming is False:
        yield "no oncoming lane beside"
    if spec.distance is not None:
        yield f"{_number(spec.distance)} m from ego's start"


def _steps(phases: tuple[Phase, ...], names: Mapping[str, str]) -> Iterator[str]:
    """What the sentence of the phases leaves out: whose action or distance begins one, its speed and its duration."""
    for phase in phases:
        more = []
        if phase.speed is not None:
            more.append(f"to {in_words('speed', phase.speed)}")
        if phase.duration is not None:
            more.append(f"for {_number(phase.duration)} s")
        trigger = phase.trigger
        if trigger and trigger.kind == "action" and trigger.action:
            more.append(f"when {_who(trigger.of, names)} begins to {_doing(trigger.action)}")
        elif trigger and trigger.kind in ("distance", "ttc") and trigger.of:
            more.append(f"by the {trigger.kind.replace('ttc', 'TTC')} to {_who(trigger.of, names)}")
        if more:
            yield f"{phase.action.replace('_', ' ')} {' '.join(more)}"


def _doing(action: str) -> str:
    return describe.table()["actions"][action].format(target="it")


def _who(cid: str | None, names: Mapping[str, str]) -> str:
    return "ego" if cid in (None, "ego") else f"the {names.get(cid or '', cid or '').replace('_', ' ')}"


def _condition(condition: Condition, names: Mapping[str, str]) -> str:
    one, other = _who(condition.subject, names), _who(condition.other, names)
    if condition.kind != "distance":
        return f"{one} {'can' if condition.kind == 'visible' else 'cannot'} see {other}"
    bounds = [f"at least {condition.minimum:g} m"] if condition.minimum is not None else []
    bounds += [f"at most {condition.maximum:g} m"] if condition.maximum is not None else []
    return f"{one} is {' and '.join(bounds) or 'at some distance'} from {other}"


def _number(value: Any) -> str:
    a, b = low(value), high(value)
    return f"{a:g}" if b - a < 1e-6 else f"{a:g} to {b:g}"


def lost(said: str, cid: ComponentId, structure: Structure) -> tuple[Unmet, ...]:
    """What of a model's sentence is in no spec of S: its quantities, manners, and parts without a word in common."""
    sentences = _stems(" ".join(c.description for c in structure.components))
    known = sentences | _stems(_meanings(structure[cid].spec))
    numbers = [n for c in structure.components for n in _numbers(c.spec.model_dump())]
    found = [words_ for words_, value in quantities(said) if not any(_same(value, n) for n in numbers)]
    found += [m[0] for m in _MANNER.finditer(said.lower()) if m[0][:4] not in {k[:4] for k in sentences}]
    found += [m[0] for m in _action_words().finditer(said) if not _stems(m[0]) & known]
    for part in _PARTS.split(said):
        own = _stems(part)
        if len(own) >= 2 and not own & known and not any(f in part.lower() for f in found):
            found.append(part.strip(" ."))
    return tuple(Unmet(text=f, reason=LOST, span=_span(f, structure.text)) for f in dict.fromkeys(found))


@cache
def _action_words() -> re.Pattern[str]:
    """The verbs that name an action of the vocabulary, in whatever form."""
    names = {n.removesuffix("_road") for n in words.all_actions()} - {"start", "enter", "leave"}
    stems = sorted(n[:-1] if n.endswith("e") else n for n in names if "_" not in n and len(n) >= 5)
    return re.compile(rf"\b(?:{'|'.join(stems)})\w*", re.I)


def _stems(text: str) -> set[str]:
    return {w[:5] for w in re.findall(r"[a-z]{3,}", text.lower()) if w not in _PLAIN}


def _meanings(spec: AnySpec) -> str:
    """The vocabulary's meanings of the words that a spec has."""
    rows = words.vocabulary()
    said = [w for w in leaves(spec.model_dump()) if isinstance(w, str)]
    entries = [rows[s].get(w) for w in said for s in rows if isinstance(rows[s], dict)]
    return " ".join(str(e) for e in entries if e)


def _numbers(value: Any) -> Iterator[tuple[float, float]]:
    """Every number of a spec, as the range that it is."""
    if isinstance(value, dict):
        for item in value.values():
            yield from _numbers(item)
    elif isinstance(value, list | tuple) and len(value) == 2 and all(isinstance(v, int | float) for v in value):
        yield value[0], value[1]
    elif isinstance(value, list | tuple):
        for item in value:
            yield from _numbers(item)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield value, value


def _same(value: float, held: tuple[float, float]) -> bool:
    return held[0] * (1 - CLOSE) - 0.05 <= value <= held[1] * (1 + CLOSE) + 0.05


def _span(words_: str, text: str) -> tuple[int, int] | None:
    at = text.lower().find(words_.lower())
    return (at, at + len(words_)) if at >= 0 else None
