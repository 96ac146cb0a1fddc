"""Limits that a change demands or lifts: "ego must not brake harder than 6 m/s2". The run is judged by them."""

import re
from collections.abc import Sequence

from c2s_engine.interpret.changes.forms import Found, quantity_of
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.changes.scene_context import read, scene
from c2s_engine.interpret.reading import scan
from c2s_engine.structure import sentences as describe
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.specs import Limit, RestrictionsSpec

CONTACT = re.compile(
    r"touch(?:es|ed|ing)?|hits?|hitting|collid(?:e|es|ed|ing)|collisions?|contacts?|crash(?:es|ed|ing)?|strik(?:e|es|ing)"
)
_UNTOUCHED = re.compile(
    r"(?:(?:and|but|so|please|also) )*(?P<subject>(?:(?:the|my) )?§ )?"
    r"(?:(?:must|should|shall|may|can|will|do|does|has to|have to|is to|needs to|there|be) )*"
    r"(?:not|never|no|cannot|avoids?|avoiding)(?: (?:be|is|to|allowed|permitted|ever|have|make|come|into|any|an?))* "
    rf"(?:{CONTACT.pattern})(?: (?:with|into|against))?"
    r"(?: (?:(?:the|my) )?§(?: (?:and|or) (?:(?:the|my) )?§)*| (?:any|no)(?:body|one)(?: else)?| anything)?"
)
"""That somebody (§) does not touch others, and nothing else."""
_LIFTED = re.compile(
    r"\b(?P<verb>remove|delete|drop|lift|cancel|forget|without|no longer|take (?:away|out|off|back))\b"
    r"[^.;]*?\b(?P<limit>limits?|restrictions?|bounds?|bans?)\b"
)
_SMALL = frozenset(
    ("the", "a", "an", "this", "that", "my", "of", "on", "for", "all", "every", "both", "do", "does", "not", "to",
     "and", "with", "any", "it", "must", "should", "becom")
)  # fmt: skip


def bound(clause: str, structure: Structure) -> Found | None:
    """The limit of an acceleration that the clause tells amid the scene; it replaces one of the same kind."""
    if quantity_of(clause, "acceleration") is None:
        return None
    told = read(f"{scene(structure, clause)} {clause[:1].upper()}{clause[1:]}.")
    if told is None or len(told.objects) != len(structure.objects):
        return None
    ids = {a.id: b.id for a, b in zip(told.objects, structure.objects, strict=True)}
    limits = [m.model_copy(update={"subject": ids.get(m.subject, m.subject)}) for m in _limits(told)]
    if not limits:
        return None
    kept = [m for m in _limits(structure) if (m.kind, m.subject) not in {(n.kind, n.subject) for n in limits}]
    return [SetField(component="T", path="limits", value=(*kept, *limits))], _limits_text(limits, structure)


KINDS = (
    (r"lateral acceleration", "lateral_acceleration", "acceleration"),
    (r"deceleration|braking", "deceleration", "acceleration"),
    (r"acceleration", "acceleration", "acceleration"),
    (r"time[ -]to[ -]collision|ttc", "ttc", "time"),
    (r"gap|distance|headway|keeps? (?:always )?at least", "gap", "distance"),
)
"""What can be bounded, by the nouns for it, and of which dimension its numbers are."""
LOWER = (
    r"\b(?:(?:not|never) (?:\w+ )?(?:below|under|less than|smaller than|shorter than)|at least"
    r"|no(?:t)? (?:less|smaller) than|minimum|above|over)\b"
)
UPPER = (
    r"\b(?:(?:not|never) (?:\w+ )?(?:above|over|exceed|more than|larger than)|at most"
    r"|no(?:t)? more than|maximum|limit(?:ed)?|restrict(?:ed)?|below|under|up to)\b"
)
OBLIGED = (
    r"\b(?:must|should|shall|may|has to|never|limit(?:ed)?|restrict(?:ed)?|maximum|minimum|keep|stays?|remains?)\b"
)


def bounded(clause: str, structure: Structure) -> Found | None:
    """ "Limit ego's deceleration to 5 m/s2", "the time to collision must not fall below 1.5 s": a quantity and its
    bound; it replaces one of the same kind."""
    kind = next(((k, d) for find, k, d in KINDS if re.search(rf"\b(?:{find})\b", clause)), None)
    far = quantity_of(clause, kind[1]) if kind is not None else None
    lower, upper = re.search(LOWER, clause), re.search(UPPER, clause)
    if kind is None or far is None or not re.search(OBLIGED, clause) or not (lower or upper):
        return None
    if kind[0] == "gap" and not re.search(r"\b(?:never|not|always|all along|at any time|keeps? at least)\b", clause):
        return None  # where somebody is
    value = round(far["low"], 2)
    names = [s for s in scan.names(clause) if s.kind in ("actor", "ego", "label")]
    meant = [refer(f"the {clause[s.start : s.end]}", structure, alone=False) for s in names]
    there = list(dict.fromkeys("ego" if c.id == "E" else c.id for c in meant if c is not None))
    of_two = kind[0] in ("ttc", "gap")
    subject = there[0] if there and (not of_two or len(there) > 1) else "ego"
    other = next((c for c in there if c != subject), None) if of_two else None
    limit = Limit.model_validate(
        {"kind": kind[0], "subject": subject, "other": other, "minimum" if lower else "maximum": value}
    )
    kept = [m for m in _limits(structure) if (m.kind, m.subject, m.other) != (limit.kind, subject, other)]
    return [SetField(component="T", path="limits", value=(*kept, limit))], _limits_text([limit], structure)


def allowed(clause: str, structure: Structure) -> Found | None:
    """ "Ego may touch the truck": that it must not holds no longer, where that is a limit."""
    match = re.match(
        rf"(?P<who>.+?) (?:may|is allowed to|is permitted to) (?P<not>not )?(?P<does>{CONTACT.pattern}) ?(?P<whom>.*)$",
        clause,
    )
    subject = refer(match["who"], structure, alone=False) if match and not match["not"] else None
    if match is None or subject is None:
        return None
    other = refer(match["whom"], structure, alone=False)
    both = {"ego" if c.id == "E" else c.id for c in (subject, other) if c is not None}
    meant = [m for m in _limits(structure) if m.kind == "collision" and {m.subject, m.other or m.subject} <= both]
    if not meant:
        return [], f"no limit forbids what “{clause}” allows"
    kept = tuple(m for m in _limits(structure) if m not in meant)
    return [SetField(component="T", path="limits", value=kept)], f"no longer: {_limits_text(meant, structure)}"


def contact(clause: str, structure: Structure) -> Found | None:
    """That somebody must not touch somebody else, or anybody: a limit beside those that there are."""
    spans = [s for s in scan.names(clause) if s.kind in ("actor", "ego", "label")]
    plain = clause
    for span in reversed(spans):
        plain = f"{plain[: span.start]}§{plain[span.end :]}"
    if not (said := _UNTOUCHED.fullmatch(plain)):
        return None
    meant = [refer(f"the {clause[s.start : s.end]}" if s.kind == "actor" else clause[s.start : s.end], structure,
                   alone=False) for s in spans]  # fmt: skip
    there = ["ego" if c.id == "E" else c.id for c in meant if c is not None]
    if len(there) < len(meant):
        return None
    subject = there.pop(0) if said["subject"] else "ego"
    others: list[str | None] = [*there] or [None]
    limits = [Limit(kind="collision", subject=subject, other=other) for other in others if other != subject]
    if not limits:
        return None
    old = _limits(structure)
    new = [m for m in limits if m not in old]
    return [SetField(component="T", path="limits", value=(*old, *new))], _limits_text(limits, structure)


def lifted(clause: str, structure: Structure) -> Found | None:
    """That a limit of T holds no longer: the one whose words the demand has, or the only one."""
    if not (said := _LIFTED.search(clause)) or not (limits := _limits(structure)):
        return None
    rest = clause.replace(said["limit"], " ")
    words = set(re.findall(r"\w+", f"{rest[: said.start()]} {rest[said.start() :].replace(said['verb'], ' ', 1)}"))
    wanted = {_stem(w) for w in words} - _SMALL
    shared = [len(wanted & {_stem(w) for w in re.findall(r"\w+", _words_of(m, structure).lower())}) for m in limits]
    most = max(shared)
    if wanted and not most:
        return None  # of another kind of limit: of the road
    meant = [m for m, n in zip(limits, shared, strict=True) if n == most]
    if len(meant) > 1 and not re.search(r"\b(?:all|every|both|limits|restrictions)\b", clause):
        return [], f"say which limit: {'; '.join(_words_of(m, structure) for m in meant)}"
    kept = tuple(m for m in limits if m not in meant)
    return [SetField(component="T", path="limits", value=kept)], f"no longer: {_limits_text(meant, structure)}"


def _limits(structure: Structure) -> tuple[Limit, ...]:
    spec = structure.restrictions.spec
    assert isinstance(spec, RestrictionsSpec)
    return spec.limits


def _limits_text(limits: Sequence[Limit], structure: Structure) -> str:
    return "; ".join(_words_of(limit, structure) for limit in limits)


def _words_of(limit: Limit, structure: Structure) -> str:
    return describe.limit(limit, {c.id: spec_of(c).name for c in structure.objects})


def _stem(word: str) -> str:
    """A word without its ending: brakes, braking, hit and hitting; what tells of a contact is one word."""
    if CONTACT.fullmatch(word):
        return "touch"
    return re.sub(r"(?:ing|ed|es|s|e)$", "", word) if len(word) > 3 else word
