"""Speeds told by comparison: "20 km/h slower than the ego", "a little faster", "twice as fast as the van"."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.scene import Scene

COMPARED = re.compile(
    r"(?:(?P<little>a (?:little|tiny|wee) bit|a bit|a little|little bit|slightly|somewhat|marginally|a touch|a shade"
    r"|a tad|barely|only just|moderately)|(?P<lot>much|far|considerably|a lot|way|significantly|substantially|clearly"
    r"|markedly|a good deal))?"
    r"\s*\b(?P<how>faster|slower|quicker|higher|lower|greater|more|less|(?:above|below) the (?=speed))\b"
    r"(?P<than>(?: than| as|speed of) [^,.;]{0,40})?"
)
DIFFERENCE = re.compile(
    r"\b(?:(?:speed|velocity) (?:difference|differential|excess|surplus)|difference (?:in|of) (?:speed|velocity)"
    r"|(?:relative|closing|differential|excess|approach) (?:speed|velocity)|delta[- ]?v)(?: (?:of|is|was|being|at))*"
    r"[: =]*(?:about |around |roughly |at least |at most |more than |less than |not less than |up to |over )?$"
)
AFTER = re.compile(
    r"\s*(?:faster|slower|quicker|(?:higher|lower|greater|more|less) than|(?:above|below) the speed of)\b"
)
RIGHT_BEFORE = re.compile(
    r"(?:,? (?:ahead|in front|behind|beside)(?: of (?:it|the ego|ego))?)?,?(?: at| doing| going)? "
)
"""What stands between a road user and its speed where the verb is left out: "and the car ahead 30 % slower"."""
LITTLE, LOT_MORE, LOT_LESS = 0.08, 1.4, 0.6


def is_difference(plain: str, span: Span) -> bool:
    """Whether a speed is only by how much one is faster or slower than another."""
    after = AFTER.match(plain[span.end : span.end + 20])
    return after is not None or DIFFERENCE.search(plain[max(0, span.start - 50) : span.start]) is not None


def compared_speeds(scene: Scene, quantities: list[Span]) -> None:
    """The speeds that follow from another's by a comparison."""
    for match in COMPARED.finditer(scene.plain):
        number = next((q for q in quantities if q.data["dimension"] == "speed" and _ends_at(scene, q, match)), None)
        if number is None and (not (match["little"] or match["lot"]) or match["how"] in ("more", "less")):
            continue
        owner = owner_of(scene, match.start())
        other = _named(scene, match) or (scene.cast.ego if owner is not scene.cast.ego else None)
        base = scene.speeds.get(other) if other is not None else None
        if owner is None or other is owner or base is None:
            continue
        if owner in scene.speeds and number is None:
            continue
        scene.speeds[owner] = (*_changed(match, number, base[0], base[1]), match.start(), match.end())
    _by_difference(scene, quantities)


SAME = re.compile(
    r"\b(?:at|with|does|do|drives?|having) (?:just |exactly |about )?the same (?:speed|pace|velocity)\b(?! as)"
)


def _by_difference(scene: Scene, quantities: list[Span]) -> None:
    """The speed of one that differs from ego's by so much: who comes up is faster, who is ahead slower."""
    for span in quantities:
        found = DIFFERENCE.search(scene.plain[max(0, span.start - 50) : span.start])
        own = scene.speeds.get(scene.cast.ego)
        if found is None or span.data["dimension"] != "speed" or own is None:
            continue
        free = [e for e in scene.actors if e.mover and not e.person and e not in scene.speeds]
        owner = owner_of(scene, span.start)
        other = owner if owner in free else free[0] if len(free) == 1 else None
        if other is None:
            continue
        change = -span.data["low"]
        scene.speeds[other] = (max(0.0, own[0] + change), max(0.0, own[1] + change), span.start, span.end)


def _ends_at(scene: Scene, span: Span, match: re.Match[str]) -> bool:
    return span.end <= match.start("how") and not scene.plain[span.end : match.start("how")].strip(" ,-")


def _changed(match: re.Match[str], number: Span | None, low: float, high: float) -> tuple[float, float]:
    if number is not None:
        change = _difference(match, number)
        return max(0.5, low + change), max(0.5, high + change)
    more = _more(match)
    factor = 1 + LITTLE if more else 1 - LITTLE
    return low * factor, high * factor


def _more(match: re.Match[str]) -> bool:
    return match["how"] not in ("slower", "lower", "less") and not match["how"].startswith("below")


def _difference(match: re.Match[str], number: Span) -> float:
    return number.data["low"] if _more(match) else -number.data["low"]


def owner_of(scene: Scene, at: int) -> Entity | None:
    """Who is said to be faster: the subject of the clause, else who was spoken of last in the sentence."""
    word = next((w for w in scene.words if w.start <= at + 1 < w.end or w.start >= at), None)
    if word is None:
        return None
    event = next((e for e in reversed(scene.clauses.events) if word.i in e.words), None)
    own = [i for i in sorted(scene.cast.of) if i < word.i and scene.words[i].sentence == word.sentence]
    for i in own[-2:]:
        entity = scene.cast.of[i]
        if event is not None and event.patient is entity and "," not in scene.plain[event.start : scene.words[i].start]:
            continue
        if (entity.mover or entity.ego) and RIGHT_BEFORE.fullmatch(scene.plain[scene.words[i].end : at]):
            return entity
    if event is not None and event.agent in [scene.cast.of[i] for i in own]:
        relative = [i for i in own if i > event.word and scene.words[i].norm in ("which", "that", "who")]
        return scene.cast.of[relative[-1]] if relative else event.agent
    movers = [i for i in own if scene.cast.of[i].mover or scene.cast.of[i].ego]
    return scene.cast.of[movers[-1]] if movers else None


def _named(scene: Scene, match: re.Match[str]) -> Entity | None:
    """Whom one is compared with."""
    if match["than"] is None:
        return None
    start, end = match.span("than")
    inside = [i for i in sorted(scene.cast.of) if start <= scene.words[i].start < end]
    return scene.cast.of[inside[0]] if inside else None
