"""What a turn of the chat asks for: a question, a change of S, a new scenario, undo or redo.

Undo, questions and new scenarios are told apart by how they are put (data/language/turns.yaml); what is left is a
change, which the learned model reads, or one more description.
"""

import re
from dataclasses import dataclass, field
from typing import Any, Literal

from c2s_engine.interpret import language
from c2s_engine.interpret.english import NOT_ENGLISH, is_english
from c2s_engine.interpret.errors import faults
from c2s_engine.interpret.learned import ReaderError, read_change
from c2s_engine.interpret.learned.account import said_words
from c2s_engine.interpret.learned.change import SURE
from c2s_engine.interpret.learned.edits import after as after_edits
from c2s_engine.interpret.learned.edits import differences
from c2s_engine.interpret.mentions import mentions, names_ego
from c2s_engine.interpret.parser import parser
from c2s_engine.interpret.text import normalised, sentences
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, RemoveObject
from c2s_engine.structure.objects import object_types
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.stems import stems

TurnKind = Literal["question", "edit", "scenario", "undo", "redo"]

LONGEST_CHANGE = 60
"""Words of the longest text that is read as a change; longer ones are another description."""
TALE, ASIDE = 9, 14
"""Words of the shortest text that may be another description, and of the longest sentence that is tried as a change
though it may be one."""
DEFINITE = ("the", "this", "that", "these", "those")
"""Determiners of whom one knows already."""
OBJECTS = ("pobj", "dobj", "poss")
"""Dependencies of those to whom something is done, or of whom something is."""
THEN = " // "
"""What parts a change from its correction, as the model was trained."""


@dataclass(frozen=True)
class PreviousTurn:
    """The turn before: what was typed, and S as it was then."""

    text: str
    before: Structure


@dataclass(frozen=True)
class Turn:
    """How a text is taken: the edits that it asks for (empty where none was understood), and what to answer."""

    kind: TurnKind
    edits: list[Edit] = field(default_factory=list)
    reply: str = ""
    corrects: bool = False
    """Whether it does what the turn before did otherwise."""
    guessed: bool = False
    """Whether the model was not sure of it."""


def route(text: str, structure: Structure | None, last: PreviousTurn | None = None) -> Turn:
    """Decide what the text asks for, given the S at hand (None: there is none yet) and what was typed last;
    raises InterpreterFault."""
    if not is_english(text):
        return Turn("edit", reply=NOT_ENGLISH)
    plain = " ".join(normalised(text).split())
    with faults():
        kind = _kind(plain, structure)
        if kind == "nothing":
            return Turn("edit", reply="Say what the scene is, or what to change in it.")
        if kind != "edit" and kind != "wish":
            return Turn(kind)
        assert structure is not None
        try:
            found = _corrected(text, structure, last) or _change(text, structure)
        except ReaderError as error:
            return Turn("edit", reply=f"{error}. S can be changed in its pane, too.")
        if found is not None and not (found.guessed and _stands_alone(plain)):
            return found
        if kind == "wish":  # put as a question, it is one where it asks for no change
            return Turn("question")
        if _introduces(plain, structure) or _stands_alone(plain):
            return Turn("scenario")
        return Turn("edit", reply=_nobody(text, structure) or _not_understood(text))


def _change(text: str, structure: Structure) -> Turn | None:
    """The change that a text asks for; None where it asks for none. Raises ReaderError."""
    found = read_change(text, structure)
    if found is None or not found.edits:
        return None
    gone = [e.component for e in found.edits if isinstance(e, RemoveObject)]
    sure = found.likely >= SURE or all(_names(text, cid, structure) for cid in gone)
    if gone and not (sure and all(_speaks_of(text, structure[cid], structure) for cid in gone)):
        return Turn("edit", reply=_which(text, structure, gone))
    return Turn("edit", list(found.edits), found.words, guessed=found.likely < SURE)


def _corrected(text: str, structure: Structure, last: PreviousTurn | None) -> Turn | None:
    """The last change as a text that corrects it means it; None where it corrects nothing. Raises ReaderError."""
    if last is None or last.before.text != structure.text or not re.match(_table()["corrects"], normalised(text)):
        return None
    meant = _change(f"{last.text}{THEN}{text}", last.before)
    if meant is None:
        return None
    edits = differences(structure, after_edits(last.before, meant.edits))
    return Turn("edit", edits, meant.reply, corrects=True)


def _kind(plain: str, structure: Structure | None) -> Literal["nothing", "wish"] | TurnKind:
    if not plain:
        return "nothing"
    table = _table()
    if (back := _taken_back(plain)) is not None:
        return back
    if any(re.match(pattern, plain) for pattern in table["anew"]):
        return "scenario"
    wish = any(re.match(rf"^(?:please |and |so |ok,? )?(?:{pattern})", plain) for pattern in table["wishes"])
    if not wish and asks(plain):
        return "question"
    if structure is None or structure.blank:
        return "scenario"
    if _names_parties(plain, structure):
        return "scenario"
    aside = len(plain.split()) <= ASIDE and not re.search(r"[.;!?]\s*\S", plain)
    if len(plain.split()) > LONGEST_CHANGE or not (wish or aside) and _tells(plain, structure):
        return "scenario"
    return "wish" if wish else "edit"


def _table() -> Any:
    return language.table("turns")


def _taken_back(plain: str) -> Literal["undo", "redo"] | None:
    """Whether a text only takes back the last change, or does it again: by its words, where it names nobody and no
    number."""
    if len(plain.split()) > 20 or re.search(r"\d", plain) or mentions(plain):
        return None
    kinds: tuple[Literal["redo", "undo"], ...] = ("redo", "undo")
    return next((kind for kind in kinds if re.search(_table()[kind], plain)), None)


def asks(plain: str) -> bool:
    """Whether a text only asks; a demand behind the question ("why so slow? make it 50") makes it none."""
    parts = re.split(r"(?<=[.?!])\s+|(?<=\?)(?=\w)", re.sub(_table()["asking"]["tags"], "", plain))
    sentences = [said for part in parts if (said := part.strip(" .!"))]
    return bool(sentences) and all(map(_asks, sentences))


def _asks(sentence: str) -> bool:
    table = _table()
    sentence = re.sub(table["asking"]["before"], "", sentence)
    if re.search(table["asked_for"], sentence):
        return False
    if sentence.endswith("?") or any(re.match(pattern, sentence) for pattern in table["asking"]["shapes"]):
        return True
    return bool(re.match(table["question"], sentence)) and not re.match(
        r"(is|are|do|does|have|will)\b(?!.*\?)|.*\binstead\b", sentence
    )


def _introduces(plain: str, structure: Structure) -> bool:
    """Whether a text speaks at length of somebody new, of nobody who is there, and is no command."""
    table = _table()
    if len(plain.split()) < TALE or re.search(table["commands"], plain):
        return False
    named = mentions(plain)
    new = [m for m in named if re.search(table["introduces"], plain[: m.start])]
    types = [c.spec.type for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    known = [m for m in named if m not in new and not any(m.type == n.type for n in new if n.start < m.start)]
    return bool(new) and not any(m.fits(kind) for m in known for kind in types)


def _tells(plain: str, structure: Structure) -> bool:
    """Whether a text tells a scene of its own: of somebody new, and of what ego does or in several sentences."""
    if not _introduces(plain, structure):
        return False
    main = (t for t in parser()(plain) if t.dep_ in ("nsubj", "nsubjpass") and t.head.dep_ in ("ROOT", "conj", "ccomp"))
    return len(sentences(plain)) > 1 or any(names_ego(t.text) for t in main)


def _names_parties(plain: str, structure: Structure) -> bool:
    """Whether a text names two or more by labels, such as V1 and V2, that were not spoken of before."""
    said = normalised(structure.text)
    named = {re.sub(r"\W", "", match[0]) for match in re.finditer(_table()["parties"], plain) if match[0] not in said}
    return len(named) > 1 and len(sentences(plain)) > 1


def _stands_alone(plain: str) -> bool:
    """Whether a text tells of ego and others as nobody does of whom another knows: with no definite noun for somebody
    who was not spoken of before, and as no command."""
    if len(plain.split()) < TALE or re.search(_table()["commands"], plain):
        return False
    words, named = parser()(plain), mentions(plain)
    if not named or not any(names_ego(t.text) and t.dep_ not in OBJECTS for t in words):
        return False
    for number, m in enumerate(named):
        span = words.char_span(m.start, m.end, alignment_mode="expand")
        before = reversed(list(words[: span.start])) if span is not None else ()
        told = next((t for t in before if t.pos_ not in ("ADJ", "NUM", "NOUN", "PROPN")), None)  # "the old van"
        known = told is not None and (told.dep_ == "poss" or told.lower_ in DEFINITE or told.tag_ in ("PRP$", "POS"))
        if known and not any({m.type, n.type} & {"vehicle"} or m.type == n.type for n in named[:number]):
            return False
    return True


def _names(text: str, cid: str, structure: Structure) -> bool:
    """Whether a text names one object: by its id, or by a noun that no other one of S can be meant by."""
    kinds = {c.id: c.spec.type for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    alone = ({c for c, kind in kinds.items() if m.fits(kind)} == {cid} for m in mentions(text))
    return bool(re.search(rf"\b{cid}\b", text, re.IGNORECASE)) or any(alone)


def _speaks_of(text: str, component: Component, structure: Structure) -> bool:
    """Whether a text may speak of an object: by its id, by a noun for it or another of its words, or by no noun at all,
    where that is the only one ("delete it") or is told from the others ("remove the second one")."""
    spec = component.spec
    assert isinstance(spec, ObjectSpec)
    if re.search(rf"\b{component.id}\b", text, re.IGNORECASE):
        return True
    own = {*said_words(component, structure), *stems(spec.name.replace("_", " "))}
    own |= {stem for link in component.links for stem in stems(link.label)}
    called = any(m.fits(spec.type) or m.type == "vehicle" for m in mentions(text))
    words = parser()(text)
    noun = any(t.pos_ in ("NOUN", "PROPN") and t.lower_ not in ("one", "ones") for t in words)
    told = _removes(text) and not any(t.tag_ == "PRP" for t in words)
    return called or bool(own & stems(text)) or not noun and (len(structure.objects) == 1 or told)


def _removes(text: str) -> bool:
    """Whether a text has a word by which something is to be gone."""
    return bool(set(re.findall(r"[a-z]+", normalised(text))) & set(language.table("trade")["removes"]))


def _which(text: str, structure: Structure, meant: list[str]) -> str:
    """The question which of the objects is to be removed, where it is not plain which are meant."""
    there = "; ".join(f"{c.id}: {c.description.rstrip('.')}" for c in structure.objects)
    example = f"“remove {' and '.join(meant)}”"
    return (f"Which one is to be removed? “{text.strip()[:80]}” names none of them plainly: say for example {example}; "
            f"of weather, lights and roads say what is to be there instead. There are: {there}.")


def _nobody(text: str, structure: Structure) -> str:
    """The answer to a removal of somebody who is not there; "" where it is none."""
    there = object_types(structure)
    missing = [text[m.start : m.end] for m in mentions(text) if not any(map(m.fits, there))]
    return f"There is no {missing[0]} in the scene: nothing was removed." if missing and _removes(text) else ""


def _not_understood(text: str) -> str:
    """The answer to a change that is not understood, with what would do."""
    how = "name in English what is to change and how, such as “make the lead a truck”"
    anew = "; put “New scenario:” before a description of another scene" if len(text.split()) >= TALE else ""
    return f"I did not understand “{text.strip()[:80]}” as a change: {how}{anew}."
