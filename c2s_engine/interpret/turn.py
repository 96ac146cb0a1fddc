"""What a turn of the chat asks for: a question, an edit of S, a new scenario, undo or redo. No model."""

import re
from dataclasses import dataclass, field
from typing import Literal

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import asked, notes, pointed, put, refine, scene_context
from c2s_engine.interpret.changes.corrected import PreviousTurn, after, corrected, differences, of_the_same
from c2s_engine.interpret.changes.forms import ALREADY
from c2s_engine.interpret.changes.kept import removed
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.changes.unmatched_details import unmatched_details
from c2s_engine.interpret.embedded import NOT_ENGLISH, faults
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.reading.english import is_english
from c2s_engine.interpret.reading.spelling import NormalisedText
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, Edit, SetField
from c2s_engine.structure.quantity import ends, in_words
from c2s_engine.structure.specs import ObjectSpec

TurnKind = Literal["question", "edit", "scenario", "undo", "redo"]


MAP = re.compile(r"^(?:\w+ )?(?:use|take|load|set|change|switch)\b.{0,12}\bmap\b")
"""That another map is to be used."""


@dataclass(frozen=True)
class Turn:
    """How a text is taken: the edits that it asks for (empty where none was understood), and what to answer."""

    kind: TurnKind
    edits: list[Edit] = field(default_factory=list)
    reply: str = ""
    span: tuple[int, int] | None = None
    corrects: bool = False
    """Whether it does what the turn before did otherwise."""


def route(text: str, structure: Structure | None, last: PreviousTurn | None = None) -> Turn:
    """Decide what the text asks for, given the S at hand (None: there is none yet) and what was typed last;
    raises InterpreterFault."""
    if not is_english(text):
        return Turn("edit", reply=NOT_ENGLISH, span=(0, len(text)))
    with faults():
        again = _again(text, structure, last) if structure is not None and last is not None else None
        return again or _route(text, structure)


def _again(text: str, structure: Structure, last: PreviousTurn) -> Turn | None:
    """The turn where the text corrects the last one: that is taken back, and done as it was meant."""
    plain = " ".join(scan.normalised(text).rstrip("?!. ").split())
    meant = corrected(plain, structure, last) if len(plain.split()) < 16 else None
    whole = (0, len(text))
    if meant is None:
        who, said = of_the_same(plain, structure, last) or ("", "")
        turn = _route(said, structure) if who else None
        mine = turn is not None and turn.edits and {getattr(e, "component", "") for e in turn.edits} == {who}
        return Turn("edit", turn.edits, turn.reply, whole, corrects=True) if turn is not None and mine else None
    if meant.upon is None:
        return Turn("edit", reply=_not_understood(text, meant.why), span=whole)
    turn = _route(meant.text, meant.upon)
    if turn.kind != "edit" or not turn.edits:
        return None
    edits = differences(structure, after(meant.upon, turn.edits))
    return Turn("edit", edits, turn.reply, whole, corrects=True) if edits else None


def _route(text: str, structure: Structure | None) -> Turn:
    table, typed = language.table("refine"), text
    for find, new in language.table("turns")["hurried"]:
        text = re.sub(find, new, text, flags=re.IGNORECASE)
    text = re.sub(table["both_ways"], r"swap \1 and \2", text)
    text = NormalisedText(re.sub(table["arrows"], " becomes ", text), scene=False).text
    text = re.sub(table["lines"], ". ", text.strip())
    plain = " ".join(scan.normalised(text).split())
    whole = (0, len(typed))
    if not plain:
        return Turn("edit", reply="Say what the scene is, or what to change in it.", span=whole)
    if (back := _taken_back(plain)) is not None:
        return Turn(back, span=whole)
    if _anew(plain):
        return Turn("scenario", span=whole)
    if structure is not None and structure.objects and (nobody := pointed.missing(plain, structure)):
        return Turn("edit", reply=_not_understood(typed, pointed.absent(nobody, structure)), span=whole)
    before = plain
    plain = put.plainly(plain, structure) if structure is not None else plain
    if structure is not None and (edits_said := _wished(plain, structure)):
        return Turn("edit", *edits_said, whole)
    if asked.asks(plain):
        return Turn("question", span=whole)
    if structure is None or structure.blank:
        return Turn("scenario", span=whole)
    demanded = asked.demanded(plain)
    plain = notes.text_of(demanded, structure)
    commanding = bool(re.match(table["commands"], plain)) or bool(re.search(table["marks"], plain))
    another = _of_others(plain, structure)
    if another and (
        len(plain.split()) > 45
        or _tells(plain, commanding)
        and not _adds(plain, structure)
        and not _goes_on(plain, structure)
    ):
        return Turn("scenario", span=whole)
    edits, said = refine.edits_of(demanded, structure, before)
    stranger = pointed.nobody(demanded, structure)
    if stranger and edits and not any(isinstance(e, AddObject) for e in edits):
        return Turn("edit", reply=_not_understood(typed, pointed.absent(stranger, structure)), span=whole)
    already = bool(said) and all(s.startswith(ALREADY) for s in said)
    idle = already or edits and _same_specs(structure, after(structure, edits))
    if idle and (lost := unmatched_details(plain, structure)):
        why = f"it is not clear what {' and '.join(f'“{words}”' for words in lost)} changes"
        return Turn("edit", reply=_not_understood(typed, why), span=whole)
    if edits:
        return Turn("edit", edits, _in_words(edits, said, structure), whole)
    if already:
        return Turn("edit", reply=f"Nothing was changed: {'; '.join(said)}.", span=whole)
    if said:
        return Turn("edit", reply=_not_understood(typed, "; ".join(said)), span=whole)
    if re.search(MAP, plain):
        how = "a map that is at hand is chosen with /map NAME, a town of CARLA's by its name (“use Town05”)"
        return Turn("edit", reply=_not_understood(typed, how), span=whole)
    short = len(plain.split()) < 9 and not re.search(r"[.;] \w", plain)
    told_of_here = not _of_strangers(plain, structure) or _of_those_there(plain, structure)
    if commanding or short or not another or told_of_here:
        why = pointed.absent(stranger, structure) if stranger else ""
        return Turn("edit", reply=_not_understood(typed, why), span=whole)
    return Turn("scenario", span=whole)


def _wished(plain: str, structure: Structure) -> tuple[list[Edit], str] | None:
    """The edits, and what they do, of a demand that is put as a question, with those behind it."""
    head, mark, rest = plain.partition("? ")
    if mark and asked.asks(rest):
        return None
    asks = head + mark.strip()
    for wish in (put.questioned(asks, structure), asked.requested(asks), asked.supposed(asks)):
        demand = f"{wish.rstrip('?. ')}. {rest}" if rest else wish
        edits, said = refine.edits_of(put.plainly(demand, structure), structure) if wish else ([], [])
        if edits:
            return edits, _in_words(edits, said, structure)
    return None


def _same_specs(one: Structure, other: Structure) -> bool:
    return [(c.id, c.spec) for c in one.components] == [(c.id, c.spec) for c in other.components]


def _in_words(edits: list[Edit], said: list[str], structure: Structure) -> str:
    """What edits do, and what they take away."""
    gone = removed(structure, edits)
    return "; ".join([*said, *_gaps_before(edits, said, structure), *([gone] if gone else [])])


def _gaps_before(edits: list[Edit], said: list[str], structure: Structure) -> list[str]:
    """Of gaps at the start that S says otherwise so far: that it is these that change, and what they were."""
    if any(" -> " in words for words in said):
        return []
    told = []
    for edit in edits:
        spec = structure[edit.component].spec if isinstance(edit, SetField) and edit.component in structure else None
        if isinstance(spec, ObjectSpec) and isinstance(edit, SetField) and edit.path == "placement.gap":
            was = spec.placement.gap
            if was is not None and edit.value is not None and ends(was) != ends(edit.value):
                told.append(f"that is the gap at the start of {edit.component}, which was {in_words('gap', was)}")
    return told


def _not_understood(text: str, why: str = "") -> str:
    """The answer to a change that is not understood, or that cannot be made, with what would do."""
    how = why or "name in English what is to change and how, such as “make the lead a truck”"
    return f"I did not understand “{text.strip()[:80]}” as a change{' that can be made' if why else ''}: {how}."


def _anew(plain: str) -> bool:
    """Whether a text says that a new scenario follows."""
    return any(re.match(pattern, plain) for pattern in language.table("refine")["anew"])


def _taken_back(plain: str) -> Literal["undo", "redo"] | None:
    """Whether a text only takes back the last change, or does it again."""
    if len(plain.split()) > 20:
        return None
    table = language.table("refine")["taking_back"]
    behind = rf"{table['behind']}(?:{table['reason']})?[ .!]*"
    kinds: tuple[Literal["redo", "undo"], ...] = ("redo", "undo")
    for kind in kinds:
        if any(re.fullmatch(rf"{table['before']}(?:{said}){behind}", plain) for said in table[kind]):
            return kind
    return None


def _introduces(plain: str) -> bool:
    """Whether somebody is told of for the first time ("a car", "two cyclists"), not only become or replaced."""
    new = language.table("refine")["introduces"]
    return any(s.kind == "actor" and re.search(new, plain[: s.start]) for s in scan.names(plain))


def _of_others(plain: str, structure: Structure) -> bool:
    """Whether a text can be another description: it names nobody who is there, or tells at length of new ones first."""
    table = language.table("refine")
    sentences = len(re.split(r"[.;] (?=\w)", plain))
    new: set[str] = set()
    old: list[int] = []
    first = len(plain)
    for span in scan.names(plain):
        noun = span.data.get("noun", "")
        introduced = bool(re.search(table["introduces"], plain[: span.start]))
        if span.kind == "label" and re.match(r",? (?:which (?:is|was) )?an? ", plain[span.end :]):
            introduced = True  # "V2, a pickup"
        if span.kind == "ego" or noun in new:
            continue
        if introduced:
            new |= {noun, plain[span.start : span.end]}
            first = min(first, span.start)
        elif plain[span.start : span.end] not in new:
            meant = refer(f"the {plain[span.start : span.end]}", structure, alone=False)
            old += [span.start] if meant is not None and meant.id != "E" else []
    if not old:
        return True
    return bool(new) and (sentences > 2 or sentences > 1 and first < old[0])


def _of_strangers(plain: str, structure: Structure) -> bool:
    """Whether a text tells of somebody who is not there."""
    labels = [s for s in scan.names(plain) if s.kind == "label"]
    return _introduces(plain) or any(refer(plain[s.start : s.end], structure, alone=False) is None for s in labels)


def _of_those_there(plain: str, structure: Structure) -> bool:
    """Whether a text speaks only of those who are there."""
    names = [s for s in scan.names(plain) if s.kind in ("actor", "ego")]
    meant = [refer(plain[s.start : s.end], structure, alone=False) for s in names]
    return any(meant) and not _introduces(plain)


def _adds(plain: str, structure: Structure) -> bool:
    """Whether a text only tells of somebody new in the scene that is there."""
    table = language.table("refine")["told"]
    apart = re.sub(table["meanwhile"], " ", plain)
    return bool(re.match(table["adds"], plain)) and not scene_context.tells_ego(apart, structure)


def _goes_on(plain: str, structure: Structure) -> bool:
    """Whether one sentence tells more of one who is there: "the police car is chasing a red sports car"."""
    if re.match(r"(?:an?|one|two|another|some) ", plain) or re.search(r"[.;] \w", plain) or len(plain.split()) > 25:
        return False
    first = next((s for s in scan.names(plain) if s.kind == "actor"), None)
    return first is not None and first.start < 20 and refer(plain[: first.end], structure, alone=False) is not None


def _commands(sentence: str) -> bool:
    """Whether a sentence is an order, or goes on about whom the one before was about."""
    commands = language.table("refine")["commands"]
    return bool(
        re.match(commands, sentence) or re.match(r"(?:and |then |so )?(?:it|they|he|she|this|that)\b", sentence)
    )


def _tells(plain: str, commanding: bool) -> bool:
    """Whether a text tells a scene of its own: ego and another, doing something, at length, and no command."""
    if re.search(language.table("refine")["ordered"], plain):
        return False
    opens = re.match(
        r"(an?|two|three|the ego|ego|the vehicle|on|at|in|while|when|during|night|day|it is|vehicle|unit|v)\b", plain
    )
    if (
        opens
        and len(plain.split()) >= 9
        and _introduces(plain)
        and len({s.kind for s in scan.names(plain)}) + len(scan.names(plain)) >= 4
        and not re.match(r"^(the |ego )?\w* ?(should|must)\b", plain)
        and not re.search(language.table("refine")["not_anew"], plain)
    ):
        return True
    sentences = re.split(r"[.;] (?=\w)", plain)
    if commanding and (len(sentences) < 3 or all(map(_commands, sentences))):
        return False
    if len(plain.split()) < 25 and re.search(language.table("refine")["of_those_there"], plain):
        return False
    words = len(plain.split())
    if words >= 9 and any(s.kind == "label" for s in scan.names(plain)) and not commanding:
        return True
    names = [s for s in scan.names(plain) if s.kind in ("actor", "ego", "label")]
    new = language.table("refine")["introduces"]
    if not any(s.data.get("type") in MOVERS for s in names if re.search(new, plain[: s.start])):
        return False  # only a thing at the road is new
    return (
        words >= 9
        and (len(names) >= 2 or words >= 14)
        and _introduces(plain)
        and not re.match(r"(at|in|on|with|without|during) (the )?\w+[.! ]*$", plain)
    )
