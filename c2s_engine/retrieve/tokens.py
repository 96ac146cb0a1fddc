"""The tokeniser of BM25: API names whole and in parts, clause numbers whole and by their parents, stemmed words."""

import re
from functools import lru_cache

import snowballstemmer

_TOKEN = re.compile(
    r"km/h|m/s[²2]?(?![A-Za-z])"  # units
    r"|\d+(?:\.\d+)+(?![A-Za-z])"  # clauses and decimals
    r"|[A-Za-z_][A-Za-z0-9_]*(?:-[A-Za-z][A-Za-z0-9]*)*"  # words, names, compounds
    r"|\d+"
)
_CAMEL = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|\d+")
STOPWORDS = frozenset(
    [
        "a",
        "an",
        "and",
        "are",
        "as",
        "at",
        "be",
        "been",
        "but",
        "by",
        "can",
        "could",
        "did",
        "do",
        "does",
        "for",
        "from",
        "had",
        "has",
        "have",
        "how",
        "i",
        "if",
        "in",
        "into",
        "is",
        "it",
        "its",
        "me",
        "my",
        "not",
        "of",
        "on",
        "or",
        "our",
        "shall",
        "should",
        "so",
        "such",
        "than",
        "that",
        "the",
        "their",
        "them",
        "then",
        "there",
        "these",
        "they",
        "this",
        "to",
        "us",
        "was",
        "we",
        "were",
        "what",
        "when",
        "where",
        "which",
        "while",
        "who",
        "whose",
        "why",
        "will",
        "with",
        "would",
        "you",
        "your",
    ]
)
_VARIANTS = {"maneuver": "manoeuvre", "maneuvers": "manoeuvres", "color": "colour", "center": "centre", "tire": "tyre",
             "lorry": "truck", "lorries": "trucks", "freeway": "motorway", "highway": "motorway",
             "signalized": "signalised", "unsignalized": "unsignalised", "behaviour": "behavior",
             "behaviours": "behaviors", "m/s2": "m/s²", "sidewalks": "pavements", "sidewalk": "pavement"}  # fmt: skip
_stemmer = snowballstemmer.stemmer("english")


@lru_cache(maxsize=100_000)
def _stem(word: str) -> str:
    word = _VARIANTS.get(word, word)
    return _stemmer.stemWord(word) if word.isalpha() else word


@lru_cache(maxsize=100_000)
def _terms(token: str) -> tuple[str, ...]:
    """The terms of one token."""
    if "/" in token:
        return (_stem(token),)
    if token[0].isdigit():
        numbers = token.split(".")
        return (token, *(".".join(numbers[:i]) for i in range(len(numbers) - 1, 1, -1)))
    terms: list[str] = []
    words = token.split("-")
    if len(words) > 1:
        terms.append(_stem("".join(words).lower()))
    for word in words:
        parts = [p for piece in word.split("_") for p in _CAMEL.findall(piece)]
        whole = word.lower()
        if whole not in STOPWORDS:
            terms.append(_stem(whole))
        if len(parts) > 1:
            terms.extend(_stem(p.lower()) for p in parts if p.lower() not in STOPWORDS)
    return tuple(terms)


def tokenise(text: str) -> list[str]:
    """The terms of a text, in order, repeats kept."""
    return [term for token in _TOKEN.findall(text) for term in _terms(token)]
