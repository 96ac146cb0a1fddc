"""Places and ways that are told as beside or towards somebody who is not named: that is ego."""

import re

from c2s_engine.interpret.who.mentions import Cast, Entity

FROM_ASIDE = re.compile(
    r"^(?!.*\b(?:turn|chang|merg|mov|swerv|veer)\w*\b.* from ).*\bfrom (?:the |its )?"
    r"(?:left|right|rear|behind|front|opposite (?:side|direction|carriageway|lane))\b"
    r"(?! (?:\w+ )?(?:lane|side|turn|shoulder|kerb|curb)\b)"
    r"|\b(?:from|out of|leav\w+) (?:the |a |an )?(?:\w+ )?(?:street|road|driveway) (?:on|to)"
    r" (?:the |its )(?:left|right)\b"
    r"|\b(?:comes?|came|coming|approach\w*) (?:along |up )?(?:the wrong way|against the traffic)\b"
    r"|^\S+ (?:\S+ )?at the (?:left|right)(?:-hand)? (?:kerb|curb)\b"
)
"""A way by which one comes towards somebody who is not named: that is ego."""


BESIDE = re.compile(
    r"^\S+( (?!which|that)\S+)?( (which|that)( is| was|(?= (come|go|drive|travel|head)s? )))?( \d[\d.]*\s*[a-z]+)? "
    r"((occupying )?(ahead|in front|further (along|up|on|down)|up the (road|street)|down the (road|street)"
    r"|diagonally (ahead|behind)|to (the|our|its) (front|rear)\b|(right |close |directly |just )?"
    r"behind(?= it\b| [a-z]+(?:s|ed)\b)"
    r"|in the (left|right|adjacent|next|oncoming|neighbou?ring|adjoining|parallel|other)"
    r"|(on|at|in) the (opposite|opposing|far|left|right)(-hand)? "
    r"(arm|leg|approach|branch|side of (the|an?) (junction|inter|cross))"
    r"|(on|at|in) (the|a) (side|cross|minor)[ -]?(road|street) (on|to) the (left|right)"
    r"|occupying the (left|right|adjacent|next|neighbou?ring|adjoining|parallel|other)"
    r"|((travell?|driv|go|com|head|rid|mov|approach|stand)(ing|ed|es|e|s) )?(in|on|of|from|along) "
    r"(the )?(opposite|opposing|contraflow|facing"
    r"|other (side|direction|carriageway|way|lane))"
    r"|(travell?|driv|go|com|head|rid|mov)(ing|ed|s|es) (the (other|opposite) way|opposite|contraflow)"
    r"|coming|on (the|its) (left|right)(?=$| (?!lane|side|hand|turn))|approaching|oncoming|from (the|its|behind)))"
)
FRONTED = re.compile(
    r"^(?:in|on) the (?:left|right|adjacent|next|neighbou?ring|adjoining|parallel|other|opposite|opposing|oncoming)"
    r"(?:-hand)? (?:\w+ )?(?:lane|side|carriageway|direction) ?,? (?:an?|another|one) (?:\w+ )?$"
    r"|^from the (?:left|right|front|rear|side|opposite direction|other direction) ?,? (?:an?|another|one) (?:\w+ )?$"
)
"""A place before one that is new."""


OTHER_CLAUSE = re.compile(r" (?:that (?:the|an?)|while|whilst|when|because)\b")


def beside_nobody(entity: Entity, cast: Cast) -> bool:
    """Whether it is first told by its place beside somebody who is not named: that is ego. A title does not count."""
    titled = [m for m in entity.mentions if ":" not in [w.norm for w in cast.words[m.word + 1 : m.word + 2]]]
    at = (titled or entity.mentions)[0].word
    the = at < 3 or cast.words[at - 1].norm == "the"
    first = " ".join(w.norm for w in cast.words[at : at + 9])
    stands = entity.group is None and entity.count == 1 and the and re.match(r"\S+ (is|was|were) ", first)
    before = " ".join(w.norm for w in cast.words[max(0, at - 8) : at] if w.sentence == cast.words[at].sentence) + " "
    first = OTHER_CLAUSE.split(first)[0]  # "the Kia did not see that traffic ahead had stopped"
    return not stands and (BESIDE.search(first) or FRONTED.search(before)) is not None


def after(i: int, cast: Cast) -> str:
    """A word with what follows it in its sentence."""
    return " ".join(w.norm for w in cast.words[i : i + 10] if w.sentence == cast.words[i].sentence)


def from_aside(i: int, cast: Cast) -> bool:
    """Whether one is said to come from a side, not who does something meanwhile ("by a car while crossing")."""
    return FROM_ASIDE.search(re.split(r" (?:while|whilst|when|as|who)\b", after(i, cast))[0]) is not None
