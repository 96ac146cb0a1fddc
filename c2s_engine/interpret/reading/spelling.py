"""Mends misspelt words of the trade before the text is read, after shorthand and tables were spelt out."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import each_apart, notation, only_one, rephrased, telegraphic
from c2s_engine.interpret.reading.motions import irregular
from c2s_engine.interpret.reading.rewritten import Replacement, Rewritten

WORD = re.compile(r"[A-Za-z]{4,}(?!['’]t\b)(?![A-Za-z])")


class NormalisedText:
    """A text read in full words: shorthand spelt out, misspellings mended; `back` maps an offset to the user's text.
    Of a scene, what it is said not to need is left out."""

    def __init__(self, text: str, *, scene: bool = True) -> None:
        self.original = text
        self._passes: list[Rewritten] = []
        for replacements in (
            only_one.only_one,
            notation.fields,
            notation.signs,
            _repairs,
            rephrased.rephrased,
            each_apart.each_apart,
            telegraphic.spelt_out,
        ):
            self._passes.append(Rewritten(text, replacements(text)))
            text = self._passes[-1].text
        self.text = text

    def back(self, offset: int) -> int:
        """The place in the user's text."""
        for step in reversed(self._passes):
            offset = step.back(offset)
        return offset


def _repairs(text: str) -> list[Replacement]:
    found: list[Replacement] = []
    for pattern, new in language.table("spelling")["patterns"]:
        found += [(m.start(), m.end(), m.expand(new)) for m in re.finditer(pattern, text, re.IGNORECASE)]
    spelt = [(start, end) for start, end, _ in found]
    loud = text.isupper()
    for match in WORD.finditer(text):
        word = match[0]
        inner = match.start() > 0 and text[: match.start()].rstrip()[-1:] not in (".", "!", "?", ":", "")
        if word[0].isupper() and inner and not loud or word.isupper() and not loud or known(word.lower()):
            continue
        better = nearest(word.lower())
        if better is not None and not any(s < match.end() and match.start() < e for s, e in spelt):
            found.append((match.start(), match.end(), better))
    return found


def _stem(verb: str) -> str:
    """The verb as it stands before "ed" and "ing": "stop" doubles its consonant, "merge" drops its e."""
    if verb.endswith("e") and not verb.endswith("ee"):
        return verb[:-1]
    return verb + verb[-1] if re.fullmatch(r"[^aeiou]*[aeiou][^aeiouwxy]|.*(?:mit|fer|vel)", verb) else verb


@cache
def vocabulary() -> frozenset[str]:
    """The single words of the language tables, with the forms of their verbs."""
    words: set[str] = set(language.table("spelling")["extra"])
    for noun in language.actor_nouns().keys() - language.other_agents():
        words |= set(re.findall(r"[a-z]{4,}", noun))
    for rule in language.table("motions")["verbs"]:
        for verb in rule["verbs"]:
            words |= {verb, f"{verb}s", *(_stem(verb) + ending for ending in ("ed", "ing"))}
    words |= {w for form in irregular() for w in re.findall(r"[a-z]+", form)}
    for name in ("environment", "places"):
        words |= set(re.findall(r"[a-z]{5,}(?![a-z\\[(?*])", re.sub(r"(?<!\\)\\b", " ", str(language.table(name)))))
    return frozenset(w for w in words if len(w) >= 4 and w.isalpha())


def known(word: str) -> bool:
    """Whether a word is English or one of the tables'."""
    if word in vocabulary() or word.endswith("s") and word[:-1] in vocabulary() or f"{word}s" in vocabulary():
        return True
    from c2s_engine.interpret.reading.syntax import parser

    strings = parser().vocab.strings
    if word in _doubtful():
        return False
    return (
        word in strings
        or word.endswith(("s", "d", "ing", "ly", "er"))
        and any(word[: -len(e)] in strings and len(word) - len(e) > 4 for e in ("s", "ed", "d", "ing", "ly", "er"))
    )


@cache
def _doubtful() -> frozenset[str]:
    """Verb forms with a letter too few ("stoped", "overtaks"), which look like English to the parser's word list."""
    silent = {v[:-1] + "s" for rule in language.table("motions")["verbs"] for v in rule["verbs"] if v.endswith("e")}
    verbs = {v for rule in language.table("motions")["verbs"] for v in rule["verbs"] if _stem(v) == v + v[-1]}
    return frozenset(v + ending for v in verbs for ending in ("ed", "ing")) - {"planed", "bared"} | {
        s for s in silent if len(s) > 6
    }


@cache
def nearest(word: str) -> str | None:
    """The one word of the vocabulary that differs by a slip or two; None where there is none or it is not clear."""
    common = frozenset(language.table("spelling")["extra"])
    limit = 1 if len(word) < 7 else 2
    best: list[tuple[int, str]] = []
    for other in vocabulary():
        allowed = limit if other in common or len(word) >= 10 else 1
        if abs(len(other) - len(word)) > allowed or other[0] != word[0] and other[1:2] != word[:1]:
            continue
        if len(word) < 8 and len(other) == len(word) and sorted(other) != sorted(word) and other not in common:
            continue
        distance = edit_distance(word, other, allowed)
        if distance <= allowed:
            best.append((distance, other))
    best.sort()
    likely = [other for distance, other in best if distance == best[0][0] and other in common]
    if len(likely) == 1:
        return likely[0]
    if not best or len(best) > 1 and best[0][0] == best[1][0] and best[0][1].rstrip("sed") != best[1][1].rstrip("sed"):
        return None
    return best[0][1]


def edit_distance(a: str, b: str, limit: int) -> int:
    """Edit distance with transpositions; `limit` + 1 where it is larger."""
    before: list[int] = []
    last = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        row = [i]
        for j, y in enumerate(b, 1):
            cost = min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, before[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
        before, last = last, row
    return last[-1]
