"""The example programs that ship (data/examples/programs), taken apart at their `## R: sentence` borders."""

import re
from functools import cache

from pydantic import BaseModel, ConfigDict

from c2s_engine import paths

_BORDER = re.compile(r"^## (?P<id>[GRET]|O[1-9]\d?): (?P<sentence>.*)\n", re.M)


class Fragment(BaseModel):
    model_config = ConfigDict(frozen=True)

    id: str
    sentence: str
    code: str


class Example(BaseModel):
    """A program with its components in their order."""

    model_config = ConfigDict(frozen=True)

    number: str
    title: str
    text: str
    fragments: tuple[Fragment, ...]

    @property
    def description(self) -> str:
        """The scenario in words: what its components say."""
        return " ".join(f.sentence for f in self.fragments)

    def before(self, cid: str) -> str:
        """The code of the components before one, without the header."""
        ids = [f.id for f in self.fragments]
        return "\n\n".join(f.code for f in self.fragments[1 : ids.index(cid)])

    def of_kind(self, kind: str) -> Fragment:
        """The last component of a kind (the richest context for an object)."""
        return next(f for f in reversed(self.fragments) if f.id[0] == kind)


def fragments(text: str) -> tuple[Fragment, ...]:
    """A program's components by its borders."""
    borders = list(_BORDER.finditer(text))
    ends = [b.start() for b in borders[1:]] + [len(text)] * bool(borders)
    return tuple(
        Fragment(id=b["id"], sentence=b["sentence"].strip(), code=text[b.end() : end].strip())
        for b, end in zip(borders, ends, strict=True)
    )


@cache
def examples() -> dict[str, Example]:
    """All of them, by number."""
    found = {}
    for path in sorted(paths.shipped("examples", "programs").glob("*.scenic")):
        number, _, title = path.stem.partition("_")
        text = path.read_text(encoding="utf-8")
        found[number] = Example(number=number, title=title.replace("_", " "), text=text, fragments=fragments(text))
    return found
