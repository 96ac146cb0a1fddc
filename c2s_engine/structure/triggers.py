"""Triggers in words, and which of them say of themselves whom they watch."""

from c2s_engine.structure.quantity import high, in_words, low
from c2s_engine.structure.specs import EgoSpec, Trigger

_KINDS = ("apart", "passed", "speed", "light", "seen", "contact")
_PLACES = ("stop_line", "in_intersection", "past_intersection", "bend")


def is_watched(t: Trigger, actor: str | None = None) -> bool:
    """Whether a trigger reads the same whatever waits for it: it watches something else than the way of `actor`, who
    waits, to whom it names. The others depend on what is done then."""
    return t.kind in _KINDS or t.place in _PLACES or t.subject not in (None, actor)


def other_of(t: Trigger, actor: str, first: str) -> str:
    """To whom a trigger of `actor` watches its subject, where it is one of two: whom it names; else who waits, or, if
    that is the subject, ego, and for ego the `first` object."""
    subject = t.subject or actor
    return t.of or (actor if subject != actor else first if actor == "ego" else "ego")


def gives_way_by(ego: EgoSpec) -> bool:
    """Whether ego's own phases say how it gives way to whom it yields: they wait for how far that one has come."""
    watched = [t for p in ego.phases for t in (p.trigger, p.until) if t and t.kind in ("passed", "ttc", "distance")]
    names = {name for t in watched for name in (t.subject, t.of)} - {None, "ego"}
    return ego.reaction == "yield" and bool(names) and ego.react_to in {None, *names}


def clause(t: Trigger, one: str, other: str) -> str:
    """What a trigger watches, in words; `one`, `other`: how its subject and the other are called."""
    value = f"{low(t.value):g}" if t.value is not None else "some"
    value += f" to {high(t.value):g}" if t.value is not None and high(t.value) > low(t.value) else ""
    action, place = (t.action or "").replace("_", " "), (t.place or "").replace("_", " ")
    patterns = {
        "distance": f"{one} is {value} m from {other}", "apart": f"{one} is as far as {value} m from {other}",
        "ttc": f"{one} is {value} s from {other}",
        "time": f"{value} {'s have' if t.value is not None else 'time has'} passed",
        "action": f"{other}: {action} begins", "passed": f"{one} has gone by {other}",
        "speed": f"{one} goes at {in_words('speed', t.value) if t.value is not None else 'some speed'}",
        "light": f"the light before {one} is {t.light}", "seen": f"{one} can see {other}",
        "contact": f"{one} and {other} touch", "place": f"{one} is {value} m before the {place}",
    }  # fmt: skip
    inside = {"in_intersection": "in", "past_intersection": "past"}.get(t.place or "")
    said = f"{one} is {inside} the intersection" if inside else patterns[t.kind]
    if t.kind == "place" and not inside and (t.value is None or high(t.value) == 0):
        said = f"{one} is at the {place}"
    return said + (f", and {low(t.delay):g} s later" if t.delay is not None else "")
