"""Fifth stage: the scene as a whole. Who is ego where nobody is called so, which entities matter, who does what."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re
from dataclasses import dataclass, field

from c2s_engine.interpret import environment, language, place, scan, syntax
from c2s_engine.interpret.clauses import Clauses, Event
from c2s_engine.interpret.mentions import MOTOR, VEHICLES, ZONES, Cast, Entity
from c2s_engine.interpret.place import Road
from c2s_engine.interpret.relations import Places, Where, side_of_text
from c2s_engine.interpret.settings import Settings, SettingsDetector

ACTIVE = frozenset(
    [
        "brake",
        "brake_stop",
        "stop",
        "accelerate",
        "start",
        "lane_change",
        "cut_in",
        "cut_out",
        "overtake",
        "follow",
        "swerve",
        "drift",
        "turn",
        "u_turn",
        "go_straight",
        "cross_road",
        "move_along",
        "enter_road",
        "leave_road",
        "reverse",
        "oncoming",
        "run_red",
        "run_stop",
        "yield",
        "lose_control",
        "collide",
        "cross_path",
        "approach",
        "keep_lane",
        "evade",
        "travel",
        "stationary",
        "lead",
        "held_up",
        "pass_by",
    ]
)


@dataclass
class Scene:
    """Everything that was understood of a text, before it becomes specs."""

    text: str
    plain: str
    sentences: list[tuple[int, int]]
    words: list[syntax.Word]
    cast: Cast
    clauses: Clauses
    places: Places
    road: Road
    settings: Settings
    light: list[environment.Found]
    actors: list[Entity] = field(default_factory=list)
    speeds: dict[Entity, tuple[float, float, int, int]] = field(default_factory=dict)
    spans: list[scan.Span] = field(default_factory=list)

    def events(self, entity: Entity) -> list[Event]:
        """What the entity is said to do, in order, without what is denied or only imagined."""
        return [
            e for e in self.clauses.events if (e.agent is entity or entity in e.also) and e.done and e.act in ACTIVE
        ]

    def does(self, entity: Entity, *acts: str) -> Event | None:
        """The first event of that entity with one of those acts."""
        return next((e for e in self.events(entity) if e.act in acts), None)

    def where(self, entity: Entity) -> Where:
        return self.places.of.get(entity) or Where()


def understand(text: str) -> Scene:
    """All stages up to the scene."""
    plain = scan.normalised(text)
    sentences = scan.sentences(text)
    quantities = scan.quantities(plain)
    quantities += [
        b for b in scan.bare_speeds(plain) if not any(q.start < b.end and b.start < q.end for q in quantities)
    ]
    quantities.sort(key=lambda s: s.start)
    names = scan.names(plain)
    taken = [(q.start, q.end) for q in quantities]
    names = [n for n in names if not any(s < n.end and n.start < e for s, e in taken)]
    spans = sorted(names + quantities, key=lambda s: s.start)
    sentences = scan.shorthand(plain, sentences, names)
    road = place.read(plain, sentences, quantities)
    words = syntax.parse(text, plain, sentences, spans)
    cast = Cast(words)
    clauses = Clauses(words, cast)
    _choose_ego(cast, clauses)
    places = Places(cast, clauses)
    _rules_of_sense(cast, clauses, road)
    settings = SettingsDetector().detect(plain, sentences)
    light = environment.light(plain, sentences)
    scene = Scene(text, plain, sentences, words, cast, clauses, places, road, settings, light, spans=spans)
    scene.actors = _actors(scene)
    _speeds(scene, quantities)
    return scene


ROLE_WORDS = frozenset(("lead", "oncoming", "parked", "stationary", "crossing", "adjacent", "cut_in", "slow"))
EGO_LIKE = frozenset(
    (
        "travel",
        "turn",
        "go_straight",
        "lane_change",
        "lose_control",
        "leave_road",
        "run_red",
        "run_stop",
        "reverse",
        "follow",
        "overtake",
        "drift",
        "approach",
        "collide",
        "keep_lane",
        "brake",
        "yield",
        "oncoming",
        "u_turn",
        "brake_stop",
        "stop",
        "swerve",
        "enter_road",
        "start",
        "accelerate",
    )
)


def _choose_ego(cast: Cast, clauses: Clauses) -> None:
    """Where nobody is called ego: the vehicle that the text is about, if there is one besides the others."""
    if cast.ego.mentions:
        return
    vehicles = [e for e in cast.entities if e.type in MOTOR and e.count == 1]
    acting = {e: [v for v in clauses.events if v.agent is e and v.done] for e in vehicles}
    candidates = []
    for entity in vehicles:
        first = " ".join(w.norm for w in cast.words[entity.mentions[0].word : entity.mentions[0].word + 7])
        if (
            entity.roles & ROLE_WORDS
            or any(
                v.act == "overtake" and (v.patient is None or v.patient.type not in VEHICLES) for v in acting[entity]
            )
            or "following" not in entity.roles
            and re.search(
                r"^\S+( \S+)? (ahead|in front|in the (left|right|adjacent|next|oncoming)|coming|approaching|oncoming|from (the|its|behind))",
                first,
            )
        ):
            continue
        head = cast.words[entity.mentions[0].word]
        before = cast.words[head.i - 1].norm if head.i else ""
        if before in ("another", "other") or any(cast.words[c].norm in ("another", "other") for c in head.children):
            continue
        acts = [v.act for v in acting[entity]]
        if not acts and not any(v.patient is entity for v in clauses.events):
            continue
        if acts and not EGO_LIKE & set(acts):
            continue
        if (
            {"cut_in", "enter_road"} & set(acts)
            or (acts and all(a == "stationary" for a in acts))
            or any(v.act == "reverse" and re.search(r"driveway|parking|garage", v.whole) for v in acting[entity])
        ):
            continue
        if (
            any(
                v.passive and v.patient is not None
                for v in clauses.events
                if v.agent is entity and v.act == "stationary"
            )
            or cast.words[entity.mentions[0].word - 1 if entity.mentions[0].word else 0].norm == "by"
        ):
            continue
        if (
            cast.words[entity.mentions[0].word].dep == "pobj"
            and cast.words[cast.words[entity.mentions[0].word].head].dep == "agent"
            and not acts
        ):
            continue
        candidates.append(entity)
    if not candidates:
        return
    generic = [e for e in candidates if e.noun == "vehicle"]
    if generic and "the" in [
        w.norm for w in cast.words[max(0, generic[0].mentions[0].word - 2) : generic[0].mentions[0].word]
    ]:
        candidates = generic
    others = [e for e in cast.entities if e not in candidates]
    best = next((e for e in candidates if "following" in e.roles), candidates[0])
    hit = {v.patient for v in clauses.events if v.act in ("collide", "overtake", "follow", "yield") and v.agent is best}
    if (
        len(candidates) == 1
        and not others
        and any(v.act in ("brake", "cut_in", "enter_road") for v in acting[best])
        and not hit
    ) and re.search(r"\b(in front|ahead)\b", " ".join(w.norm for w in cast.words)):
        return
    plain = " ".join(w.norm for w in cast.words)
    implied = re.search(
        r"\b(coming|comes) (the other way|towards)|\boncoming\b|opposite (direction|lane)|other direction", plain
    )
    if implied and best.mentions[0].word > 6 and best is not (generic[0] if generic else None):
        return
    cast.entities.remove(best)
    if best.type != "vehicle":
        cast.ego.type, cast.ego.typed = best.type, True
    cast.ego.mentions = best.mentions
    for i, entity in list(cast.of.items()):
        if entity is best:
            cast.of[i] = cast.ego
    for event in clauses.events:
        event.text = re.sub(rf"@{best.key}\b", "@ego", event.text)
        event.whole = re.sub(rf"@{best.key}\b", "@ego", event.whole)
        event.agent = cast.ego if event.agent is best else event.agent
        event.patient = cast.ego if event.patient is best else event.patient
        event.also = [cast.ego if a is best else a for a in event.also]


def _actors(scene: Scene) -> list[Entity]:
    """The entities that belong to the scene: those that do something, are somewhere, or have something done to them."""
    kept = []
    for entity in scene.cast.entities:
        own = scene.events(entity)
        where = scene.where(entity)
        passive = [e for e in scene.clauses.events if e.patient is entity and e.done]
        if "group" in entity.roles or _mere_background(scene, entity):
            continue
        if (
            entity.label
            and len(scene.cast.entities) <= 6
            and (len(scene.cast.entities) == 1 or own or passive or where.rel or where.lane or entity.roles)
            or entity.person
            and entity.noun not in ("somebody", "someone", "people")
            and _seen(scene, entity)
        ):
            kept.append(entity)
            continue
        if entity.person and where.hidden_by is not None:
            kept.append(entity)
            continue
        if (
            not own
            and not passive
            and not entity.roles
            and where.rel is None
            and where.lane is None
            and not _mentioned_alone(scene, entity)
        ):
            continue
        if entity.noun == "traffic" and any(
            e is not entity and (e.roles & entity.roles or scene.where(e).lane == where.lane is not None)
            for e in scene.cast.entities
        ):
            continue
        if (
            not own
            and entity.type in ("vehicle", "pedestrian")
            and entity.count > 1
            and where.rel is None
            and where.lane is None
        ):
            continue
        only_denied = [e for e in scene.clauses.events if e.agent is entity or e.patient is entity]
        if (
            only_denied
            and not own
            and not passive
            and where.rel is None
            and where.lane is None
            and not entity.roles
            and entity.type not in ZONES
        ):
            continue
        kept.append(entity)
    for entity in list(kept):
        blocker = scene.where(entity).hidden_by
        if blocker is not None and blocker not in kept:
            if not scene.events(blocker):
                blocker.roles.add("stationary")
            kept.append(blocker)
    generic = [
        e
        for e in kept
        if e.noun
        in (
            "obstacle",
            "obstruction",
            "hazard",
            "object",
            "obstacles",
            "objects",
            "hazards",
            "road user",
            "blockage",
            "stationary object",
            "vehicle",
            "vehicles",
            "road users",
            "actor",
            "obstacle vehicle",
        )
    ]
    for entity in generic:
        specific = [
            e
            for e in kept
            if e is not entity and (e.type != "vehicle" or entity.noun != "vehicle") and e not in generic
        ]
        same = [e for e in specific if entity.type == "obstacle" or e.type in VEHICLES]
        if (
            same
            and not [e for e in scene.events(entity) if e.act not in ("travel", "approach", "stationary")]
            and (entity.type == "obstacle" or entity.count > 1)
        ):
            kept.remove(entity)
            _pass_on(scene, entity, [e for e in same if e.mentions[0].word > entity.mentions[0].word])
    return kept


def _mere_background(scene: Scene, entity: Entity) -> bool:
    """Whether a queue is only the setting ("in a jam") or its cars are named one by one."""
    if entity.noun not in language.table("actors")["queues"]:
        return False
    for mention in entity.mentions:
        head = scene.words[scene.words[mention.word].head]
        if scene.words[mention.word].dep == "pobj" and head.norm in ("in", "during", "within"):
            return True
    return any(
        e is not entity and e.type in VEHICLES and (e.count > 1 or "stationary" in e.roles) and e.noun not in language.table("actors")["queues"]
        and ("stationary" in e.roles or any(v.act in ("stationary", "stop") for v in scene.events(e)))
        for e in scene.cast.entities
    )


def _pass_on(scene: Scene, generic: Entity, members: list[Entity]) -> None:
    """What was said of "two obstacles" holds for those that are then named one by one."""
    where = scene.where(generic)
    for number, member in enumerate(members):
        own = scene.where(member)
        if any(e.act == "stationary" for e in scene.events(generic)) and not scene.events(member):
            member.roles.add("stationary")
        if own.lane is None and own.rel is None:
            own.lane, own.rel = where.lane, where.rel or "ahead"
        if number == 0 and own.gap is None and where.gap is not None:
            own.gap = where.gap


def _seen(scene: Scene, entity: Entity) -> bool:
    """Whether a person is the object of seeing ("did not see the child")."""
    return any(
        scene.words[scene.words[m.word].head].lemma
        in ("see", "notice", "detect", "spot", "observe", "recognize", "recognise", "overlook", "perceive", "identify")
        for m in entity.mentions
    )


def _mentioned_alone(scene: Scene, entity: Entity) -> bool:
    """A thing that is only named ("debris on the road") is there all the same; a vehicle in passing is not."""
    return (
        entity.type in ZONES
        or any(scene.clauses.fragment(m.word) for m in entity.mentions)
        and (scene.where(entity).rel is not None or scene.where(entity).lane is not None or entity in scene.speeds)
        or (not entity.mover and entity.type not in ("obstacle",))
        or any(
            scene.words[m.word].dep in ("ROOT", "attr", "conj", "nsubj") and scene.words[m.word].span is not None
            for m in entity.mentions
        )
        and (entity.person or entity.type in ("bicycle", "motorcycle"))
        or any(scene.words[m.word].dep == "attr" and scene.words[m.word].span is not None for m in entity.mentions)
        and entity.type in VEHICLES
    )


def _speeds(scene: Scene, quantities: list[scan.Span]) -> None:
    """Whose each speed is: the agent of the clause it stands in, the noun that it describes, or both parties."""
    clauses, cast = scene.clauses, scene.cast
    by_span = {id(w.span): w for w in scene.words if w.span is not None and w.span.kind == "quantity"}
    for span in quantities:
        if span.data["dimension"] != "speed" or span.data.get("role") == "limit":
            continue
        word = by_span.get(id(span))
        if word is None:
            continue
        unit = word
        owner = _before(scene, span) or _beside(scene, span) or _speed_owner(scene, unit.i)
        value = (span.data["low"], span.data["high"], span.start, span.end)
        if owner is not None and owner.noun in language.table("actors")["queues"]:
            owner = None
        near = scene.plain[max(0, span.start - 60) : span.start]
        both = bool(re.search(r"\bboth\b[^.;]*$", near)) or bool(
            re.search(r"(each|both|same speed) ", scene.plain[span.end : span.end + 20])
        )
        like = re.search(r"like (it|the \w+|ego)[^.;,]*$", near)
        if re.search(
            r"(both lanes|all lanes|traffic|jam|queue)\b[^.;,]*(creep|crawl|mov|flow|travel|driv|runs?|progress)[^.;,]*$",
            near,
        ) and (owner is None or not re.search(rf"\b{re.escape(owner.noun or '@@')}\b", near)):
            for other in (cast.ego, *scene.actors):
                if other.ego or other.type in VEHICLES and other.type not in ("motorcycle", "bicycle"):
                    scene.speeds.setdefault(other, value)
            continue
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
        if changing and (
            event is None or event.act not in ("brake", "brake_stop", "accelerate") or changing[-1].word > event.word
        ):
            event = changing[-1]
            if re.search(r"(to|down to)\s*(about |around |roughly )?$", near[-16:]) and not any(
                q["start"] == span.start for q in event.quantities
            ):
                event.quantities = [*event.quantities, {**span.data, "start": span.start, "role": "target"}]
        if (
            event is not None
            and event.agent is owner
            and event.act in ("brake", "brake_stop", "accelerate")
            and re.search(r"(to|down to|from)\s*(about |around |roughly )?$", near[-16:]) is not None
            and "from" not in near[-16:]
        ):
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
            for other in others[:1]:
                scene.speeds.setdefault(other, value)


def _before(scene: Scene, span: scan.Span) -> Entity | None:
    """The owner that stands before a speed in the same stretch between commas, where the verb's subject comes later."""
    near = scene.plain[max(0, span.start - 60) : span.start]
    if re.search(r"set[- ]speed[^.;]*$|\b(system|alks|dcas|aebs|acc|cruise control)\b(?! (vehicle|car))[^,.;]*$", near) and not re.search(
        r"whose", near[-20:]
    ):
        return scene.cast.ego
    return None


def _beside(scene: Scene, span: scan.Span) -> Entity | None:
    """The road user right before a speed: "in front of the ego at 100 km/h"."""
    for i, entity in scene.cast.of.items():
        word = scene.words[i]
        if word.span is None or word.end > span.start or span.start - word.end > 24:
            continue
        if re.fullmatch(
            r"\s*,?\s*(at|doing|going|travell?ing at|driving at|moving at)\s*(about |around |roughly |approximately |only |just )?",
            scene.plain[word.end : span.start],
        ):
            verb = scene.clauses._governor(word)
            event = scene.clauses.by_word.get(verb.i) if verb is not None else None
            if event is not None and event.agent is not entity and _below_verb(scene, word, verb):
                return None
            return (
                None
                if event is not None
                and event.agent is not entity
                and (
                    event.act in ("collide", "overtake", "follow", "approach")
                    or event.act in ("travel", "lead")
                    and word.dep == "pobj"
                    and verb.dep in ("relcl", "ROOT", "acl")
                )
                else entity
            )
    return None


def _below_verb(scene: Scene, word: syntax.Word, verb: syntax.Word | None) -> bool:
    """Whether a noun hangs on a verb by prepositions alone ("runs out from behind the van"), not on another noun."""
    current = word
    for _ in range(5):
        current = scene.words[current.head]
        if verb is None or current.i == verb.i:
            return verb is not None
        if current.i in scene.cast.of or current.tag.startswith("NN"):
            return False
    return False


def _rules_of_sense(cast: Cast, clauses: Clauses, road: Road) -> None:
    """What single clauses cannot tell: a stop that is denied before a stop sign, a pass that is waited for."""
    for event in list(clauses.events):
        if event.act == "stop" and event.mode == "negated":
            sentence = " ".join(w.norm for w in cast.words if abs(w.sentence - cast.words[event.word].sentence) <= 1)
            if re.search(r"stop sign", sentence) and road.stop_sign:
                event.act, event.mode = "run_stop", "fact"
            elif re.search(r"\bred\b|traffic (light|signal)", event.whole + " " + sentence) and re.search(
                r"(fail|not|never|without).{0,30}stop.{0,30}(red|light|signal)", sentence
            ):
                event.act, event.mode = "run_red", "fact"
        if (
            event.mode == "negated"
            and cast.words[event.word].norm in ("move", "moving")
            and event.act in ("travel", "start", "move_along")
        ):
            event.act, event.mode = "stationary", "fact"
        if event.act == "yield" and event.mode == "negated" and not event.agent.ego:
            event.act, event.mode = "cross_path", "fact"
        if event.act == "pass_by":
            junction = road.kind == "intersection" and not re.search(r"lane|left|right|behind", event.whole)
            event.act = (
                "travel"
                if junction or event.agent.ego and event.patient is None and event.adverbial in ("as", "when", "while")
                else "overtake"
            )
        elif (
            event.act == "overtake"
            and event.patient is None
            and road.kind == "intersection"
            and event.text.startswith("pass")
        ):
            event.act = "travel"
        passes = event.act in ("overtake", "travel", "go_straight", "cross_path", "move_along", "cross_road")
        if passes and not event.agent.ego and event.agent.mover and event.mode == "fact":
            word = cast.words[event.word]
            before = " ".join(
                w.norm for w in cast.words[max(0, event.word - 9) : event.word] if w.sentence == word.sentence
            )
            waits = re.search(
                r"(only (after|once|when)|not (before|until|till)|wait(s|ing)? (for|until|till)|must wait|have to wait|has to wait)\b",
                before,
            )
            gone = re.search(
                r"pass|clear|gone|go(es)? (by|past)|cross|through",
                event.text + " " + word.norm + " " + " ".join(w.norm for w in cast.words[event.word : event.word + 4]),
            )
            if waits and gone and not any(e.act == "yield" and e.agent.ego for e in clauses.events):
                clauses.events.append(
                    Event(
                        "yield",
                        cast.ego,
                        event.word,
                        event.text,
                        event.whole,
                        event.agent,
                        order=event.order - 0.1,
                        words=[event.word],
                        start=event.start,
                        end=event.end,
                    )
                )
    for event in clauses.events:
        if event.agent.ego and event.mode == "intended" and event.act in ("lane_change", "overtake", "turn", "cut_in"):
            later = " ".join(
                w.norm for w in cast.words if w.i > event.word and w.sentence - cast.words[event.word].sentence <= 1
            )
            if re.search(
                r"\b(abort|abandon|cancel|gives? up|gave up|stays? in (its|the) (own )?lane|remains? in (its|the) lane|refrain|not possible|impossible)",
                later,
            ):
                event.mode = "hypothetical"
    _waits(cast, clauses)
    _waits_for_somebody(cast, clauses)
    _echoes(cast, clauses)
    contact = [e for e in clauses.events if e.act == "collide" and e.mode == "fact"]
    for event in clauses.events:
        if (
            event.mode == "purpose"
            and event.act == "overtake"
            and any(c.order > event.order and (c.agent is event.agent or event.agent in c.also) for c in contact)
        ):
            event.mode = "hypothetical"
    clauses.events.sort(key=lambda e: e.order)


WAITS = re.compile(
    r"(?:wait|stays? put|hold|remain|pause|stops?|(?:not|n't|never) (?:\w+ )?(?:move|start|turn|go|proceed|pull|enter|set|begin))[^.;]*?\b(?:until|till|for)\b"
    r" (?:\S+ ){0,7}?@(?P<who>a\d+)[^.;]*?\b(?:pass\w*|clear|cross\w*|by|through|past|gone|go|goes|first|over|finish\w*)\b"
)
PRIORITY = re.compile(
    r"@(?P<who>a\d+)[^.;]{0,60}?\b(?:have|has|had|with|enjoys?) (?:the )?(?:priority|right of way|right-of-way|precedence)"
    r"|(?:priority|precedence|right of way) (?:belongs? to|is with|lies with|of) (?:the |an? )?@(?P<of>a\d+)"
)


def _waits(cast: Cast, clauses: Clauses) -> None:
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
        if (
            match
            and "@ego" not in text[: match.start() + 4]
            and not any(cast.of.get(i) is cast.ego for i in sentence[:3])
        ):
            match = None
        right = None if match else PRIORITY.search(text)
        if right and (
            re.search(r"in spite|despite|without|just (as|when)|fail|ignor", text)
            or not any(e.act in ("turn", "go_straight", "stop", "brake", "travel") for e in own)
        ):
            right = None
        found = match or right
        if found is None:
            continue
        who = by_key.get(found.groupdict().get("who") or found.groupdict().get("of") or "")
        if (
            who is None
            or not who.mover
            or any(e.act in ("run_red", "run_stop") and e.agent is who for e in clauses.events)
        ):
            continue
        for event in own:
            if event.act == "stationary" and cast.words[event.word].sentence == number:
                event.mode = "hypothetical"
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


def _waits_for_somebody(cast: Cast, clauses: Clauses) -> None:
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
            and e.act in ("cross_road", "cross_path", "go_straight", "approach", "oncoming")
            and e.word < event.word
        ]
        if crossing:
            event.act, event.patient = "yield", crossing[-1]
            return


def _echoes(cast: Cast, clauses: Clauses) -> None:
    """What is said by reference to another clause: "and so must ego", "the two collided"."""
    words = cast.words
    for i, word in enumerate(words[:-2]):
        ahead = " ".join(w.norm for w in words[i : i + 7] if w.sentence == word.sentence)
        if re.match(r"so (must|does|do|did|has|should|will|had)\b", ahead):
            target = next((cast.of[w.i] for w in words[i : i + 6] if w.i in cast.of), None)
            earlier = [e for e in clauses.events if e.word < i and e.agent is not target and e.mode == "fact"]
            if target is not None and earlier:
                last = max(earlier, key=lambda e: e.word)
                clauses.events.append(
                    Event(
                        last.act,
                        target,
                        i,
                        last.text,
                        last.whole,
                        None,
                        hard=last.hard,
                        order=i,
                        words=[i],
                        start=word.start,
                        end=word.end,
                    )
                )
        if re.match(
            r"(the |they |)(two|both|they)( vehicles| cars| of them)? (then )?(collide|collided|crash|crashed|meet|met|came into contact|made contact)\b",
            ahead,
        ) and not any(e.act == "collide" and abs(e.word - i) < 6 for e in clauses.events):
            before = [cast.of[j] for j in sorted(cast.of) if j < i and cast.of[j].mover and not cast.of[j].ego]
            if before:
                clauses.events.append(
                    Event(
                        "collide",
                        before[-1],
                        i,
                        ahead,
                        ahead,
                        cast.ego,
                        order=i,
                        words=[i],
                        start=word.start,
                        end=word.end,
                    )
                )


def _event_of(scene: Scene, i: int) -> Event | None:
    return next((e for e in scene.clauses.events if i in e.words), None)


def _speed_owner(scene: Scene, i: int) -> Entity | None:
    words, cast = scene.words, scene.cast
    current = words[i]
    for _ in range(8):
        if current.i in scene.clauses.by_word:
            event = scene.clauses.by_word[current.i]
            agent, _, passive = scene.clauses._subject(current) if current.verb else (event.agent, None, False)
            return (
                event.patient if event.passive and event.patient is not None and event.act == "travel" else event.agent
            )
        if current.verb or scene.clauses._is_verb(current):
            agent, _, passive = scene.clauses._subject(current)
            if agent is not None:
                return agent
        owner = cast.referent(current.i) if current.i != i else None
        if owner is not None and (owner.mover or owner.ego):
            return owner
        if current.norm in ("speed", "pace", "velocity"):
            for child in current.children:
                if words[child].dep in ("poss",) or words[child].tag in ("PRP$", "WP$"):
                    found = cast.referent(child)
                    if found is not None:
                        return found
            if any(words[c].norm == "set" for c in current.children) or "set speed" in " ".join(
                w.norm for w in words[max(0, current.i - 2) : current.i + 1]
            ):
                return cast.ego
        if current.head == current.i:
            break
        current = words[current.head]
    before = [
        j
        for j in sorted(cast.of)
        if j < i and words[j].sentence == words[i].sentence and (cast.of[j].mover or cast.of[j].ego)
    ]
    if before:
        return cast.of[before[-1]]
    after = [
        j
        for j in sorted(cast.of)
        if j > i and words[j].sentence == words[i].sentence and (cast.of[j].mover or cast.of[j].ego)
    ]
    return cast.of[after[0]] if after else cast.ego


def side(event: Event) -> str | None:
    """The side towards which an event goes."""
    text = event.text
    for pattern in (
        r"(?:to|onto|into|toward|towards|on|over|in)(?: \w+){0,4}? (left|right)\b",
        r"\b(left|right)(?:ward|wards|-hand)?\b(?! of way)",
    ):
        for match in re.finditer(pattern, text):
            before = text[max(0, match.start(1) - 12) : match.start(1)]
            if (
                event.act == "overtake"
                and re.match(r"in\b", match[0])
                and "lane" in text[match.end() : match.end() + 12]
            ):
                continue
            if re.search(r"from (the |its |@\w+ 's )?$", before):
                continue
            return match[1]
    return event.side


__all__ = ["Scene", "side", "side_of_text", "understand"]
