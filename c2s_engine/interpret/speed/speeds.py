"""Whose each speed is."""

import re

from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.speed.comparisons import compared_speeds, is_difference
from c2s_engine.interpret.speed.owners import explicit_owner, named_before
from c2s_engine.interpret.speed.ratios import speeds_by_ratio
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import VEHICLES, Entity

SIDEWAYS = re.compile(r"\b(?:lateral|sideways|sideward|wind|yaw)\s+(?:\w+\s+){0,6}$")
TOLERATED = re.compile(r"(?:\b(?:within|(?:tolerance|accuracy|error) of|deviat\w+ (?:of|by|less than))|±|\+/-) ?$")
"""What stands before how much a speed may be off."""
AT_LIMIT = re.compile(
    r"\bat (?:the |a |its )?(?:posted|legal|permitted|signed|speed limit|limit)( speed)?( limit)?( of)?\s*$"
)
NAMED = re.compile(
    r"\bv_?(?:(?P<ego>e|ego|vut|sv|host|e0|0)|(?P<other>o|obj|o0|t|tv|target|lead|lv|1|gvt))\s*(?:=|:|in|of)\s*$"
)
HEADED = re.compile(
    r"\s*,?\s*(?:(?:which|who) was )?(?:(?:travell?ing|driving|heading|going) )?(?:(?:due )?(?:north|south|east|west)"
    r"(?:bound)?|[nsew]/?b) at (?:(?:about|around|roughly|approximately|an? (?:estimated|speed of)|some) )?"
)
"""Whose heading is told before a speed: "turned across the path of V1, northbound at 40 mph"."""
COMPARED_WITH = re.compile(r"\b(?:than|as) (?:the |an? )?$")
FASTEST_ON_FOOT = 8.5
ALL_AT = re.compile(
    r"\bspeeds(?: (?:of|are|were|at|around|about|is|being|each))*[: ]*$|(?:^|[.,;:(#] ?|\band )"
    r"(?:all|both|everybody|everyone)(?: (?:of them|are|at|do|doing|drive|driving|go|going|with|cars|vehicles))* $"
)
"""What stands before the speed of all who drive."""
AT_REST = frozenset(("stationary", "stop", "brake", "brake_stop", "held_up", "yield"))
REACHED = re.compile(
    r"(?:to|down to)\s*(?:(?:a |the |its )?(?:(?:final|new|constant|lower|reduced|target|residual|steady) )?"
    r"(?:speed|velocity)(?: of)? )?(?:about |around |roughly |only |just )?$"
)
"""What stands before a speed that is reached, not had at first."""
FILLS = re.compile(r"\b(?:occup|block|fill|obstruct|cover)\w* (?:up )?both lanes\b[^.;]*$")


def speeds(scene: Scene, quantities: list[scan.Span]) -> None:
    """Whose each speed is: the agent of the clause it stands in, the noun that it describes, or both parties."""
    clauses, cast = scene.clauses, scene.cast
    by_span = {id(w.span): w for w in scene.words if w.span is not None and w.span.kind == "quantity"}
    for span in quantities:
        if span.data["dimension"] != "speed" or SIDEWAYS.search(scene.plain[max(0, span.start - 40) : span.start]):
            continue
        if span.data.get("role") == "limit" and not AT_LIMIT.search(scene.plain[max(0, span.start - 40) : span.start]):
            continue
        if is_difference(scene.plain, span):
            continue
        word = by_span.get(id(span))
        if word is None or TOLERATED.search(scene.plain[max(0, span.start - 20) : span.start]):
            continue
        unit = word
        owner = _before(scene, span) or _beside(scene, span) or _speed_owner(scene, unit.i)
        runs = span.data.get("each", ())
        row = runs if len(runs) > 2 else (span.data["low"], span.data["high"])  # of one: a series of runs
        value = (min(row), max(row), span.start, span.end)
        if owner is not None and owner.person and value[0] > FASTEST_ON_FOOT:
            owner = next((e for e in reversed(named_before(scene, span)) if not e.person), None)
        near = scene.plain[max(0, span.start - 60) : span.start]
        both = bool(re.search(r"\bboth\b[^.;]*$", near) and not FILLS.search(near)) or bool(
            re.search(r"(each|both|same speed) ", scene.plain[span.end : span.end + 20])
        )
        if (everybody := ALL_AT.search(near)) is not None:
            drive = [e for e in scene.actors if e.type in VEHICLES and e.type != "bicycle"]
            drive = drive if everybody[0].startswith("speeds") else [e for e in drive if e in named_before(scene, span)]
            for other in (cast.ego, *drive):
                scene.speeds.setdefault(other, value)
            continue
        like = re.search(r"like (it|the \w+|ego)[^.;,]*$", near)
        if owner is None:
            continue
        event = _event_of(scene, unit.i)
        changing = [
            e
            for e in clauses.events
            if e.agent is owner
            and e.act in ("brake", "brake_stop", "accelerate")
            and e.word < unit.i
            and scene.words[e.word].sentence == word.sentence
        ]
        if "second" in span.data and changing:
            changing[-1].quantities = [
                *changing[-1].quantities,
                {
                    "dimension": "speed",
                    "low": span.data["second"],
                    "high": span.data["second"],
                    "role": "target",
                    "start": span.start,
                },
            ]
            scene.speeds.setdefault(owner, (span.data["first"], span.data["first"], span.start, span.end))
            continue
        if (
            event is not None
            and event.agent is owner
            and event.act in ("brake", "brake_stop", "accelerate")
            and REACHED.search(near) is not None
        ):
            if _had_by_then(scene, event):
                event.act = "travel"
                scene.speeds.setdefault(owner, value)
                continue
            event.quantities = [{**q, "role": "target"} if q["start"] == span.start else q for q in event.quantities]
            continue
        if owner in scene.speeds:
            between = [
                j
                for j in sorted(cast.of)
                if scene.speeds[owner][3] <= scene.words[j].start < span.start
                and cast.of[j] is not owner
                and (cast.of[j].mover or cast.of[j].ego)
            ]
            if between and scene.words[between[-1]].sentence == word.sentence:
                scene.speeds.setdefault(cast.of[between[-1]], value)
                continue
        scene.speeds.setdefault(owner, value)
        subject_also = event.also if event is not None else []
        for other in subject_also:
            scene.speeds.setdefault(other, value)
        if both or like:
            scene.speeds.setdefault(cast.ego, value)
            others = [e for e in scene.actors if e.type in VEHICLES]
            told = [scene.words[m.word].sentence for e in others for m in e.mentions[:1]]
            many = 2 if told[:2] == [word.sentence, word.sentence] else 1
            for other in others[:many]:
                scene.speeds.setdefault(other, value)
    for part in (e for e in scene.actors if e.group in scene.speeds):
        assert part.group is not None
        scene.speeds.setdefault(part, scene.speeds[part.group])
    compared_speeds(scene, quantities)
    speeds_by_ratio(scene)


def _had_by_then(scene: Scene, event: Event) -> bool:
    """Whether a change of speed was over when the scene begins: "had slowed to 40 km/h when a dog ran out"."""
    word = scene.words[event.word]
    perfect = word.tag in ("VBN", "VBD") and {"had", "has", "have"} & {scene.words[c].norm for c in word.children}
    earlier = (e for e in scene.events(event.agent) if e.word < event.word)
    return bool(perfect) and not any(e.act in ("brake", "brake_stop", "accelerate") for e in earlier)


def _before(scene: Scene, span: scan.Span) -> Entity | None:
    """The owner that stands before a speed in the same stretch between commas, where the verb's subject comes later."""
    near = scene.plain[max(0, span.start - 60) : span.start]
    if (whose := explicit_owner(scene, near)) is not None:
        return whose
    NAMED.search(near)
    if re.search(
        r"\b(?:own|test) speed[^.;,]{0,20}$"
        r"|set[- ]speed[^.;]*$|\b(system|alks|dcas|aebs|acc|cruise control)\b(?! (vehicle|car))[^,.;]*$",
        near,
    ) and not re.search(r"whose", near[-20:]):
        return scene.cast.ego
    return None


def _beside(scene: Scene, span: scan.Span) -> Entity | None:
    """The road user right before a speed: "in front of the ego at 100 km/h"."""
    for i, entity in scene.cast.of.items():
        word = scene.words[i]
        if word.span is None or word.end > span.start or span.start - word.end > 44:
            continue
        between = scene.plain[word.end : span.start]
        if HEADED.fullmatch(between) and word.dep == "pobj":
            return entity
        if len(between) > 24:
            continue
        if re.fullmatch(
            (
                r"\s*,?\s*(at|doing|going|travell?ing at|driving at|moving at)\s*(about |around |roughly "
                r"|approximately |only |just )?"
            ),
            between,
        ):
            compared = COMPARED_WITH.search(scene.plain[max(0, word.start - 12) : word.start])
            slow = not entity.ego and "slow" in entity.roles and entity.mover and not entity.person
            if compared and "," not in scene.plain[word.end : span.start] or slow:
                return entity
            verb = scene.clauses._governor(word)
            event = scene.clauses.by_word.get(verb.i) if verb is not None else None
            if event is None or event.agent is entity or not _fast_enough(scene, event, span):
                return entity
            return None
    return None


def _fast_enough(scene: Scene, event: Event, span: scan.Span) -> bool:
    """Whether a speed after the one whom a verb is about is its doer's: "crosses the path of the ego at 15 km/h", but
    not "stands in front of the ego at 60 km/h" nor "a child runs in front of the ego at 60 km/h"."""
    if event.act in AT_REST or event.agent in scene.speeds:
        return False
    slow = event.agent.type in ("bicycle", "animal")
    fastest = 13.0 if slow else 4.5 if event.agent.person else None
    return fastest is None or span.data["low"] <= fastest


def _event_of(scene: Scene, i: int) -> Event | None:
    return next((e for e in scene.clauses.events if i in e.words), None)


def _speed_owner(scene: Scene, i: int) -> Entity | None:
    words, cast = scene.words, scene.cast
    current = words[i]
    for _ in range(8):
        if current.i in scene.clauses.by_word:
            event = scene.clauses.by_word[current.i]
            agent, _, passive = scene.clauses._subject(current) if current.verb else (event.agent, None, False)
            moved = event.patient if event.passive and event.act == "travel" else None  # "V2 is driven at .. by"
            first = moved is not None and any(m.word < current.i for m in moved.mentions)
            return moved if first else event.agent
        if current.verb or scene.clauses._is_verb(current):
            agent, _, passive = scene.clauses._subject(current)
            if agent is not None:
                return agent
        owner = cast.referent(current.i) if current.i != i else None
        if owner is not None and (owner.mover or owner.ego):
            return owner
        if current.head == current.i:
            break
        current = words[current.head]
    before = [
        j
        for j in sorted(cast.of)
        if j < i and words[j].sentence == words[i].sentence and (cast.of[j].mover or cast.of[j].ego)
    ]
    before = [j for j in before if words[j].dep not in ("poss", "compound")] or before  # "a truck in ego's lane at ..."
    if before:
        return cast.of[before[-1]]
    after = [
        j
        for j in sorted(cast.of)
        if j > i and words[j].sentence == words[i].sentence and (cast.of[j].mover or cast.of[j].ego)
    ]
    return cast.of[after[0]] if after else cast.ego
