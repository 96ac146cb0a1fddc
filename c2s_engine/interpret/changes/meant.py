"""Who is meant by a phrase without a noun of his own: "the thing in front of us", "the left one", "the overtaker", "the
guy on the bike": called by his noun instead, where only one who is there fits."""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.ranked import ranked
from c2s_engine.interpret.changes.refer import actions_of, labelled, objects_of, refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure


@cache
def _table() -> dict[str, Any]:
    return {**language.table("notes")["meant"]}


@cache
def _described() -> re.Pattern[str]:
    table = _table()
    before = "|".join(row["before"] for row in table["where"] if row.get("before"))
    behind = "|".join(row["behind"] for row in table["where"] if row.get("behind"))
    return re.compile(
        rf"(?:\b(?:the|that|this|our|my) |^|(?<=^no )|(?<=^without ))"
        rf"(?:(?P<before>{before}) )?(?P<head>{table['heads']})"
        rf"(?:(?: (?:{table['relative']}))? (?P<behind>{behind})(?: {table['of_ego']})?)?(?![\w-])"
    )


def called(plain: str, structure: Structure) -> str:
    """The text in which those who are only described are called by their nouns."""
    for noun, kinds in _table()["nouns"]:
        there = next((found for kind in kinds if (found := _of_type(structure, kind))), None)
        if there:
            said = rf"{_table()['definite']}\b(?:the |that |this |our )?(?:{noun})(?![\w-])"
            plain = re.sub(said, called_by(there[0], structure), plain)
    for component in structure.objects:
        name = spec_of(component).name.replace("_", " ")
        if len(name) > 3 and not scan.names(name):
            said = rf"\b(?:the )?{re.escape(name)}(?![\w-])"
            plain = re.sub(said, lambda m, c=component: _noun_or(m, c, structure), plain)  # type: ignore[misc]
        head = name.rpartition(" ")[2]
        if head != name and len(head) > 3 and not scan.names(head) and len(_headed(head, structure)) == 1:
            said = rf"\bthe {re.escape(head)}(?![\w-])"
            plain = re.sub(said, lambda m, c=component: _noun_or(m, c, structure), plain)  # type: ignore[misc]
    return described(plain, structure)


def _headed(noun: str, structure: Structure) -> list[Component]:
    """Those whose names end in a noun: "tyre" of a blown tyre."""
    return [c for c in structure.objects if spec_of(c).name.rpartition("_")[2] == noun]


def _noun_or(match: re.Match[str], component: Component, structure: Structure) -> str:
    """One who is called by his name; the word itself where it only stands before a noun: "the oncoming truck"."""
    behind = scan.names(match.string[match.end() :])
    return match[0] if behind and behind[0].start == 1 else called_by(component, structure)


def by_labels(plain: str, structure: Structure) -> str:
    """The text in which those who are there are called by their nouns instead of their labels: "Unit 2", "the POV"."""
    plain = scan.normalised(plain)
    for span in reversed([s for s in scan.names(plain) if "label" in s.data]):
        component = labelled(span.data["label"], structure)
        if component is not None:
            before = re.sub(r"\bthe $", "", plain[: span.start])
            name = "ego" if component.id == "E" else called_by(component, structure)
            plain = f"{before}{name}{plain[span.end :]}"
    return plain


def described(plain: str, structure: Structure) -> str:
    """The text in which those are called by their nouns who are told by what they do or where they are."""
    plain = ranked(plain, structure, called_by)
    plain = re.sub(_table()["beside_another"], lambda m: _by_another(m, structure), plain)
    return _described().sub(lambda m: _fitting(m, structure), plain)


def called_by(component: Component, structure: Structure) -> str:
    """A name for somebody that means nobody else."""
    name = f"the {spec_of(component).type.replace('_', ' ')}"
    found = refer(name, structure, alone=False)
    return name if found is not None and found.id == component.id else component.id.lower()


def _of_type(structure: Structure, kind: str) -> list[Component]:
    return [c for c in structure.objects if spec_of(c).type == kind]


def _by_another(match: re.Match[str], structure: Structure) -> str:
    """One who is behind or before somebody else: "the thing behind the oncoming car"; nobody where there is none."""
    other = refer(match["other"], structure, alone=False)
    if other is None or other.id == "E":
        return match[0]
    found = [c for c in structure.objects if c.id != other.id]
    return f"{called_by(found[0], structure)}{match['rest']}" if len(found) == 1 else f"somebody{match['rest']}"


def is_there(words: str, component: Component) -> bool:
    """Whether somebody is where the words tell him to be, as far as they do: "the car behind ego"."""
    match = _described().search(f"the {words}")
    said = [w for w in (match["before"], match["behind"]) if w] if match else []
    return all(_where(w, [component]) for w in said)


def _fitting(match: re.Match[str], structure: Structure) -> str:
    """The only one whom a description fits; the description itself where nobody or more than one does."""
    said = [w for w in (match["before"], match["behind"]) if w]
    kind = next((k for pattern, k in _table()["kinds"] if re.fullmatch(pattern, match["head"])), None)
    found = objects_of(structure, kind) if kind else list(structure.objects)
    paced = re.match(r"(?:.s)? (?:\w+ ){0,5}?\d", match.string[match.end() :])
    acts = paced and match["before"] and re.fullmatch(_table()["acting"], match["before"])
    if not said or kind and len(found) == 1 and not acts:
        return match[0]
    tail = ""
    for words in said:
        found = _where(words, found)
    return f"{called_by(found[0], structure)}{tail}" if said and len(found) == 1 else match[0]


def _where(words: str, components: list[Component]) -> list[Component]:
    """Those who are where the words say, or do what they say."""
    for row in _table()["where"]:
        if any(re.fullmatch(row[key], words) for key in ("before", "behind") if row.get(key)):
            for fits in row["is"]:
                if found := [c for c in components if _is(fits, c)]:
                    return found
            return []
    return []


def _is(fits: dict[str, list[str]], component: Component) -> bool:
    """Whether the fields of a component have one of the values."""
    spec = spec_of(component)
    values: dict[str, set[str | None]] = {
        "position": {spec.placement.position},
        "side": {spec.placement.side},
        "along": {spec.placement.along},
        "type": {spec.type},
        "action": set(actions_of(component)),
    }
    return all(values[key] & set(wanted) for key, wanted in fits.items())
