"""How a demand is put: a wish, a request, a passive, a noun for what is done or a contrast gives the plain demand.

"What I'd rather see is the van at 50", "could the van be replaced by a bus?" and "lane change by the van" become "the
van at 50", "replace the van by a bus" and "the van should change lanes". The patterns: data/language/wordings.yaml.
"""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import notes, paced
from c2s_engine.interpret.changes.chosen import in_role
from c2s_engine.interpret.changes.counted import numbered
from c2s_engine.interpret.changes.meant import called_by, described
from c2s_engine.interpret.changes.refer import actions_of, objects_of, refer, spec_of
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Structure

RIDDEN = ("bicycle", "motorcycle")
"""Vehicles whose rider is a "he" or a "she"."""


@cache
def _table() -> dict[str, Any]:
    return {**language.table("wordings")}


def plainly(plain: str, structure: Structure) -> str:
    """A turn with each of its sentences put plainly."""
    for find, new in _table()["before"]:
        plain = re.sub(find, new, plain)
    plain = re.sub(_table()["member"], lambda m: _member(m, structure), plain)
    plain = re.sub(_table()["two"], lambda m: _two(m, structure), plain)
    plain = _named(re.sub(_table()["row"], _row(structure) or r"\g<0>", plain), structure)
    plain = re.sub(_table()["hidden_one"], lambda m: _hidden(m, structure), plain)
    sentences = re.split(r"(?<=[.;!?])\s+", plain)
    rows = [paced.sentence(), *((find, _with_doer(new, verb, structure)) for find, new, verb in _rows("sentences"))]
    return " ".join(
        notes.rewritten(_active(described(numbered(s, structure), structure)), rows, structure) for s in sentences
    )


def _row(structure: Structure) -> str | None:
    """What those are called who are told of together, where there is one such group."""
    groups = [spec_of(c) for c in structure.objects if spec_of(c).count > 1]
    if len(groups) != 1:
        return None
    parked = "parked " if groups[0].placement.position == "parked" else ""
    return f"the {parked}{language.plurals(groups[0].type.replace('_', ' '))[0]}"


def _member(match: re.Match[str], structure: Structure) -> str:
    """One of those who are told of together: "the last parked car" of three that are one row."""
    noun = match["noun"] or match["its"]
    found = [c for c in structure.objects if spec_of(c).count > 1] if noun == "one" else objects_of(structure, noun)
    groups = [spec_of(c) for c in found]
    if len(groups) != 1 or groups[0].count < 2:
        return match[0]
    which = match["which"] or match["single"]
    parked = "parked " if groups[0].placement.position == "parked" else ""
    return f"the {which} of the {parked}{language.plurals(groups[0].type.replace('_', ' '))[0]}"


def _two(match: re.Match[str], structure: Structure) -> str:
    """The only two of a type by their nouns: "the two pedestrians", "both crossing cars"."""
    named = [s for s in scan.names(match["noun"]) if s.kind == "actor"]
    found = in_role(named[0].data["roles"], objects_of(structure, named[0].data["type"])) if named else []
    if len(found) == 1 and spec_of(found[0]).type not in PERSONS:
        return f"both {match['noun']}"  # ego and this one
    if len(found) != 2 or named[0].data["type"] == "vehicle":
        return match[0]
    return " and ".join(called_by(c, structure) for c in found)


def questioned(plain: str, structure: Structure) -> str:
    """A demand that is put as a question about somebody, as one; empty where the text is none."""
    said = notes.rewritten(plain, [(find, new) for find, new, _ in _rows("questions")], structure)
    return plainly(said, structure) if said != plain else ""


def _named(plain: str, structure: Structure) -> str:
    """The text with the only person, else rider, for "he" and "she", where nobody else is named last before."""
    persons = [c for c in structure.objects if spec_of(c).type in PERSONS]
    persons = persons or [c for c in structure.objects if spec_of(c).type in RIDDEN]
    pronoun = re.search(r"\b(?:he|she|him|her)\b(?!['’]s)", plain)
    if pronoun is None or len(persons) != 1:
        return plain
    named = [s for s in scan.names(plain[: pronoun.start()]) if s.kind == "actor"]
    before = refer(plain[named[-1].start : named[-1].end], structure, alone=False) if named else persons[0]
    if before is None or before.id != persons[0].id:
        return plain
    return f"{plain[: pronoun.start()]}{called_by(persons[0], structure)}{plain[pronoun.end() :]}"


def _hidden(match: re.Match[str], structure: Structure) -> str:
    """Whom something new hides, where only one person is there: "a van that hides him"."""
    persons = [c for c in structure.objects if spec_of(c).type in PERSONS]
    return f"{match['hides']}{called_by(persons[0], structure)}" if len(persons) == 1 else match[0]


def _active(sentence: str) -> str:
    """A passive demand as an order: "the van should be replaced by a bus", "have the van removed"."""
    verbs = _table()["passives"]["verbs"]
    for pattern in _forms():
        if match := pattern.search(sentence):
            order = f"{verbs[match['done']]} {match['what']}"
            return f"{sentence[: match.start()]}{order}{sentence[match.end() :].rstrip('? ')}"
    return sentence


@cache
def _forms() -> list[re.Pattern[str]]:
    table = _table()["passives"]
    done = language.alternatives(list(table["verbs"]))
    return [re.compile(form.replace("{done}", f"(?:{done})")) for form in table["forms"]]


def _with_doer(new: str, verb: str, structure: Structure) -> notes.New:
    """What is read instead, with the only one who does what the noun tells; nothing else where there is none."""
    if "<doer>" not in new:
        return new

    def expanded(match: re.Match[str]) -> str:
        old = match.groupdict().get("old")
        acts = _table()["acts"]
        done = next((a for noun, v, a in acts if (re.fullmatch(noun, old) if old else v == verb)), ())
        found = [c for c in structure.objects if set(done) & set(actions_of(c))]
        return match.expand(new.replace("<doer>", called_by(found[0], structure))) if len(found) == 1 else match[0]

    return expanded


@cache
def _rows(section: str) -> list[tuple[re.Pattern[str], str, str]]:
    """The patterns of a section, one for each act where they speak of one, with the verb of that."""
    table = _table()
    nouns = "|".join(noun for noun, _, _ in table["acts"])
    rows = []
    for find, new in table[section]:
        find = find.replace("<act_noun>", f"(?:{nouns})")
        for noun, verb, _ in table["acts"] if re.search("<act_of>|<doing>", find) else [("", "", ())]:
            doing = f"{verb.partition(' ')[0]}(?:e?s)?"
            said = find.replace("<act_of>", f"(?:{noun})<manoeuvre>").replace("<doing>", doing)
            pattern = notes.compiled(said, table["words"])
            rows.append((pattern, new.replace("<do>", verb), verb))
    return rows
