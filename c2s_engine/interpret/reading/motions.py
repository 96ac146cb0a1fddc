"""What verbs and nouns of motion mean (data/language/motions.yaml), and their irregular forms."""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language


@cache
def rules(section: str) -> list[tuple[dict[str, Any], frozenset[str], dict[str, re.Pattern[str]]]]:
    found = []
    words: dict[str, str] = language.table("motions")["words"]
    for rule in language.table("motions")[section]:
        patterns = {k: re.compile(language.filled(rule[k], words)) for k in ("after", "any", "not") if k in rule}
        found.append((rule, frozenset(rule.get("verbs", rule.get("nouns", ()))), patterns))
    return found


@cache
def irregular() -> dict[str, str]:
    """Forms of verbs that no rule takes back to their base form."""
    forms: dict[str, str] = language.table("parsing")["irregular"]
    return forms


@cache
def verb_lemmas() -> frozenset[str]:
    return frozenset(v for rule in language.table("motions")["verbs"] for v in rule["verbs"])


ENDINGS = (
    ("ies", "y"),
    ("es", "e"),
    ("es", ""),
    ("s", ""),
    ("ing", ""),
    ("ing", "e"),
    ("ed", ""),
    ("ed", "e"),
    ("d", ""),
)
"""Endings of verbs, and what stands for them in the base form."""


def base_form(form: str, lemma: str) -> str:
    """The base form of a verb of motion; of any other word the parser's lemma."""
    known = irregular().get(form)
    if known:
        return known
    if lemma in verb_lemmas():
        return lemma
    for ending, replacement in ENDINGS:
        if form.endswith(ending) and form[: -len(ending)] + replacement in verb_lemmas():
            return form[: -len(ending)] + replacement
    for ending in ("ing", "ed"):
        stem = form[: -len(ending)]
        if form.endswith(ending) and len(stem) > 2 and stem[-1] == stem[-2] and stem[:-1] in verb_lemmas():
            return stem[:-1]
    return lemma


def third_person(verb: str) -> str:
    """The third person singular of a verb by rule: "carries", "passes", "brakes"."""
    if re.search("[^aeiou]y$", verb):
        return f"{verb[:-1]}ies"
    return f"{verb}es" if verb.endswith(("s", "sh", "ch", "x", "z", "o")) else f"{verb}s"


@cache
def third_persons() -> frozenset[str]:
    """The third person singular of every verb of motion."""
    return frozenset(third_person(verb) for verb in verb_lemmas())


@cache
def participles() -> dict[str, str]:
    """The verb of motion of each present participle."""
    return {form: verb for verb in sorted(verb_lemmas()) for form in _participles(verb)}


def _participles(verb: str) -> tuple[str, ...]:
    """The present participle of a verb by rule, in both spellings where the last letter may be doubled."""
    if verb.endswith("ie"):
        return (f"{verb[:-2]}ying",)
    if verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")):
        return (f"{verb[:-1]}ing",)
    doubled = re.search("[^aeiou][aeiou][bdglmnprt]$", verb) is not None
    return (f"{verb}ing", f"{verb}{verb[-1]}ing") if doubled else (f"{verb}ing",)


@cache
def past_forms() -> dict[str, str]:
    """The verb of motion of each past tense or past participle."""
    found = {form: verb for verb in sorted(verb_lemmas()) for form in _past(verb)}
    return found | {form: verb for form, verb in irregular().items() if not form.endswith(("s", "ing"))}


def _past(verb: str) -> tuple[str, ...]:
    """The past tense of a verb by rule, in both spellings where the last letter may be doubled."""
    if verb.endswith("e"):
        return (f"{verb}d",)
    if re.search("[^aeiou]y$", verb):
        return (f"{verb[:-1]}ied",)
    doubled = re.search("[^aeiou][aeiou][bdglmnprt]$", verb) is not None
    return (f"{verb}ed", f"{verb}{verb[-1]}ed") if doubled else (f"{verb}ed",)
