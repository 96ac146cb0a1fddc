"""The embedded interpreter: text to S by rules over a parsed text, without a language model."""

import re
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from c2s_engine.interpret import typologies
from c2s_engine.interpret.accounting import accounted
from c2s_engine.interpret.composing import compose
from c2s_engine.interpret.entities import VEHICLES
from c2s_engine.interpret.reading.english import is_english
from c2s_engine.interpret.reading.spelling import NormalisedText
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.account import covering
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.edits import EditError

OF_THE_ROAD = re.compile(
    r"\b(?:lanes?|kerb|curb|brak(?:es?|ed|ing)|skid(?:s|ded|ding)?|swerv(?:es?|ed|ing)|junction|intersection|motorway"
    r"|highway|overtak\w+|rear-end\w*|wing mirror|bumper|fender|drove|driving|hit and run|side-?swip\w+|t-?bon\w+)\b"
)
"""Words that only tales of the road have: what else they tell may be unknown, a scene it is."""

STATES = re.compile(r"(?:has|have|had|is|are|was|were)\b(?! \w+ing\b)")
"""Verbs of what somebody is or has, by which nobody goes anywhere."""

NOT_ENGLISH = "This text is not English: describe the scene in English, for example “a car cuts in ahead of ego”."

MOST_OBJECTS = 99
"""O1 to O99 are the names that S has; who is told of beyond them is listed as not understood."""

READ_AT_MOST = 12_000
"""Characters of a text that are read; the rest is listed as not understood."""


class InterpretError(ValueError):
    """A text that no scenario can be read from; the message says what would do."""


class InterpreterFault(RuntimeError):
    """A fault of the interpreter, not of the text: what failed, where, and what to do."""


@contextmanager
def faults() -> Iterator[None]:
    """Tell what fails inside as an InterpreterFault that names the place; the first failure is its cause."""
    try:
        yield
    except (InterpretError, InterpreterFault):
        raise
    except EditError as error:  # what S refuses, with why
        raise InterpreterFault(f"{error}. Nothing was changed.") from None
    except ValidationError as error:
        said = error.errors()[0]
        if "error" not in said.get("ctx", {}):  # a fault of the reading; else a number that S does not take
            raise _fault(error) from error
        reason = str(said["ctx"]["error"])
        raise InterpreterFault(f"{reason[:1].upper()}{reason[1:]}: correct the text. Nothing was changed.") from None
    except Exception as error:
        raise _fault(error) from error


def _fault(error: Exception) -> InterpreterFault:
    frames = traceback.extract_tb(error.__traceback__)
    at = next(f for f in reversed(frames) if "c2s_engine" in Path(f.filename).parts)
    return InterpreterFault(
        f"c2s failed at this text ({type(error).__name__} in {Path(at.filename).name}, line {at.lineno}); the "
        "fault is in c2s, please report it with the text. Nothing was changed; shorter sentences may do."
    )


@dataclass(frozen=True)
class Interpretation:
    """S as read from a text, with what every stage found."""

    structure: Structure
    not_understood: tuple[Unmet, ...] = ()
    stages: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    confidences: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Understood:
    """A text with its spelling mended, the scene that it tells, and the interpreter's own S of it."""

    text: str
    mended: NormalisedText
    scene: Scene
    structure: Structure

    def on_the_text(self, structure: Structure) -> Structure:
        """S, made of the mended text, with its links, notes and clauses on the user's own."""
        return _on_original(structure, self.mended, self.text)


def understood(text: str) -> Understood:
    """What the interpreter understands of a text; raises InterpretError where it is no English or tells nothing of a
    driving scene, InterpreterFault where the interpreter fails."""
    if not text.strip():
        raise InterpretError("The text is empty: describe a driving scene, for example “a car cuts in ahead of ego”.")
    if not is_english(text):
        raise InterpretError(NOT_ENGLISH)
    with faults():
        mended = NormalisedText(text[:READ_AT_MOST])
        scene = typologies.understand(mended.text)
        if not _has_scene(scene):
            raise InterpretError(
                "No driving scene was found in the text: name in English the vehicles or people, where they "
                "are and what they do."
            )
        scene.actors = scene.actors[:MOST_OBJECTS]
        found = Understood(text, mended, scene, accounted(scene, compose.compose(scene), mended.text))
        own = found.structure
        begun = {start for start, _ in own.clauses}
        whole = [n for n in (*own.not_understood, *own.background) if n.span and n.span[0] in begun]
        if _idle(scene) and whole:
            raise InterpretError(
                "This describes no driving scenario: name in English the vehicles or people, where they are and what "
                "they do."
            )
        return found


class EmbeddedInterpreter:
    """Reads driving scenarios by grammar and tables; no model is asked."""

    def interpret(self, text: str) -> Interpretation:
        """S of a text; raises as `understood`."""
        found = understood(text)
        with faults():
            structure = found.on_the_text(found.structure)
            stages = _spans_back(_stages(found.scene), found.mended)
            return Interpretation(
                structure, structure.not_understood, stages, found.scene.settings.confidences()
            )


def _on_original(structure: Structure, mended: NormalisedText, text: str) -> Structure:
    """The structure with its links, notes and clauses on the user's own text."""
    for component in structure.components:
        links = [li if li.span is None else back for li in component.links if (back := _back(li, mended, "label"))]
        own = {"links": tuple(links), "unmet": _notes(component.unmet, mended)}
        structure = structure.with_component(component.model_copy(update=own))
    missed = _notes(structure.not_understood, mended)
    if len(text) > READ_AT_MOST:
        rest = text[READ_AT_MOST : READ_AT_MOST + 200]
        reason = f"only the first {READ_AT_MOST} characters are read"
        missed += (Unmet(text=rest, reason=reason, span=(READ_AT_MOST, len(text))),)
    clauses = [(mended.back(start), mended.back(end)) for start, end in structure.clauses]
    update = {
        "text": text, "not_understood": missed, "background": _notes(structure.background, mended),
        "clauses": tuple(covering(text[:READ_AT_MOST], clauses)),
    }  # fmt: skip
    return structure.model_copy(update=update)


def _notes(notes: tuple[Unmet, ...], mended: NormalisedText) -> tuple[Unmet, ...]:
    return tuple(back for note in notes if (back := _back(note, mended, "text")))


def _back(found: Any, mended: NormalisedText, words: str) -> Any:
    """A link or note on the user's own text; None where it has no place there."""
    start, end = (mended.back(at) for at in found.span or (0, 0))
    if not start < end <= len(mended.original):
        return None
    return found.model_copy(update={"span": (start, end), words: mended.original[start:end]})


def _spans_back(value: Any, mended: NormalisedText) -> Any:
    if isinstance(value, dict):
        return {
            k: (mended.back(v[0]), mended.back(v[1])) if k == "span" and v else _spans_back(v, mended)
            for k, v in value.items()
        }
    return [_spans_back(v, mended) for v in value] if isinstance(value, list) else value


def _has_scene(found: Scene) -> bool:
    return bool(
        found.cast.ego.mentions
        or found.actors
        or found.clauses.events
        or found.road.kind
        or found.settings.weather
        or any(e.type in VEHICLES for e in found.cast.entities)
        or OF_THE_ROAD.search(found.plain) is not None
    )


def _idle(found: Scene) -> bool:
    """Whether nobody does anything, is anywhere or goes at a speed, and nothing is said of ego or the road."""
    acts = [e for e in found.clauses.events if e.act != "travel" or not STATES.match(e.text)]
    named = any(found.plain[m.start : m.end] not in ("i", "my", "me") for m in found.cast.ego.mentions)
    told = named or acts or found.speeds or found.road.kind or found.settings.weather
    placed = any(w.rel or w.lane or w.side or w.hidden_by or w.gap for w in found.places.of.values())
    return not told and not placed and OF_THE_ROAD.search(found.plain) is None


def _stages(found: Scene) -> dict[str, list[dict[str, Any]]]:
    """What each stage found, with spans in the text."""
    text = found.text
    return {
        "sentences": [{"text": text[s:e], "span": (s, e)} for s, e in found.sentences],
        "quantities": [
            {"text": text[s.start : s.end], "span": (s.start, s.end), **s.data}
            for s in found.spans
            if s.kind == "quantity"
        ],
        "actors": [
            {
                "key": e.key,
                "type": e.type,
                "count": e.count,
                "label": e.label,
                "roles": sorted(e.roles),
                "kept": e.ego or e in found.actors,
                "mentions": [text[m.start : m.end] for m in e.mentions],
                "span": (e.mentions[0].start, e.mentions[0].end) if e.mentions else None,
            }
            for e in [found.cast.ego, *found.cast.entities]
        ],
        "events": [
            {
                "agent": e.agent.key,
                "act": e.act,
                "hard": e.hard,
                "mode": e.mode,
                "patient": e.patient.key if e.patient else None,
                "order": round(e.order, 2),
                "trigger": e.trigger and {k: getattr(v, "key", v) for k, v in e.trigger.items()},
                "text": text[e.start : e.end],
                "span": (e.start, e.end),
            }
            for e in found.clauses.events
        ],
        "relations": [
            {
                "key": e.key,
                "rel": w.rel,
                "lane": w.lane,
                "side": w.side,
                "of": w.of.key if w.of else None,
                "gap": w.gap,
                "hidden_by": w.hidden_by.key if w.hidden_by else None,
            }
            for e, w in found.places.of.items()
            if w.rel or w.lane or w.side or w.hidden_by or w.gap
        ],
        "speeds": [{"key": e.key, "low": v[0], "high": v[1], "span": (v[2], v[3])} for e, v in found.speeds.items()],
        "road": [{k: v for k, v in vars(found.road).items() if v not in (None, False, {})}],
        "environment": [
            {"value": f.value, "confidence": f.confidence, "span": f.span, "text": text[f.span[0] : f.span[1]]}
            for f in (
                *found.settings.weather,
                *filter(None, (found.settings.time, found.settings.map, found.settings.preset)),
                *found.light,
            )
        ],
    }
