"""The embedded interpreter: text to S by rules over a parsed text, without a language model."""

import re
from dataclasses import dataclass, field, replace
from typing import Any

from c2s_engine.interpret import typologies
from c2s_engine.interpret.composing import compose, unmet
from c2s_engine.interpret.entities import VEHICLES
from c2s_engine.interpret.reading.division import sentences
from c2s_engine.interpret.reading.spelling import Mended
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.components import Structure, Unmet

OF_THE_ROAD = re.compile(
    r"\b(?:lanes?|kerb|curb|brak(?:es?|ed|ing)|skid(?:s|ded|ding)?|swerv(?:es?|ed|ing)|junction|intersection|motorway"
    r"|highway|overtak\w+|rear-end\w*|wing mirror|bumper|fender|drove|driving|hit and run|side-?swip\w+|t-?bon\w+)\b"
)
"""Words that only tales of the road have: what else they tell may be unknown, a scene it is."""

READ_AT_MOST = 12_000
"""Characters of a text that are read; the rest is listed as not understood."""


class InterpretError(ValueError):
    """A text that no scenario can be read from; the message says what would do."""


@dataclass(frozen=True)
class Interpretation:
    """S as read from a text, with what every stage found."""

    structure: Structure
    not_understood: tuple[Unmet, ...] = ()
    stages: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    confidences: dict[str, float] = field(default_factory=dict)


class EmbeddedInterpreter:
    """Reads driving scenarios by grammar and tables; no model is asked."""

    def interpret(self, text: str, structure: Structure | None = None) -> Interpretation:
        """S of a text; raises InterpretError where nothing of a driving scene is said."""
        del structure
        if not text.strip():
            raise InterpretError(
                "The text is empty: describe a driving scene, for example “a car cuts in ahead of ego”."
            )
        try:
            return self._read(text)
        except InterpretError:
            raise
        except Exception as error:  # any text gives S or a sentence, never a traceback
            without = self._without_one(text)
            if without is not None:
                return without
            raise InterpretError(
                f"This text defeats the embedded interpreter ({type(error).__name__}): say it in shorter, "
                f"plainer sentences."
            ) from error

    def _without_one(self, text: str) -> Interpretation | None:
        """What a text says without the last of its sentences that the reader fails at; None if it fails without any."""
        for start, end in reversed(sentences(text)):
            try:
                rest = self._read(text[:start] + " " * (end - start) + text[end:])
            except Exception:  # then it is another sentence
                continue
            left_out = Unmet(
                text=text[start:end], reason="this sentence could not be read beside the others", span=(start, end)
            )
            missed = (*rest.not_understood, left_out)
            structure = rest.structure.model_copy(update={"text": text, "not_understood": missed})
            return replace(rest, structure=structure, not_understood=missed)
        return None

    def _read(self, text: str) -> Interpretation:
        mended = Mended(text[:READ_AT_MOST])
        understood = typologies.understand(mended.text)
        if not _has_scene(understood):
            raise InterpretError(
                "Nothing in the text tells of a driving scene: name the vehicles or people, where they "
                "are and what they do."
            )
        result = compose.compose(understood)
        missed = _missed(understood, text, mended)
        result = _on_original(result, mended)
        result = result.model_copy(update={"text": text, "not_understood": tuple(missed)})
        return Interpretation(
            result, tuple(missed), _spans_back(_stages(understood), mended), understood.settings.confidences()
        )


def _on_original(structure: Structure, mended: Mended) -> Structure:
    """The structure with its links and notes on the user's own text."""
    for component in structure.components:
        notes = []
        for note in component.unmet:
            first, last = (mended.back(at) for at in note.span or (0, 0))
            if first < last <= len(mended.original):
                notes.append(note.model_copy(update={"span": (first, last), "text": mended.original[first:last]}))
        component = component.model_copy(update={"unmet": tuple(notes)})
        links = []
        for link in component.links:
            if link.span is not None and link.kind == "text":
                start, end = mended.back(link.span[0]), mended.back(link.span[1])
                if start >= end or start >= len(mended.original):
                    continue
                link = link.model_copy(update={"span": (start, end), "label": mended.original[start:end]})
            links.append(link)
        structure = structure.with_component(component.model_copy(update={"links": tuple(links)}))
    return structure


def _spans_back(value: Any, mended: Mended) -> Any:
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


def _missed(found: Scene, text: str, mended: Mended) -> list[Unmet]:
    """Sentences that no component took up."""
    taken: list[tuple[int, int]] = [(m.start, m.end) for e in [found.cast.ego, *found.actors] for m in e.mentions]
    taken += [(found.words[e.word].start, found.words[e.word].end) for e in found.clauses.events]
    taken += [f.span for f in (*found.settings.weather, *found.light)] + list(found.road.spans.values())
    taken += [
        f.span for f in (found.settings.time, found.settings.map, found.settings.preset, found.settings.ego_model) if f
    ]
    taken += [(s.start, s.end) for s in found.spans if s.kind == "quantity"]
    taken += [u.note.span for u in unmet.find(found) if u.note.span]
    if type_named := typologies.named(mended.text):
        first, last = type_named[2]
        taken += [(max(s, first), min(e, last)) for s, e in found.sentences if s < last and first < e]
    missed = []
    for start, end in found.sentences:
        if not any(start <= s and e <= end for s, e in taken):
            first, last = mended.back(start), mended.back(end)
            if first < last:
                missed.append(
                    Unmet(
                        text=text[first:last],
                        reason="nothing of it belongs to a driving scene that the specs can say",
                        span=(first, last),
                    )
                )
    if len(text) > READ_AT_MOST:
        missed.append(
            Unmet(
                text=text[READ_AT_MOST : READ_AT_MOST + 200],
                reason=f"only the first {READ_AT_MOST} characters are read",
                span=(READ_AT_MOST, len(text)),
            )
        )
    return missed


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
