"""What a turn of the chat asks for: a question, an edit of S, a new scenario, undo or redo. No model."""

import re
from dataclasses import dataclass, field
from typing import Literal

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import refine, retold
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.reading.spelling import Mended
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import Edit

TurnKind = Literal["question", "edit", "scenario", "undo", "redo"]


@dataclass(frozen=True)
class Turn:
    """How a text is taken: the edits that it asks for (empty where none was understood), and what to answer."""

    kind: TurnKind
    edits: list[Edit] = field(default_factory=list)
    reply: str = ""
    span: tuple[int, int] | None = None


def route(text: str, structure: Structure | None) -> Turn:
    """Decide what the text asks for, given the S at hand (None: there is none yet)."""
    try:
        return _route(text, structure)
    except Exception as error:  # any text gives a turn, never a traceback
        reply = (
            f"This text defeats the embedded interpreter ({type(error).__name__}): say it in shorter, plainer words."
        )
        return Turn("edit", reply=reply, span=(0, len(text)))


def _route(text: str, structure: Structure | None) -> Turn:
    table = language.table("refine")
    text = Mended(re.sub(table["arrows"], " becomes ", text), scene=False).text
    plain = " ".join(scan.normalised(text).split())
    whole = (0, len(text))
    if not plain:
        return Turn("edit", reply="Say what the scene is, or what to change in it.", span=whole)
    if (back := _taken_back(plain)) is not None:
        return Turn(back, span=whole)
    if structure is not None and (asked := _requested(plain) or _supposed(plain)):
        edits, said = refine.edits_of(asked, structure)
        if edits:
            return Turn("edit", edits, "; ".join(said), whole)
    if _asks(plain, table):
        return Turn("question", span=whole)
    if structure is None or not structure.text and not structure.objects:
        return Turn("scenario", span=whole)
    commanding = bool(re.match(table["commands"], plain)) or bool(re.search(table["marks"], plain))
    if len(plain.split()) > 45 or _tells(plain, commanding) and not _adds(plain) and not _goes_on(plain, structure):
        return Turn("scenario", span=whole)
    edits, said = refine.edits_of(text, structure)
    if edits:
        return Turn("edit", edits, "; ".join(said), whole)
    if commanding or len(plain.split()) < 5 or _of_those_there(plain, structure):
        return Turn(
            "edit",
            [],
            (
                f"I did not understand “{text.strip()[:80]}” as a change: name what is to change and how, "
                f"such as “make the lead a truck”."
            ),
            whole,
        )
    return Turn("scenario", span=whole)


def _taken_back(plain: str) -> Literal["undo", "redo"] | None:
    """Whether a text only takes back the last change, or does it again."""
    if len(plain.split()) > 14:
        return None
    table = language.table("refine")["taking_back"]
    kinds: tuple[Literal["redo", "undo"], ...] = ("redo", "undo")
    for kind in kinds:
        if any(re.fullmatch(rf"{table['before']}(?:{said}){table['behind']}", plain) for said in table[kind]):
            return kind
    return None


def _supposed(plain: str) -> str:
    """What a "what if" supposes, as a demand; empty where the text is none."""
    table = language.table("refine")
    match = next((m for pattern in table["supposed"] if (m := re.match(pattern, plain))), None)
    if not match:
        return ""
    said = re.sub(r"^there (?:were|was|is|are) (?:also )?", "add ", match["said"].strip())
    return re.sub(r"^(?!add )(?P<what>.+?) (?:were|was|is|are|be) (?P<how>.+)$", r"make \g<what> \g<how>", said)


def _requested(plain: str) -> str:
    """What is asked for politely, as an order: "would you mind removing the van?"; empty where the text is none."""
    table = language.table("refine")
    for pattern, new in table["requested"]:
        said, number = re.subn(rf"^(?:please |and |so |ok,? )?(?:{pattern})", new, plain)
        if number:
            first, _, rest = said.rstrip("? ").partition(" ")
            return f"{table['orders'].get(first, first)} {rest}"
    return ""


def _asks(plain: str, table: dict[str, str]) -> bool:
    if re.search(table["asked_for"], plain):
        return False
    if plain.endswith("?"):
        return not re.match(
            r"(can|could|would|will) (you|we) (please )?(make|change|add|remove|put|set|move|let|replace|turn|have)\b",
            plain,
        )
    return bool(re.match(table["question"], plain)) and not re.match(
        r"(is|are|do|does|have|will)\b(?!.*\?)|.*\b(instead)\b", plain
    )


def _introduces(plain: str) -> bool:
    """Whether somebody is told of for the first time ("a car", "two cyclists"), not only become or replaced."""
    new = language.table("refine")["introduces"]
    return any(s.kind == "actor" and re.search(new, plain[: s.start]) for s in scan.names(plain))


def _of_those_there(plain: str, structure: Structure) -> bool:
    """Whether a text speaks only of those who are there."""
    names = [s for s in scan.names(plain) if s.kind in ("actor", "ego")]
    meant = [refer(plain[s.start : s.end], structure, alone=False) for s in names]
    return any(meant) and not _introduces(plain)


def _adds(plain: str) -> bool:
    """Whether a text only tells of somebody new in the scene that is there."""
    table = language.table("refine")["told"]
    return bool(re.match(table["adds"], plain)) and not retold.tells_ego(re.sub(table["meanwhile"], " ", plain))


def _goes_on(plain: str, structure: Structure) -> bool:
    """Whether one sentence tells more of one who is there: "the police car is chasing a red sports car"."""
    if not plain.startswith("the ") or re.search(r"[.;] \w", plain) or len(plain.split()) > 25:
        return False
    first = next((s for s in scan.names(plain) if s.kind == "actor"), None)
    return first is not None and first.start < 20 and refer(plain[: first.end], structure, alone=False) is not None


def _tells(plain: str, commanding: bool) -> bool:
    """Whether a text tells a scene of its own: ego and another, doing something, at length, and no command."""
    if re.match(r"(a )?new (scenario|scene)\b", plain):
        return True
    opens = re.match(
        r"(an?|two|three|the ego|ego|the vehicle|on|at|in|while|when|during|night|day|it is|vehicle|unit|v)\b", plain
    )
    if (
        opens
        and len(plain.split()) >= 9
        and _introduces(plain)
        and len({s.kind for s in scan.names(plain)}) + len(scan.names(plain)) >= 4
        and not re.match(r"^(the |ego )?\w* ?(should|must)\b", plain)
        and "instead" not in plain
    ):
        return True
    if commanding and not re.search(r"[.;] \w+.*[.;] \w+", plain):
        return False
    words = len(plain.split())
    names = [s for s in scan.names(plain) if s.kind in ("actor", "ego", "label")]
    return (
        words >= 9
        and (len(names) >= 2 or words >= 14)
        and _introduces(plain)
        and not re.match(r"(at|in|on|with|without|during) (the )?\w+[.! ]*$", plain)
    )
