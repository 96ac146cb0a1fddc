"""Parties that a text gives a code of its own and then tells of by it ("01 = lorry, ... 02 = car, ...", "T2: car, right
lane behind T1", "c1, c2: southbound cars"): the codes are read as labels, and the lines of a comment as lines."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement

CODE = r"(?:0[1-9]|[A-Za-z]{1,4}[-_ ]?[1-9]\d?)"
NO_CODE = frozenset(language.words("no_codes"))
"""What stands with a number for a step, a case or a lane."""
NUMBERED = re.compile(
    r"(?<![\w:./,+-])(?:(?P<noun>participant|party|driver of|driver|road user|vehicle|car|by|of|with|overlooked|hit"
    r"|struck) )?(?P<code>0[1-9])(?![\w-]|[:./,]\d|\s?(?:m|s|km|km/h|mph|h|am|pm)\b)",
    re.IGNORECASE,
)
MORE = re.compile(rf"\s*(?:,|and|&|/|\+)\s*(?={CODE}\b)")
COMMENT = re.compile(r"(?P<before>\S?)(?:^|(?<=\s))\s*(?:#|//)[ \t]+(?=(?:the )?[\w][\w -]{0,16}(?:, ?[\w -]{1,8})*: )")
ROW = re.compile(
    r",?\s+(?:(?:driving|travelling|traveling|following) )?(?:one behind the other|one after the other|nose to tail"
    r"|in (?:single file|a row|a line|(?:a )?convoy|column))\b"
)
ABREAST = re.compile(r",?\s+(?:riding |driving )?(?:side by side|abreast|next to each other)\b")
AFTER = r"(?=\s*(?:[,;.(|\n]|-|$)|\s+(?:at|with|in|on|from|ahead|behind|coming|doing|going|one|nose|approaching)\b)"


@cache
def _defined() -> re.Pattern[str]:
    nouns = language.alternatives([n for n, (kind, _, _) in language.actor_nouns().items() if kind != "vehicle"])
    return re.compile(
        rf"(?:^|[\n.;|#(])[ \t]*(?P<keys>{CODE}(?:\s*(?:,|and|&|/|\+)\s*{CODE})*)[ \t]*[:=][ \t]*"
        rf"(?P<lead>(?:(?:an?|the|one|two|three)\s+)?(?:[\w-]+\s+){{0,3}}?)(?P<noun>{nouns}){AFTER}"
        rf"(?=(?P<rest>(?:(?!;\s*{CODE}\s*[:=])[^\n.|#])*))",
        re.IGNORECASE,
    )


@cache
def _ego() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?:{'|'.join(language.table('ego')['strong'])})(?![\w-])", re.IGNORECASE)


@cache
def _singular() -> dict[str, str]:
    return {p: n for n in language.actor_nouns() for p in language.plurals(n) if p != n}


def keyed(text: str) -> list[Replacement]:
    """The labels that codes are read as, with what is told of several codes at once told of each."""
    marked = _comments(text)
    told = [(m, _codes(m["keys"])) for m in _defined().finditer(text)]
    names = _names(text, [code for _, codes in told for code in codes] or _numbered(text))
    if not names:
        return marked
    found: list[Replacement] = []
    for match, codes in told:
        if len(codes) > 1:
            found.append((match.start("keys"), match.end("rest"), _of_each(match, [names[c] for c in codes], names)))
        elif codes[0] in names and (comma := re.match(r",\s*(?=\w)", match["rest"])):
            at = match.end("noun")
            found.append((at, at + comma.end(), f". {names[codes[0]]} "))
    taken = [(start, end) for start, end, _ in found]
    for start, end, new in _again(text, names):
        if not any(s <= start < e for s, e in taken):
            found.append((start, end, new))
    return marked + found


def _numbered(text: str) -> list[str]:
    """The numbers by which a report calls its parties: "participant 01 overlooked 02 ... 02 struck the car"."""
    found = [m["code"] for m in NUMBERED.finditer(text)]
    known = any((m["noun"] or "by").lower() not in ("by", "of", "with") for m in NUMBERED.finditer(text))
    return sorted(set(found)) if known and len(set(found)) > 1 and len(found) > 2 else []


def _comments(text: str) -> list[Replacement]:
    """The marks of comment lines, each of which is a line of its own; their clauses go on with whom the line names."""
    marks = list(COMMENT.finditer(text))
    if len(marks) < 2:
        return []
    found = [(m.end("before"), m.end(), ".\n" if re.match(r"[\w)]", m["before"]) else "\n") for m in marks]
    for mark, end in zip(marks, [*(m.start() for m in marks[1:]), len(text)], strict=True):
        said = re.finditer(r";\s+(?=[a-z])", text[mark.end() : end])
        found += [(mark.end() + m.start(), mark.end() + m.end(), ", ") for m in said]
    return found


def _codes(keys: str) -> list[str]:
    return [c.lower() for c in MORE.split(keys)]


def _names(text: str, codes: list[str]) -> dict[str, str]:
    """The label of each code: a number of a vehicle, or of another road user where ego has a name of its own."""
    labels = language.table("ego")["labels"]
    known = {*labels["words"], *labels["parts"], *labels["typed"], *NO_CODE}
    own = list(dict.fromkeys(c for c in codes if re.sub(r"[^a-z]", "", c) not in known or c[0] == "0"))
    if len([c for c in own if c[0] == "0"]) < 2:
        own = [c for c in own if c[0] != "0"]
    other = _ego().search(text) is not None or re.search(r"(?<![\w-])(?:v|unit|vehicle)[ -]?[1-9]", text, re.I)
    return {code: f"VOI {n}" if other else f"V{n}" for n, code in enumerate(own, 1)}


def _again(text: str, names: dict[str, str]) -> list[Replacement]:
    codes = "|".join(re.escape(c) for c in sorted(names, key=len, reverse=True))
    pattern = re.compile(
        rf"(?<![\w:./+-])(?:participant |party |driver |vehicle |car )?(?P<code>{codes})"
        r"(?![\w-]|[:./]\d|\s?(?:m|s|km|km/h|mph|h)\b)",
        re.I,
    )
    return [(m.start(), m.end(), names[m["code"].lower()]) for m in pattern.finditer(text)]


def _of_each(match: re.Match[str], each: list[str], names: dict[str, str]) -> str:
    """What a line says of several codes, of each of them in turn."""
    lead = re.sub(r"^(?:two|three|the)\s+", "", match["lead"], flags=re.IGNORECASE)
    noun = _singular().get(match["noun"].lower(), match["noun"])
    rest, queued = ROW.subn("", match["rest"])
    rest, abreast = ABREAST.subn("", rest)
    where = "behind" if queued else "alongside" if abreast else ""
    for start, end, new in reversed(_again(rest, names)):
        rest = rest[:start] + new + rest[end:]
    rest = re.sub(r"^,\s*", "", rest)
    said = []
    for n, name in enumerate(each):
        place = f"{where} {each[n - 1]}, " if where and n else ""
        said.append(f"{name}: {lead}{noun}. {name} {place}{rest.lstrip()}".rstrip(" .;"))
    return ". ".join(said)
