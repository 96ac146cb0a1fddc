"""Changes upon a scene, as the learned model writes them: lines of the short notation with what becomes another.

    O1: speed=20km/h -gap            fields that are set, and fields that are left open
    O1: ; brake rate=6m/s2 ; stop    all phases anew (a bare `;`: none)
    +O3: car at=behind gap=15m ; follow target=ego
    -O2

The model is asked with S in short notation and what was typed; it answers `none` where that is no change. What a line
does not name stays as it is, to the last digit.
"""

import math
from collections.abc import Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from c2s_engine.interpret.changes.corrected import differences
from c2s_engine.interpret.changes.removal_edits import removal_edits
from c2s_engine.interpret.learned.decoder import loaded
from c2s_engine.interpret.learned.notation import NONE, PLACEMENT, Components, parse, short
from c2s_engine.interpret.learned.quantities import si
from c2s_engine.interpret.learned.reader import component_of_data
from c2s_engine.interpret.learned.units import with_units
from c2s_engine.interpret.llm.fallback import distinct_names
from c2s_engine.structure.components import Component, Structure, field_words
from c2s_engine.structure.edits import Edit, apply
from c2s_engine.structure.sentences import sentence, with_updated_sentences
from c2s_engine.structure.shown import value_in_words
from c2s_engine.structure.specs import ObjectSpec, Spec

TYPED = "\n> "
"""What parts S from what was typed upon it, in a prompt."""
LEAST = 0.3
"""How likely the least likely token of an answer is below which the rules are believed instead: of 182 changes held out
of training 12 are below, and none of these is as it should be."""
SURE = 0.6
"""The same below which a change is a guess: of those above 50 of 78 are as they should be, of those below 20 of 100."""
GUESS = "not sure of that ({:.0%}): compare S with what you typed, undo takes it back"
BARE = {"R": "road", "E": "car", "O": "car at=ahead"}
"""The first words of a component's line, where a change says none."""


@dataclass(frozen=True)
class Change:
    """Edits (none: the text is no change) with what they do in words; `likely`: the probability (0 to 1) of the least
    likely token of the answer."""

    edits: tuple[Edit, ...]
    words: str
    likely: float


def prompt(structure: Structure, text: str) -> str:
    """What the model is asked."""
    return short(with_units(_said(structure), structure.text)) + TYPED + " ".join(text.split())


def answer_of(lines: Sequence[str]) -> str:
    """What the model is trained to answer."""
    return "\n".join(lines) or NONE


def read_change(text: str, structure: Structure) -> Change | None:
    """The change that a text asks for; None where the model's answer does not fit S or is not `LEAST` likely. Raises
    ReaderError."""
    answer = loaded().answer(prompt(structure, text))
    lines = [line.strip() for line in answer.text.splitlines() if line.strip()]
    likely = math.exp(min((p for _, p in answer.tokens), default=0.0))
    if not lines or likely < LEAST:
        return None
    if lines == [NONE]:
        return Change((), "", likely)
    try:
        after = changed_structure(structure, lines)
    except ValueError:
        return None
    words = in_words(structure, after)
    words += f"; {GUESS.format(likely)}" if likely < SURE else ""
    edits = tuple(differences(structure, after))
    return Change(edits, words, likely) if edits else None


def changed_structure(structure: Structure, lines: Sequence[str]) -> Structure:
    """S with the lines of a change; raises ValueError where a line cannot be read, or what it says does not fit."""
    data = {c.id: _plain(c) for c in structure.components}
    after = changed(data, [line for line in lines if ":" in line])
    gone = [line[1:] for line in lines if ":" not in line and line.startswith("-")]
    speeds = {"ego" if cid == "E" else cid: si(d["speed"]) for cid, d in after.items() if "speed" in d}
    ids = {"ego", *(cid for cid in after if cid[0] == "O")}
    there, kept = {c.id: c for c in structure.components}, dict[str, Component]()
    for cid, own in after.items():
        before = there.get(cid)
        if before is not None and own == data[cid]:
            kept[cid] = before
            continue
        made = component_of_data(cid, own, ids, speeds)
        if made.unmet:
            raise ValueError(f"{cid}: {made.unmet[0].text}")
        kept[cid] = made if before is None else before.model_copy(
            update={"spec": made.spec, "assumed": tuple(a for a in before.assumed if _same(before, made, a.field))}
        )  # fmt: skip
    objects = tuple(kept[cid] for cid in after if cid[0] == "O")
    named = {"settings": kept["G"], "place": kept["R"], "ego": kept["E"], "restrictions": kept["T"]}
    if missing := [line for line in lines if ":" not in line and line[1:] not in kept]:
        raise ValueError(f"{missing[0]}: there is no {missing[0][1:]}")
    changed_so = distinct_names(structure.model_copy(update={**named, "objects": objects}))
    for added in (c for c in changed_so.objects if c.id not in there):
        changed_so = changed_so.with_component(added.model_copy(update={"description": sentence(added, changed_so)}))
    for edit in removal_edits([changed_so[cid] for cid in gone], changed_so):
        changed_so = apply(changed_so, edit)
    return with_updated_sentences(structure, changed_so)


def changed(components: Components, lines: Sequence[str]) -> Components:
    """Components as plain data with the lines of a change that say what they are; raises ValueError where a line cannot
    be read."""
    after = deepcopy(dict(components))
    for line in lines:
        cid, colon, rest = line.partition(":")
        if line.startswith("+") and colon:
            if cid[1:] in after or not cid.startswith("+O"):
                raise ValueError(f"{line}: {cid[1:]} is there already, or no object")
            after |= _read(f"{cid[1:]}:{rest}", line)
        elif colon and (cid in after or cid in ("G", "R", "T")):
            after[cid] = _with(cid, after.get(cid, {}), rest, line)
        else:
            raise ValueError(f"{line}: there is no {cid}")
    return after


def in_words(before: Structure, after: Structure) -> str:
    """What sets one S apart from another, in a sentence."""
    said = [f"{c.id} added" for c in after.objects if c.id not in before]
    said += [f"{c.id} removed" for c in before.objects if c.id not in after]
    for component in after.components:
        was = before[component.id].spec if component.id in before else None
        if was is None or was == component.spec:
            continue
        now = component.spec
        fields = [(path, getattr(was, path), getattr(now, path)) for path in type(now).model_fields]
        if isinstance(was, ObjectSpec) and isinstance(now, ObjectSpec):
            fields += [(f"placement.{p}", getattr(was.placement, p), getattr(now.placement, p))
                       for p in type(now.placement).model_fields]  # fmt: skip
        other = (_field_in_words(path, one, two) for path, one, two in fields
                 if one != two and path not in ("placement", "name"))  # fmt: skip
        name = "ego" if component.id == "E" else component.id
        said.append(f"{name}: {', '.join(other)}")
    return "; ".join(said)


def _field_in_words(path: str, was: Any, now: Any) -> str:
    return f"{field_words(path)} {'left open' if now is None and was is not None else value_in_words(path, now)}"


def _said(structure: Structure) -> Structure:
    """S without what was only assumed for it to run."""
    for component in structure.components:
        data = component.spec.model_dump(exclude_defaults=True)
        for path in (a.field for a in component.assumed if a.by != "reader"):
            _drop(data, path.split("."))
        spec = type(component.spec).model_validate({"component": component.spec.component, **data})
        structure = structure.with_component(component.model_copy(update={"spec": spec}))
    return structure


def _drop(data: Any, path: list[str]) -> None:
    *around, last = path
    for step in around:
        if isinstance(data, Mapping) and step in data:
            data = data[step]
        elif isinstance(data, list | tuple) and step.isdigit() and int(step) < len(data):
            data = data[int(step)]
        else:
            return
    if isinstance(data, dict):
        data.pop(last, None)


def _plain(component: Component) -> dict[str, Any]:
    return component.spec.model_dump(mode="json", exclude_defaults=True, exclude={"component"})


def _same(before: Component, after: Component, field: str) -> bool:
    """Whether a field, and what it lies in, is as before."""
    head = field.split(".")[0]
    return isinstance(before.spec, Spec) and getattr(before.spec, head, None) == getattr(after.spec, head, None)


def _with(cid: str, data: dict[str, Any], rest: str, line: str) -> dict[str, Any]:
    """A component's data with what a line sets and leaves open."""
    head, *steps = (part.strip() for part in rest.split(";"))
    words = head.split()
    bare = [w for w in words if "=" not in w and w[0] != "-" and w != "hard"] if cid != "T" else []
    given = " ".join(w for w in words if w[0] != "-" and w not in bare)
    said = _read(f"{cid}: {' '.join(bare) or BARE.get(cid[:1], '')} {given} {''.join(f'; {s}' for s in steps)}", line)
    after, placed = dict(data), dict(data.get("placement", {}))
    names = {w.partition("=")[0] for w in words}
    for name, value in said.get(cid, {}).items():
        if name == "placement":
            placed |= {k: v for k, v in value.items() if k != "position" or "at" in names}
        elif name == "name":  # somebody who is called by its type
            after |= {name: value} if bare and data.get("name") == data.get("type") else {}
        elif name not in ("type", "kind") or bare:
            after[name] = value
    for name in (w[1:] for w in words if w[0] == "-"):
        where = placed if name in PLACEMENT else after
        if name not in where:
            raise ValueError(f"{line}: {cid} has no {name}")
        del where[name]
    if steps and not any(steps):
        after.pop("phases", None)
    return after | ({"placement": placed} if placed else {})


def _read(text: str, line: str) -> Components:
    found = parse(text)
    if not found and text.partition(":")[2].strip():
        raise ValueError(f"{line}: it cannot be read")
    return found
