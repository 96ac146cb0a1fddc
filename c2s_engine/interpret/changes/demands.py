"""The single demands of what somebody types to change a scene, each made whole.

"I'd like the lead to be a truck, because ..., and it drives 60 km/h" has two: what only gives a reason is left out, and
"it" is whom the one before was about.
"""

import re
from functools import cache
from itertools import pairwise
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import ComponentId, Structure


@cache
def _table() -> dict[str, Any]:
    return {**language.table("refine")["demands"]}


def demands(text: str) -> list[str]:
    """The demands of a text, in order, as plain text."""
    plain = " ".join(re.sub(r"[?!.]+(?=\s)", ".", scan.normalised(text).rstrip("?!. ")).split())
    plain = re.sub(_table()["moment"], "when ", plain)
    found: list[str] = []
    for sentence in re.split(r"(?:[.;:]\s+|\.$)", plain):
        found += [d for part in _folded(_parts(sentence)) for own in _detailed(part) if (d := _bare(own))]
    return found


def whole(demand: str, before: str, topic: ComponentId | None) -> str:
    """A demand with what it leaves out: "it" and a bare verb are about whom the one before was (`topic`), "the child
    too" has what was said there, "and the van a truck" its verb, and a bare number its unit.
    """
    table = _table()
    who = "ego" if topic == "E" else (topic or "").lower()
    if who:
        demand = re.sub(table["objects"], rf"\g<1>{who}", demand)
    for pattern, said in table["told_as"]:
        demand = re.sub(pattern, said, demand)
    demand = _value(demand, before, who or "ego")
    if who:
        if before:
            demand = re.sub(table["its_speed"], f"{who} at speed ", demand)
        if not re.search(r"\b(?:distance|gap|headway)\b", f"{before} {demand}"):
            demand = re.sub(table["paced"], f"change {who}'s speed ", demand)
        if re.search(r"\b(?:brak|stop|slow|decelerat)", before):
            demand = re.sub(table["slowed"], f"{who} brakes down to ", demand)
        demand = re.sub(r"^to (?=down to )", f"{who} brakes ", re.sub(r"^to (?=up to )", f"{who} accelerates ", demand))
        if re.match(r"(?:about |around )?\d[\d.]* ?[a-z]+ (?:between|in between|apart|of space)", demand):
            demand = f"{who} with {demand}"
        demand = re.sub(rf"^(then )?(?:it|he|she|they)\b(?!{table['impersonal']})", rf"\g<1>{who}", demand)
        if not re.search(table["owned"], demand) or not scan.names(demand):
            demand = re.sub(table["owned"], f"{who}'s", demand)
        demand = re.sub(r"\b(for|of|with|by|to) (?:it|them|him|her)$", rf"\g<1> {who}", demand)
        if (subject := re.match(table["subject"], demand)) and subject[1] != who:
            demand = re.sub(table["met"], rf"\g<1> {who}", demand)
        demand = re.sub(table["made_so_fast"], f"{who} at ", demand)
        demand = re.sub(table["made"], f"{who} will ", demand)
        demand = re.sub(table["counted"], rf"\g<1> {who} ", demand)
        demand = re.sub(table["moved"], rf"\g<1>{who}", demand)
        if who == "ego":
            demand = re.sub(table["lets"], "ego lets ", demand)
        demand = re.sub(table["subjectless"], rf"\g<1>{who} ", demand)
        demand = re.sub(table["obliged"], f"{who} should ", demand)
        demand = re.sub(table["sets_off"], f"{who} should start ", demand)
        demand = re.sub(table["infinitive"], rf"\g<1>{who} will ", demand)
    if (side := re.search(r"\b(?:from|on) the (left|right)\b", before)) and not re.search(
        r"\b(?:left|right)\b", demand
    ):
        demand = re.sub(r"\b(from|on) (?:there|the same side|that side)\b", rf"\g<1> the {side[1]}", demand)
    named = scan.names(before)
    if (too := re.match(table["as_well"], demand)) and named:
        head = re.sub(r"\b(?:the|an?|my|our)\s*$", "", before[: named[0].start])
        return f"{head}{too['who']}{before[named[0].end :]}"
    elided = re.match(table["elided"], demand) if re.search(table["becomes"], before) else None
    if elided and (scan.names(elided["who"]) or re.fullmatch(r"(?:and )?(?:ego|o\d+)", elided["who"])):
        return f"make {elided['who']} {elided['what']}"
    unit = None if re.search(r"\b(?:distance|gap|headway)\b", demand) else re.search(table["unit"], before)
    return f"{demand} {unit[1]}" if unit and re.search(r"[a-z] \d+$", demand) else demand


def _value(demand: str, before: str, who: str) -> str:
    """A bare value ("ego is too slow. 50") with what it is one of."""
    value = None if re.search(r"\bapart$", demand) else re.match(_table()["value"], demand)
    said = next((new for pattern, new in _table()["value_of"] if re.search(pattern, before)), None) if value else None
    if value is None or said is None:
        return demand
    told = said.format(who=who, value=value["value"])
    return re.sub(r" (?:km/h|m)$", f" {value['unit'].strip()}", told) if value["unit"] else told


def apart(part: str) -> list[str]:
    """A demand and what it denies besides: "stops without hitting the truck", "brakes instead of changing lanes"."""
    match = next((m for find in (_UNTOUCHED, _GIVEN_UP) if (m := find.match(part))), None)
    if match is None:
        return [part]
    first = next((s for s in scan.names(match["head"]) if s.kind in ("actor", "ego", "label")), None)
    named = re.match(r"(?:let |make |have )?(?P<who>o\d)\b", match["head"])
    who = named["who"] if named else match["head"][: first.end] if first else "it"
    who = re.sub(r"^(?:let|make|have) ", "", who)
    if match.re is _UNTOUCHED:
        return [match["head"], f"{who} must not touch {match['whom'] or 'anybody'}"]
    return [match["head"], f"{who} does not {_base(match['verb'])}{match['rest']}"]


_UNTOUCHED = re.compile(
    r"(?P<head>.+?),? (?:and |but )?without (?:ever )?(?:hitting|touching|striking|crashing into"
    r"|colliding with|(?:any |a )?"
    r"(?:contact|collision)(?: with)?)(?: (?P<whom>.+))?$"
)
_GIVEN_UP = re.compile(r"(?P<head>.+?) instead of (?P<verb>(?!being\b)\w{3,}ing)\b(?P<rest>.*)$")


def _base(verb: str) -> str:
    """The verb of a form with -ing."""
    stem = verb.removesuffix("ing")
    if re.search(r"([bdgmnprt])\1$", stem):
        return stem[:-1]
    return f"{stem}e" if re.search(r"(?:[iaou][dkvst]|ng|rg|rv|dl|tl)$", stem) else stem


def topic_of(demand: str, structure: Structure) -> ComponentId | None:
    """Whom a demand is about."""
    found = refer(demand, structure, alone=False)
    return found.id if found is not None else None


def only_one(text: str, structure: Structure) -> ComponentId | None:
    """Whom a pronoun at the head of a text means, where only one can be meant: a person, or all that is there."""
    pronoun = re.match(r"(?:please |now |and |but |no,? |then |let |make )*(he|she|him|her|it|they|them)\b", text)
    if pronoun is None:
        return None
    persons = [c for c in structure.objects if spec_of(c).type in PERSONS]
    meant = list(structure.objects) if pronoun[1] in ("it", "they", "them") else persons
    return meant[0].id if len(meant) == 1 else None


def _parts(sentence: str) -> list[str]:
    table = _table()
    starts, contrast, there = table["starts"], table["contrast"], table["there"]
    sentence = re.sub(table["reason_behind"], "", re.sub(table["reasoned"], "", sentence))
    if joint := re.match(table["jointly"], sentence):
        return [f"{joint[name]} {joint['rest']}" for name in ("one", "other")]
    bounds = (
        r"\s+with (?=ego (?:in|on|at)\b)",
        table["apart"],
        table["hides"],
        table["forces"],
        table["while_it"],
        table["paced_too"],
        table["becomes_too"],
        r"\s+and\s+(?=(?:ego|o\d) an? [\w-]+$)",
        r"\s*,?\s+but\s+(?=(?:with |in )?(?:fog|rain|snow|wind|night|dusk|dawn|clear)\b)",
        r"\s*,\s+(?:and |but )?",
        rf"\s+(?:and|but)\s+(?=(?:then )?{starts}|(?:please|also|at the same time) \w|(?:to|should|must|has to) \w)",
        rf"\s+but\s+(?={contrast})",
        table["alone"],
        rf"(?<!only)\s+(?=then {starts})",
        rf"\s+{there}",
    )
    sentence = re.sub(r"\b(both|between) ((?:the )?[\w-]+) and ", r"\1 \2 & ", sentence)
    sentence = re.sub(table["together"], r"\g<one> & ", sentence)
    return [part.replace(" & ", " and ") for part in re.split("|".join(bounds), sentence)]


def _folded(parts: list[str]) -> list[str]:
    """Parts without reasons; a clause of time stays with what it is about, a participle with what stands before it."""
    table = _table()
    found: list[str] = []
    ahead = ""
    for part in (p.strip() for p in parts):
        if re.match(table["so"], part):
            adds = language.table("refine")["told"]["adds"]
            told = bool(re.match(table["follows_from"], part)) and not re.search(table["judges"], ", ".join(found))
            told = told and not re.match(r"(?:ego|we|i|it)\b", ", ".join(found))
            kept = [d for d in found if told or re.search(table["demanding"], d) or re.match(adds, found[0])]
            found, ahead = kept, ""
        if not part or re.match(table["reason"], part) or re.match(table["kept"], part):
            continue
        if re.match(table["subordinate"], part) and not found or re.match(table["in_place"], part):
            ahead = f"{ahead}{part}, "
        elif found and (enough := re.match(table["enough"], part)):
            judged = re.search(table["judges"], found[-1])
            found = [*found, enough["what"]] if judged else [*found[:-1], f"{found[-1]}, {enough['what']}"]
        elif found and (
            re.match(table["continues"], part)
            or re.match(table["infinitive"], part)
            and not part.startswith("then")
            and re.search(table["does"], found[-1])
        ):
            moment = re.match(table["moments"], part)
            found[-1] = f"{found[-1]} {part}" if moment else f"{found[-1]}, {part}"
        else:
            found.append(ahead + part)
            ahead = ""
    demanded = [d for d in found if re.search(table["demanding"], d)]
    if demanded:
        valued = [d for d, then in pairwise(found) if re.match(table["value"], then)]
        found = [d for d in found if d in demanded or d in valued or not re.search(table["judges"], d)]
    return found or ([ahead.strip(", ")] if ahead else [])


def _detailed(part: str) -> list[str]:
    """A part that makes somebody another, and what it says of that one, each a demand: "a bicycle, 15 km/h", "a white
    van and only do 85"."""
    table = _table()
    head, *rest = re.split(r", (?:and )?| and ", part)
    if not rest or not re.match(table["retypes"], _bare(head)):
        return [part]
    details = [re.sub(pattern, said, d) for d in rest for pattern, said in table["of_it"] if re.match(pattern, d)]
    return [head, *details] if len(details) == len(rest) else [part]


def _bare(part: str) -> str:
    """A demand without how it is put."""
    table = _table()
    part = part.strip(" .,;")
    asked = re.sub(table["openers"], "", part)
    if asked != part:
        asked = re.sub(table["wants"], r"\g<who> will ", asked)
    part = asked
    part = re.sub(table["same_but"], r"\g<what> instead\g<of>", part)
    return re.sub(table["closers"], "", part).strip(" .,;")
