"""Clauses that did not become part of S: background, or not understood, each with the reason.

A clause is understood where something in it did: a deed, a speed, the road, weather, light; or where it only says that
somebody is there whom S has. What the road or the settings would lose without it is theirs, too. A verb in it that says
what somebody of S does, and led to nothing in S, is lost with what goes with it.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from c2s_engine.interpret import language, typologies
from c2s_engine.interpret.accounting.clauses import of_sentences, span_of
from c2s_engine.interpret.accounting.links import linked, missing_actions, owners, unmatched_values
from c2s_engine.interpret.accounting.starts import with_unresolved_start_phrases
from c2s_engine.interpret.accounting.verbs import BARE, UnaccountedVerbs
from c2s_engine.interpret.reading.dates import WHEN
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.surroundings import environment, place
from c2s_engine.interpret.surroundings.settings import Settings, SettingsDetector
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.account import is_set
from c2s_engine.structure.components import Component, Link, Structure, Unmet

Span = tuple[int, int]

STRANGE = "“{}” was not read as something that a road user does"
NOTHING = "it contains nothing of a driving scene that S can express"
UNREAL = "described as a possibility, plan or consequence, not as part of the scene"
NO_STEP = "read as “{}”, which {} does not do in S"
NO_VALUE = "no field of S has the value {}"
HEADING = "a heading or a label"
LABEL_WORDS = 4


@dataclass(frozen=True)
class _Lost:
    background: bool
    reason: str


def accounted(scene: Scene, structure: Structure, text: str) -> Structure:
    """S with its links, clauses, background and what was not understood, in offsets of the text that was read (the
    scene of a named crash type holds another text, or more of it)."""
    named = typologies.named(text)
    if named and not scene.text.startswith(text[: named[2][0]]) or named and len(scene.text) < len(text):
        return _by_name(structure, text, named[2])
    return _Account(scene, linked(scene, structure), text, named[2] if named else None).made()


def accounted_for_given_structure(scene: Scene, structure: Structure, text: str) -> Structure:
    """The same of an S that was not made of the scene: what the interpreter's grammar does not know may be in that, so
    that a clause is lost only where it has a value that no field holds, or bounds that T does not have."""
    structure = linked(scene, structure)
    for component in structure.components[:-1]:
        links = [_of_set_fields(component, li) for li in component.links]
        structure = structure.with_component(component.model_copy(update={"links": tuple(links)}))
    return _AsRead(scene, structure, text, None).made()


def _of_set_fields(component: Component, link: Link) -> Link:
    """The link, of no field where the component does not have what the interpreter would have made of the words."""
    return link if not link.field or is_set(component.spec, link.field) else link.model_copy(update={"field": ""})


def _by_name(structure: Structure, text: str, span: Span) -> Structure:
    """All of S rests on the name of a crash type."""
    link = Link(kind="text", label=text[slice(*span)], span=span)
    for component in structure.components:
        structure = structure.with_component(component.model_copy(update={"links": (link,)}))
    return structure


class _Account:
    def __init__(self, scene: Scene, structure: Structure, text: str, named: Span | None) -> None:
        self.scene, self.structure, self.text, self.named = scene, structure, text, named
        self.owners = owners(scene, structure)
        self.events: dict[int, list[Event]] = {}
        for event in scene.clauses.events:
            self.events.setdefault(event.word, []).append(event)
        self.known = {i for i, e in scene.cast.of.items() if e in self.owners}
        self.known |= {m.word for e in self.owners for m in e.mentions}
        self.spans = [li.span for c in structure.components for li in c.links if li.span and li.field]
        self.spans += [li.span for li in structure.place.links if li.span]
        self.notes = [u.span for c in structure.components for u in c.unmet if u.span]
        self.unaccounted = UnaccountedVerbs(scene, self.known)
        self.quantities = [(s.start, s.end) for s in scene.spans if s.kind == "quantity"]

    def made(self) -> Structure:
        clauses: list[Span] = []
        background: list[Unmet] = []
        missed: list[Unmet] = []
        for sentence in of_sentences(self.scene, len(self.text)):
            spans = [span_of(words) for words in sentence]
            clauses += spans
            lost = [self._lost(words) for words in sentence]
            for span, reason in self._together(spans, lost):
                note = Unmet(text=self.scene.text[slice(*span)], reason=reason.reason, span=span)
                (background if reason.background else missed).append(note)
            missed += self._left_out([s for s, n in zip(spans, lost, strict=True) if n is None])
            missed += self._verb_notes([w for w, n in zip(sentence, lost, strict=True) if n is None], missed)
            if not all(lost):
                self._attach([s for s, n in zip(spans, lost, strict=True) if n is None])
        update = {"clauses": tuple(clauses), "background": tuple(background), "not_understood": tuple(missed)}
        structure = self.structure.model_copy(update=update)
        return with_unresolved_start_phrases(self.scene, structure, [n.span for n in missed if n.span])

    def _together(self, spans: list[Span], lost: list[_Lost | None]) -> list[tuple[Span, _Lost]]:
        """A sentence of which nothing is left is one note."""
        told = [(s, n) for s, n in zip(spans, lost, strict=True) if n is not None]
        if len(told) == len(spans) > 1 and len({n.background for _, n in told}) == 1:
            reasons = dict.fromkeys(n.reason for _, n in told)
            first = told[0][1]
            whole = replace(first, reason="; ".join(reasons) if first.background else NOTHING)
            return [((spans[0][0], max(e for _, e in spans)), whole)]
        return told

    def _left_out(self, spans: list[Span]) -> list[Unmet]:
        """What was read in clauses that otherwise became part of S, and S does not have: deeds and values."""
        text, notes = self.scene.text, []
        for event, cid in missing_actions(self.scene, self.structure):
            word = self.scene.words[event.word]
            at = (word.start, word.end)
            notes.append(Unmet(text=text[slice(*at)], reason=NO_STEP.format(event.act.replace("_", " "), cid), span=at))
        notes += self._value_notes()
        return [n for n in notes if n.span and _meets(n.span, spans) and not _meets(n.span, self.notes)]

    def _value_notes(self) -> list[Unmet]:
        """Values of the text that no field has."""
        values = [(self.scene.text[slice(*at)], at) for at in unmatched_values(self.scene, self.structure)]
        return [Unmet(text=words, reason=NO_VALUE.format(words), span=at) for words, at in values]

    def _verb_notes(self, clauses: list[list[Word]], missed: list[Unmet]) -> list[Unmet]:
        """Verbs with what goes with them that led to nothing in S, though their clause is in it by other words."""
        known = [n.span for n in missed if n.span]
        notes = []
        for words in clauses:
            if _topic(words, named=True):
                continue
            for verb, span in self.unaccounted.in_clause(words):
                if not _meets((verb.start, verb.end), [*self.spans, *self.notes, *known]):
                    reason = STRANGE.format(verb.text)
                    notes.append(Unmet(text=self.scene.text[slice(*span)], reason=reason, span=span))
        return notes

    def _attach(self, understood: list[Span]) -> None:
        """A clause that was understood with no words of it linked yet is the component's that was spoken of last."""
        links = [(li.span, c.id) for c in self.structure.components for li in c.links if li.span]
        for span in understood:
            if _meets(span, [s for s, _ in links]) or _meets(span, self.notes):
                continue
            before = [(s, cid) for s, cid in links if s[0] < span[1]]
            cid = max(before)[1] if before and not self._of_place(span) else "R"
            link = Link(kind="text", label=self.scene.text[slice(*span)], span=span)
            component = self.structure[cid]
            self.structure = self.structure.with_component(
                component.model_copy(update={"links": (*component.links, link)})
            )

    def _lost(self, words: list[Word]) -> _Lost | None:
        """Why a clause did not become part of S; None where it did."""
        span = span_of(words)
        own = [e for w in words for e in self.events.get(w.i, [])]
        if any(e.done or e.mode == "negated" for e in own) or self.named and _meets(span, [self.named]):
            return None
        if _meets(span, self.spans) or _meets(span, self.notes):
            return None
        named = any(w.i in self.known for w in words)
        if reason := _topic(words, named):
            return _Lost(True, reason)
        if own:
            return _Lost(True, UNREAL)
        if _meets(span, self.quantities):
            return None
        verbs = [w for w in words if w.tag.startswith("VB") and w.dep not in ("aux", "auxpass", "amod", "compound")]
        light = self.scene.clauses.light
        strange = [w for w in verbs if w.lemma not in BARE and w.i not in light and w.i not in self.known]
        if named and not strange or self._of_place(span):
            return None
        if aside := self._aside(span, bool(verbs), len(words)):
            return aside
        return _Lost(False, STRANGE.format(strange[0].text) if strange and named else NOTHING)

    def _aside(self, span: Span, verbs: bool, words: int) -> _Lost | None:
        """Why a clause is no part of a scene by its form: a date, a heading, a number of a list."""
        plain = self.scene.plain[slice(*span)].strip(" ,.")
        if WHEN.fullmatch(plain):
            return _Lost(True, "when it was is no part of a scenario")
        if not verbs and words <= LABEL_WORDS and self.scene.text[span[1] :].lstrip()[:1] == ":":
            return _Lost(True, HEADING)
        return None if any(ch.isalpha() for ch in plain) else _Lost(True, HEADING)

    def _of_place(self, span: Span) -> bool:
        """Whether the road, the weather or the light would be read otherwise without the clause."""
        plain = self.scene.plain
        without = plain[: span[0]] + " " * (span[1] - span[0]) + plain[span[1] :]
        sentences = self.scene.sentences
        quantities = [s for s in self.scene.spans if s.kind == "quantity" and not _meets((s.start, s.end), [span])]
        road = place.read(without, sentences, quantities)
        if replace(road, spans={}) != replace(self.scene.road, spans={}):
            return True
        if _sky(SettingsDetector().detect(without, sentences)) != _sky(self.scene.settings):
            return True
        return len(environment.light(without, sentences)) != len(self.scene.light)


class _AsRead(_Account):
    """The account of an S that was read otherwise."""

    def _lost(self, words: list[Word]) -> _Lost | None:
        span = span_of(words)
        if _meets(span, self.spans) or _meets(span, self.notes) or _meets(span, self.quantities):
            return None
        if reason := _topic(words, named=any(w.i in self.known for w in words)):
            return _Lost(True, reason)
        return self._aside(span, any(w.tag.startswith("VB") for w in words), len(words))

    def _left_out(self, spans: list[Span]) -> list[Unmet]:
        return [n for n in self._value_notes() if n.span and _meets(n.span, spans) and not _meets(n.span, self.notes)]

    def _verb_notes(self, clauses: list[list[Word]], missed: list[Unmet]) -> list[Unmet]:
        return []


def _sky(found: Settings) -> tuple[list[str], str | None]:
    return [f.value for f in found.weather], found.time.value if found.time else None


def _topic(words: list[Word], named: bool) -> str:
    """Why a clause is background by what it is about; empty where it is about nothing of the kind."""
    said = {form for w in words for form in (w.lemma, w.norm)}
    for topic in language.table("background").values():
        if said & set(topic["words"]) or not named and said & set(topic["about"]):
            return topic["reason"]
    return ""


def _meets(span: Span, others: Iterable[Span]) -> bool:
    return any(s < span[1] and span[0] < e for s, e in others)
