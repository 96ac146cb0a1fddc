"""The lane in which ego starts."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.scene import Scene


def ego_lane_of(scene: Scene) -> str | None:
    """The lane that ego starts in, where a clause about ego names it."""
    if scene.places.ego_lane is not None:
        return scene.places.ego_lane
    patterns = language.table("places")["ego_lane"]
    ego = scene.cast.ego
    texts = [
        e.whole
        for e in scene.events(ego)
        if e.act in ("travel", "keep_lane", "follow", "approach", "stationary", "go_straight", "brake", "start")
        and e.agent is ego
    ]
    for mention in ego.mentions:
        sentence = [w for w in scene.words if w.sentence == scene.words[mention.word].sentence and w.i > mention.word]
        match = re.match(r"\s?\(([^)]*)\)", " ".join(w.norm for w in sentence))
        if _beside_it(scene, mention.word):
            continue
        word = scene.words[mention.word]
        linear: list[str] = []
        for other in scene.words[mention.word + 1 : mention.word + 14]:
            if other.sentence != word.sentence or other.verb or other.norm == "and" or other.i in scene.cast.of:
                break
            placed = scene.words[word.head].verb or word.dep == "pobj"
            if other.norm == "from" and placed and word.dep != "nsubj":
                break  # "approaches ego from behind in the left lane"
            linear.append(other.norm)
        texts.append(" ".join(linear))
        below = scene.clauses._below(mention.word)
        listed = next((i for i in below if i > mention.word and scene.cast.of.get(i, ego) is not ego), len(scene.words))
        below = [i for i in below if i < listed or scene.words[listed].dep != "appos"]  # "ahead of ego, one in the ..."
        texts.append(" ".join(scene.words[i].norm for i in below if i > mention.word))
    texts += _lanes_where(scene)
    if same := next((m for t in texts if (m := SAME_LANE.search(t))), None):
        begins = min((m.start for m in ego.mentions if f"{same[0]}" in scene.plain[m.start : m.start + 90]), default=0)
        if named := scene.places._last_lane(begins):
            return f"{named}most"
    for text in texts:
        if re.search(r"@a\d+ (in|on|from) the", text):
            text = re.split(r"@a\d+", text)[0]
        told = [(match.start(), entry["is"]) for entry in patterns if (match := re.search(entry["find"], text))]
        if told:
            return min(told, key=lambda found: found[0])[1]
    for entity in scene.actors:
        for event in scene.events(entity):
            match = re.search(r"which be also the @ego|also the @ego ''?s", event.whole)
    text = scene.plain
    match = re.search(r"in the (left|right)(-hand)? lane, which is also (the )?ego", text)
    return None


def _lanes_where(scene: Scene) -> list[str]:
    """The lanes in which ego is said to drive by a relative clause: "the right lane, where ego drives"."""
    found = []
    for event in scene.events(scene.cast.ego):
        word = scene.words[event.word]
        lane = scene.words[word.head]
        if scene.words[lane.head].norm == "of":  # "the left lane of the freeway, where ego drives"
            lane = scene.words[scene.words[lane.head].head]
        if word.dep in ("relcl", "advcl", "acl") and lane.norm in ("lane", "one") and lane.i < word.i:
            found.append("in " + " ".join(scene.words[i].norm for i in scene.clauses._below(lane.i) if i <= lane.i))
    return found


SAME_LANE = re.compile(r"\bin (?:that|the) (?:very |same )+lane\b(?! as)")
BESIDE = re.compile(r"\b(?:level with|alongside|beside|next to|abreast of|side by side with|past)(?: the)?$")


def _beside_it(scene: Scene, i: int) -> bool:
    """Whether a lane named right after ego is another's: that of one beside it, or of one who passes it."""
    word = scene.words[i]
    before = " ".join(w.norm for w in scene.words[max(0, i - 5) : i] if w.sentence == word.sentence)
    if BESIDE.search(before):
        return True
    event = scene.clauses.by_word.get(word.head) if word.dep == "dobj" else None
    return event is not None and event.act == "overtake" and not event.agent.ego
