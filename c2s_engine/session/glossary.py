"""The words of the app and the documents, and what they mean (data/glossary.yaml)."""

import re
from functools import cache

import yaml

from c2s_engine import paths

_ASKS = re.compile(r"what (?:is|are|does|do)(?: an?| the)?\s+[“\"']?(.+?)[”\"']?(?: mean| stand for)?\s*\??$", re.I)


@cache
def terms() -> dict[str, str]:
    """Each word with its meaning, in the order of the file."""
    return yaml.safe_load(paths.shipped("glossary.yaml").read_text("utf-8"))


def meaning(question: str) -> str:
    """What a word means, where that is asked ("what is TTC?") or the word alone is given; empty for another text."""
    asked = _ASKS.match(question.strip())
    word = (asked[1] if asked else question).strip().lower()
    for name, text in terms().items():
        if word in {name.lower(), f"{name.lower()}s"}:
            return f"{name}: {text}"
    return ""


def page() -> str:
    """docs/glossary.md."""
    lines = [f"- **{name}**: {text}" for name, text in sorted(terms().items(), key=lambda t: t[0].lower())]
    return "\n".join(["# Glossary", "", "Made from data/glossary.yaml.", "", *lines, ""])


if __name__ == "__main__":
    print(page(), end="")
