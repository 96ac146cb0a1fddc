"""Refinements without a model: the common forms of change become edits that touch only what was meant."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import limits, notes, order, pointed
from c2s_engine.interpret.changes.all_of_them import each_of_all
from c2s_engine.interpret.changes.claims import UnaddressedWords, unaddressed_words
from c2s_engine.interpret.changes.demands import apart, demands, topic_of, whole
from c2s_engine.interpret.changes.forms import ALREADY
from c2s_engine.interpret.changes.meant import by_labels
from c2s_engine.interpret.changes.motion import begun_by
from c2s_engine.interpret.changes.refer import actions_of, doing, refer
from c2s_engine.interpret.changes.scene_clauses import introduced, unparsed_words
from c2s_engine.interpret.changes.speed import walked
from c2s_engine.interpret.changes.still import still_done
from c2s_engine.interpret.changes.unsupported_demand import unsupported_demand
from c2s_engine.interpret.reading import amounts, scan
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, Edit, EditError, SetField, apply
from c2s_engine.structure.sentences import sentence

Found = tuple[list[Edit], str]


def edits_of(text: str, structure: Structure, typed: str = "") -> tuple[list[Edit], list[str]]:
    """The edits that a text asks for and what each does, in order; empty where nothing was understood. `typed`: the
    text before it was put plainly, which may have left out what it denies. Raises EditError where S refuses all that is
    asked for."""
    edits: list[Edit] = []
    said: list[str] = []
    current = structure
    text = notes.text_of(by_labels(text, structure), structure)
    refused: EditError | None = None
    unclear: list[str] = []
    unread_parts: list[str] = []
    done: list[tuple[str, Structure, Structure]] = []
    before, topic = "", _doer(text, structure) or topic_of(text, structure)
    parts = [d for part in limits.in_order(demands(text)) for own in apart(part) for d in each_of_all(own, structure)]
    parts = [p for p in parts if p != "no"]
    if len(parts) > 1 and not order.retype(parts[0], structure):
        of_new = _of_the_new(parts, structure)
        if len(of_new) > 1 and (new := introduced(of_new, structure)):
            edits, said, current = new[0], [new[1]], _applied(new, structure)
            parts, before = parts[len(of_new) :], of_new[-1]
            topic = next((c for e in edits if isinstance(e, AddObject) and (c := _object(e))), topic)
    while parts:
        part = parts.pop(0)
        demand = notes.demand_of(whole(part, before, topic), current)
        while parts and (both := _in_a_row(demand, parts[0], current)):
            demand = both
            parts.pop(0)
        demand = _of_the_topic(_other_one(demand, current), topic)
        before, topic = demand, topic_of(demand, current) or topic
        hidden = unsupported_demand(demand)
        try:
            read = (hidden, UnaddressedWords()) if hidden else _found(demand, current)
            for other in (_with_article(demand, current), _with_verb(demand, current)):
                if other and (read is None or read[1]):
                    again = _found(other, current)
                    read = again if again and (read is None or len(again[1]) < len(read[1])) else read
            if read is None:
                unread_parts += [demand] if _tells(demand, current) else []
                continue
            found, lost = read
            if nobody := pointed.stranger(demand, found[0], current):
                found, lost = ([], pointed.absent(nobody, current)), UnaddressedWords()
            if re.match(_REPLACES, demand) and found[0] and all(isinstance(e, AddObject) for e in found[0]):
                found, lost = ([], "it is not clear who is to be replaced"), UnaddressedWords()
            unclear += [*lost.needed, *lost.besides]
            if lost.needed or lost.besides and not found[0]:
                continue
            after = _applied(found, current)
        except EditError as error:
            refused = refused or error
            continue
        if found[0] and _same(current, after):
            found = [], f"{ALREADY} ({found[1]})" if _was_so(found, structure) else found[1]
        done += [(demand, current, after)] if found[0] else []
        current = after
        edits += found[0]
        said.append(found[1])
        topic = next((c for e in reversed(found[0]) if (c := _object(e))), topic)
    for demand in still_done(typed or text, current) if edits else ():
        if (read := _found(demand, current)) and read[0][0] and not read[1]:
            current = _applied(read[0], current)
            edits, said = [*edits, *read[0][0]], [*said, read[0][1]]
        else:
            unclear.append(demand)
    if refused is not None and not said:
        raise refused
    said += [f"not done: {refused}"] if refused is not None else []
    for demand, then, so in done[:-1]:
        was = {*(first := unaddressed_words(demand, then, so)).needed, *first.besides}
        undone = unaddressed_words(demand, then, current)
        unclear += [w for w in (*undone.needed, *undone.besides) if w not in was]
    unclear += unread_parts if said or unclear else []
    if unclear:
        why = f"it is not clear what {' and '.join(f'“{words}”' for words in dict.fromkeys(unclear))} changes"
        said.append(f"not done: {why}" if edits else why)
    return [*edits, *described(structure, current)], said


def _doer(text: str, structure: Structure) -> str | None:
    """Who "it" is that a text begins with: the only one who does what is told of it."""
    said = re.match(r"(?:no,? )?(?:it|he|she|they)\b(?P<told>[^.;]+)", text)
    told = re.sub(language.table("refine")["told"]["meanwhile"], " ", said["told"]) if said else ""
    found = [c.id for c in structure.objects if said and doing(told, actions_of(c))]
    return found[0] if len(found) == 1 else None


def _was_so(found: Found, structure: Structure) -> bool:
    """Whether edits change nothing in S as it was before the turn."""
    try:
        return _same(structure, _applied(found, structure))
    except EditError:  # about one whom the turn adds
        return False


def _same(before: Structure, after: Structure) -> bool:
    """Whether two S say the same, and assume the same."""
    one, other = ([(c.id, c.spec, c.assumed) for c in s.components] for s in (before, after))
    return one == other


def _of_the_new(parts: list[str], structure: Structure) -> list[str]:
    """The first parts of a text, up to one that tells what somebody else does who is there."""
    anew = language.table("refine")["told"]["anew"]
    for number, part in enumerate(parts[1:], 1):
        if re.match(anew, part):
            return parts[:number]
        first = next((s for s in scan.names(part) if s.kind in ("actor", "ego")), None)
        subject = first is not None and re.fullmatch(r"(?:and |then |but )*(?:the )?", part[: first.start])
        there = refer(f"the {part[first.start : first.end]}", structure, alone=False) if first and subject else None
        if there is not None and first is not None and re.match(r" (?!is hidden\b)\w", part[first.end :]):
            return parts[:number]
    return parts


def _applied(found: Found, structure: Structure) -> Structure:
    for edit in found[0]:
        structure = apply(structure, edit)
    return structure


def _in_a_row(first: str, then: str, structure: Structure) -> str | None:
    """Two demands as one where the second only tells what the same one does then: "waits 2 s" and "then crosses"; or
    only when he does what the first says: "ego brakes later" and "only 1.5 s after the lead brakes"."""
    if valued := _of_the_value(first, then):
        return valued
    if re.match(_ONLY_WHEN, then) and (both := f"{first} {then}") and begun_by(both, structure):
        return both
    if not re.match(language.table("refine")["demands"]["goes_on"], then):
        return None
    both = f"{first}, {then}"
    return both if order.acting(first, structure) else None


def _of_the_value(first: str, then: str) -> str | None:
    """A demand with another value, where the next one only says it: "with a gap of 12 m" and "make that 20 m"."""
    if not (made := re.match(r"(?:no )?(?:make|set) (?:that|it) (?:to )?(?P<value>\d.*)$", then)):
        return None
    new, olds = amounts.quantities(made["value"]), amounts.quantities(first)
    alike = [s for s in olds if new and s.data["dimension"] == new[0].data["dimension"]]
    if len(alike) != 1 or new[0].end != len(made["value"]):
        return None
    return f"{first[: alike[0].start]}{made['value']}{first[alike[0].end :]}"


_REPLACES = r"(?:replace|swap|exchange|substitute)\b"
_ONLY_WHEN = r"(?:(?:but|and|just|only) )*(?:\d[\d.]* ?(?:s|secs?|seconds?) )?(?:after|when|once|as soon as)\b"


def _found(demand: str, structure: Structure) -> tuple[Found, UnaddressedWords] | None:
    """What the form asks for that leaves fewest words of the demand without an answer, and these words; of forms that
    leave as many the first. Where somebody does that already, how fast he is to do it."""
    table = language.table("refine")["told"]
    best: tuple[Found, UnaddressedWords] | None = None
    for form in order.FORMS:
        found = form(demand, structure)
        if found is None:
            continue
        denied = re.search(table["denies"], demand)
        if form is order.acting and not denied and all(_already(e, structure) for e in found[0]):
            waits = re.search(table["meanwhile"], demand)
            if waits:
                return best
            found = walked(demand, structure) or ([], f"{ALREADY} ({found[1]})")
        lost = _lost(demand, found, structure)
        if form in (order.acting, order.standing) and found[0]:
            lost = lost.with_more(unparsed_words(demand, structure))
        if best is None or len(lost) < len(best[1]):
            best = found, lost
        if not lost or form is order.acting:
            return best
    return _together(demand, best, structure) if best is not None and best[1] else best


def _together(demand: str, first: tuple[Found, UnaddressedWords],
              structure: Structure) -> tuple[Found, UnaddressedWords]:  # fmt: skip
    """What a form asks for, with what others ask for besides that answers more of the words: "2 s later and 10 m
    further ahead"."""
    (edits, said), lost = first
    for form in order.FORMS:
        current = _applied((edits, said), structure)
        more = form(demand, current)
        if more is None or not more[0] or {_field(e) for e in more[0]} & {_field(e) for e in edits}:
            continue
        both = [*edits, *more[0]], f"{said}; {more[1]}"
        left = unaddressed_words(demand, structure, _applied(both, structure))
        if len(left) < len(lost):
            (edits, said), lost = both, left
    return (edits, said), lost


def _field(edit: Edit) -> tuple[str, str]:
    return str(getattr(edit, "component", "")), str(getattr(edit, "path", ""))


def _lost(demand: str, found: Found, structure: Structure) -> UnaddressedWords:
    """The words that edits leave without an answer; none where a form only says why nothing is done."""
    if not found[0] and not found[1].startswith(ALREADY):
        return UnaddressedWords()
    return unaddressed_words(demand, structure, _applied(found, structure))


def _with_article(demand: str, structure: Structure) -> str:
    """A demand with the article that it leaves out before one who is there: "car aborts its turn"; else nothing."""
    first = next(iter(scan.names(demand)), None)
    bare = first is not None and first.start == 0 and first.kind == "actor" and not first.data.get("plural")
    if first is None or not bare or refer(f"the {demand[: first.end]}", structure, alone=False) is None:
        return ""
    return f"the {demand}"


def _with_verb(demand: str, structure: Structure) -> str:
    """A demand with the verb that it leaves out between one who is there and a place: "o2 on the left sidewalk"."""
    match = re.match(r"(?P<who>(?:the )?[\w-]+) (?P<where>(?:on|in|at|behind|beside|ahead of|in front of) .+)$", demand)
    if match is None or refer(match["who"], structure, alone=False) is None:
        return ""
    return f"{match['who']} is {match['where']}"


def _other_one(demand: str, structure: Structure) -> str:
    """A demand about ego in which "it" is the only other one who is there: "ego stops 2 m away from it"."""
    if len(structure.objects) != 1 or not re.match(r"(?:the )?ego\b", demand):
        return demand
    cid = structure.objects[0].id.lower()
    return re.sub(r"\b(from|of|before|behind|for|with|past|to) (?:it|him|her|them)$", rf"\g<1> {cid}", demand)


def _of_the_topic(demand: str, topic: str | None) -> str:
    """A demand for another pace that names nobody, of whom the sentence speaks: "make the child a woman, half as
    fast"."""
    named = any(s.kind in ("actor", "ego", "label") for s in scan.names(demand))
    if not topic or named or re.search(r"\bo[1-9]\b", demand) or not re.match(_PACE, demand):
        return demand
    return f"{'ego' if topic == 'E' else topic.lower()} is {demand}"


_PACE = (
    r"(?:(?:and|but|just|only|much|a (?:bit|little)|slightly|about|\d[\d.]* ?(?:km/?h|kph|mph|m/s|%|percent)) )*"
    r"(?:half|twice|double|three times|slower|faster|quicker)\b"
    r"(?: as (?:fast|quick|slow)(?:ly)?| (?:the|its|his|her) (?:speed|pace)| speed| now| too)*$"
)


def _tells(demand: str, structure: Structure) -> bool:
    """Whether a demand that no form reads tells something of the scene: of somebody there, or a number."""
    told = any(q.data["dimension"] != "percent" for q in amounts.quantities(demand))
    return told or refer(demand, structure, alone=False) is not None


def _already(edit: Edit, structure: Structure) -> bool:
    if not isinstance(edit, SetField) or edit.component not in structure:
        return False
    spec: Any = structure[edit.component].spec
    for name in str(edit.path).split("."):
        spec = getattr(spec, name, None)
    return bool(spec == edit.value)


def _object(edit: Edit) -> str | None:
    cid = str(getattr(edit, "component", None) or "")
    return cid if cid.startswith("O") else None


def described(before: Structure, after: Structure) -> list[Edit]:
    """The sentences of the components whose specs changed."""
    edits: list[Edit] = []
    for component in after.components:
        if component.id in before and before[component.id].spec == component.spec or component.id == "T":
            continue
        words = sentence(component, after)
        if words != component.description:
            edits.append(SetField(component=component.id, path="description", value=words))
    return edits
