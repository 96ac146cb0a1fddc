"""For whom ego waits: it gives way to that one."""

from __future__ import annotations

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast


def waited_for(cast: Cast, clauses: Clauses) -> None:
    """Let ego give way for whom it waits, or who has priority over it."""
    _until_passed(cast, clauses)
    _for_somebody(clauses)


WAITS = re.compile(
    r"(?:wait|stays? put|hold|remain|pause|stops?|(?:not|n't|never) (?:\w+ )?(?:move|start"
    r"|turn|go|proceed|pull|enter|set|begin|overtake|change|merge|cross))[^.;]*?\b(?:until|till|for)\b"
    r" (?:\S+ ){0,7}?@(?P<who>a\d+)[^.;]*?\b(?:pass\w*|clear|cross\w*|by|through|past|gone|go"
    r"|goes|first|over|finish\w*)\b"
)


PRIORITY = re.compile(
    r"@(?P<who>a\d+)[^.;]{0,60}?\b(?:have|has|had|with|enjoys?) (?:the )?(?:priority"
    r"|right of way|right-of-way|precedence)"
    r"|(?:priority|precedence|right of way) (?:belongs? to|is with|lies with|of) (?:the |an? )?@(?P<of>a\d+)"
)


def _until_passed(cast: Cast, clauses: Clauses) -> None:
    """Ego waits until another has passed, or another has priority over it: ego gives way, in whatever words."""
    own = [e for e in clauses.events if e.agent.ego and e.done]
    if any(e.act in ("yield", "run_red", "run_stop", "collide") for e in own):
        return
    by_key = {e.key: e for e in cast.entities}
    numbers = sorted({w.sentence for w in cast.words})
    for number in numbers:
        sentence = [w.i for w in cast.words if w.sentence == number]
        text = clauses.render(sentence)
        match = WAITS.search(text)
        right = None if match else PRIORITY.search(text)
        found = match or right
        if found is None:
            continue
        who = by_key.get(found.groupdict().get("who") or "")
        if (
            who is None
            or not who.mover
            or any(e.act in ("run_red", "run_stop") and e.agent is who for e in clauses.events)
        ):
            continue
        first = cast.words[sentence[0]]
        order = (
            min(
                (e.order for e in own if e.act in ("turn", "go_straight", "overtake", "lane_change", "start")),
                default=float(first.i),
            )
            - 0.2
        )
        clauses.events.append(
            Event(
                "yield",
                cast.ego,
                first.i,
                text,
                text,
                who,
                order=order,
                words=[first.i],
                start=first.start,
                end=first.end,
            )
        )
        return


def _for_somebody(clauses: Clauses) -> None:
    """ "Ego must wait", where somebody crosses its way: ego gives way to that one."""
    if any(e.agent.ego and e.done and e.act in ("yield", "collide", "run_red", "run_stop") for e in clauses.events):
        return
    for event in clauses.events:
        if not (event.agent.ego and event.act == "stationary" and event.done and event.text.startswith("wait")):
            continue
        crossing = [
            e.agent
            for e in clauses.events
            if e.done
            and not e.agent.ego
            and e.agent.mover
            and (
                e.act in ("cross_road", "cross_path", "go_straight", "approach", "oncoming")
                and e.word < event.word
                or e.act in ("go_straight", "cross_path", "travel", "overtake", "cross_road")
                and e.adverbial in ("after", "once", "when", "until")
                and event.word < e.word
                and any(o.agent.ego and o.act in ("turn", "go_straight") and o.word > e.word for o in clauses.events)
            )
        ]
        if crossing:
            event.act, event.patient = "yield", crossing[-1]
            return
