"""Changes upon a scene, as the learned model writes them: lines of the short notation with what becomes another.

    O1: speed=20km/h -gap            fields that are set, and fields that are left open
    O1: ; brake rate=6m/s2 ; stop    all phases anew (a bare `;`: none)
    +O3: car at=behind gap=15m ; follow target=ego
    -O2

The model is asked with S in short notation and what was typed; it answers `none` where that is no change. What a line
does not name stays as it is, to the last digit.
"""

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from c2s_engine.interpret.learned.decoder import ReaderError, loaded
from c2s_engine.interpret.learned.edits import differences, removal_edits, worded
from c2s_engine.interpret.learned.notation import NONE, PLACEMENT, Components, parse, short
from c2s_engine.interpret.learned.quantities import si
from c2s_engine.interpret.learned.reader import component_of_data
from c2s_engine.interpret.learned.relative import counted
from c2s_engine.interpret.learned.units import rooms_in_seconds, with_units
from c2s_engine.interpret.mentions import mentions
from c2s_engine.interpret.text import normalised
from c2s_engine.structure.components import READ, WORDS, Component, Structure
from c2s_engine.structure.edits import AddObject, Edit, EditError, SetField, apply
from c2s_engine.structure.objects import distinct_names
from c2s_engine.structure.sentences import action_of, with_own_sentence, with_updated_sentences
from c2s_engine.structure.specs import ObjectSpec, Spec

TYPED = "\n> "
"""What parts S from what was typed upon it, in a prompt."""
LEAST = 0.3
"""How likely the least likely token of an answer is below which the rules are believed instead: of 182 changes held out
of training 12 are below, and none of these is as it should be."""
SURE = 0.6
"""The same below which a change is a guess: of those above 50 of 78 are as they should be, of those below 20 of 100."""
GUESS = "not sure of that ({:.0%}): compare S with what you typed, undo takes it back"
GIVEN_UP = ("action", "abandoned", "target")
"""What a change may leave out of a phase to take it away, besides triggers on what others do."""
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
    """The change that a text asks for; None where the model's answer is not `LEAST` likely, does not fit S, or changes
    somebody else than the one named, who is not there. Raises ReaderError."""
    answer = loaded().answer(prompt(structure, text))
    lines = [line.strip() for line in rooms_in_seconds(answer.text, text).splitlines() if line.strip()]
    likely = math.exp(min((p for _, p in answer.tokens), default=0.0))
    if not lines or likely < LEAST:
        return None
    if lines == [NONE]:
        return Change((), "", likely)
    try:
        after = counted(text, structure, changed_structure(structure, lines, bool(mentions(text))))
    except ReaderError:
        raise
    except ValueError:
        return None
    edits = tuple(differences(structure, after))
    if not edits or stranger(text, edits, structure):
        return None
    guess = f"; {GUESS.format(likely)}" if likely < SURE else ""
    return Change(edits, in_words(structure, after) + guess, likely)


def stranger(text: str, edits: Sequence[Edit], structure: Structure) -> str:
    """Whom a text is about, by its words, where it begins with a definite noun that nobody of S can be meant by, and
    yet others would change whom it does not name; empty where there is no such one."""
    changed_ids = {str(getattr(e, "component", "")) for e in edits}
    named = mentions(text)
    if not named or changed_ids & {"G", "R", "T"} or any(isinstance(e, AddObject) for e in edits):
        return ""
    first = named[0]
    types = {c.id: c.spec.type for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    fitting = {cid for m in named for cid, kind in types.items() if m.fits(kind)}
    by_word = {cid for cid in types if re.search(rf"\b{cid}\b", text, re.IGNORECASE)}
    meant = {cid for cid, kind in types.items() if first.fits(kind)}
    alone = len(named) == 1 and first.type != "vehicle" and meant and not changed_ids & {*meant, "E"}
    known = (first.type == "vehicle" or bool(meant)) and not alone
    if known or changed_ids & (fitting | by_word) or not _SUBJECT.fullmatch(normalised(text)[: first.start]):
        return ""
    if alone:
        return text[first.start : first.end]
    said = " ".join(c.spec.model_dump_json() for c in structure.components)
    noun = text[first.start : first.end]
    return "" if noun.lower() in said or noun.lower() in structure.text.lower() else noun


_SUBJECT = re.compile(
    r"(?:(?:please|now|let|make|have|move|put|set|slow|remove|delete) )*(?:the|that|this) (?:[\w-]+ ){0,2}"
)


def changed_structure(structure: Structure, lines: Sequence[str], named: bool = True) -> Structure:
    """S with the lines of a change; raises ValueError where a line cannot be read, or what it says does not fit.
    `named`: whether the change names somebody, on whom what a phase waits for may depend then."""
    data = {c.id: _plain(c) for c in structure.components}
    gone = [line[1:] for line in lines if re.fullmatch(r"-O\d+", line)]
    after = changed(data, [line for line in lines if line[1:] not in gone])
    if not named:
        _watching_the_same(data, after)
    speeds = {"ego" if cid == "E" else cid: si(d["speed"]) for cid, d in after.items() if "speed" in d}
    ids = {"ego", *(cid for cid in after if cid[0] == "O")}
    found = structure
    for cid, own in after.items():
        if own == data.get(cid):
            continue
        made = component_of_data(cid, own, ids, speeds)
        if made.unmet:
            raise ValueError(f"{cid}: {made.unmet[0].text}")
        if cid in structure:
            assumed = tuple(a for a in structure[cid].assumed if _same(structure[cid], made, a.field))
            found = found.with_component(structure[cid].model_copy(update={"spec": made.spec, "assumed": assumed}))
        else:
            found = found.model_copy(update={"objects": (*found.objects, made)})
    found = distinct_names(found)
    for added in (c for c in found.objects if c.id not in structure):
        found = found.with_component(with_own_sentence(added, found))
    if missing := [cid for cid in gone if cid not in found]:
        raise ValueError(f"-{missing[0]}: there is no {missing[0]}")
    for edit in removal_edits([found[cid] for cid in gone], found):
        found = apply(found, edit)
    return with_updated_sentences(structure, found)


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
    edits: list[Edit] = []
    for component in after.components:
        was, now = before[component.id].spec if component.id in before else None, component.spec
        if was is None:
            edits.append(AddObject(component=component.id, spec=now))  # type: ignore[arg-type]
        elif isinstance(was, ObjectSpec) and isinstance(now, ObjectSpec):
            edits += _set(component.id, "", was, now)
            edits += _set(component.id, "placement.", was.placement, now.placement)
        else:
            edits += _set(component.id, "", was, now)
    gone = [f"{c.id} removed" for c in before.objects if c.id not in after]
    gone += [words for c in after.components if c.id in before and (words := _no_longer(before, after, c.id))]
    return "; ".join(filter(None, [worded(edits, before), *gone]))


def _no_longer(before: Structure, after: Structure, cid: str) -> str:
    """What somebody did, in words, that it no longer does."""
    was, now = (getattr(s[cid].spec, "phases", ()) for s in (before, after))
    left = [p.action for p in now]
    gone = [p for p in was if p.action not in left and p.action not in ("keep_lane", "follow", "move_along")]
    done = " and ".join(dict.fromkeys(action_of(p, before) for p in gone)) if now else ""
    return f"{'ego' if cid == 'E' else cid} no longer {done}" if done else ""


def _set(cid: str, path: str, was: Spec, now: Spec) -> Iterator[Edit]:
    """The fields of a spec, but for its name and what is told apart below it, that become another."""
    for name in type(now).model_fields:
        if name not in ("name", "placement") and (value := getattr(now, name)) != getattr(was, name):
            yield SetField(component=cid, path=path + name, value=value)


def _said(structure: Structure) -> Structure:
    """S without what was only assumed for it to run."""
    for component in structure.components:
        for field in (a.field for a in component.assumed if a.by not in (READ, WORDS)):
            with suppress(EditError):  # a field that cannot be left open stays
                structure = apply(structure, SetField(component=component.id, path=field, value=None))
    return structure


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
        if name == "phases":
            after[name] = [_kept(phase, value, data.get("phases", ())) for phase in value]
        elif name == "placement":
            placed |= {k: v for k, v in value.items() if k != "position" or "at" in names}
        elif name == "name":  # somebody who is called by its type
            after |= {name: value} if bare and data.get("name") == data.get("type", "car") else {}
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


def _kept(phase: dict[str, Any], phases: Sequence[Any], before: Sequence[Any]) -> dict[str, Any]:
    """A phase of a change with what it leaves out of the one that it stands for, which is the only one of its action:
    of 2,303 such phases of changes by hand 64 leave something out on purpose, mostly what is in `GIVEN_UP`."""
    same = [p for p in before if p["action"] == phase["action"]]
    if len(same) != 1 or [p["action"] for p in phases].count(phase["action"]) != 1:
        return phase
    old = {name: value for name, value in same[0].items() if name not in GIVEN_UP and name not in phase}
    for name in ("trigger", "until"):
        if isinstance(old.get(name), dict) and old[name].get("kind") in ("passed", "action"):
            del old[name]
    if "pace" in phase or "speed" in phase:
        old = {name: value for name, value in old.items() if name not in ("pace", "speed")}
    return phase | old


def _watching_the_same(before: Components, after: Components) -> None:
    """Let phases that still wait for something of the same kind wait for the same ones as before."""
    for cid in before.keys() & after.keys():
        was, now = before[cid].get("phases", ()), after[cid].get("phases", ())
        for old, new in zip(was, now, strict=False) if len(was) == len(now) else ():
            for name in ("trigger", "until"):
                one, other = old.get(name) or {}, new.get(name) or {}
                if one.get("kind") == other.get("kind") is not None:
                    whom = {key: one[key] for key in ("subject", "of") if key in one}
                    new[name] = {k: v for k, v in other.items() if k not in ("subject", "of")} | whom


def _read(text: str, line: str) -> Components:
    found = parse(text)
    if not found and text.partition(":")[2].strip():
        raise ValueError(f"{line}: it cannot be read")
    return found
