"""The assembled program and the map from its lines back to the components."""

import io
import re

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure import layout
from c2s_engine.structure.components import Component, ComponentId, Structure

_ENDS = re.compile(r"^terminate after (\d+(?:\.\d+)?) seconds", re.MULTILINE)
LONGEST = 600.0
"""s of the longest run."""
_COMMENT = re.compile(r"""('[^']*'|"[^"]*")|#.*""")


def without_comment(line: str) -> str:
    """A line of code without the comment behind it; a sign within a string begins none."""
    return _COMMENT.sub(lambda m: m[1] or "", line)


def border(component: Component) -> str:
    """The comment line with which a fragment begins: `## O1: its one-sentence description`."""
    return f"## {component.id}: {' '.join(component.description.split())}".rstrip(": ")


def parted(code: str) -> tuple[str, str]:
    """A fragment's border with its end of line, if it has one, and the rest."""
    at = code.find("\n") + 1 if code.startswith("## ") else 0
    return code[:at], code[at:]


class FragmentSpan(BaseModel):
    """Lines `first`..`last` (1-based, inclusive) of the program belong to `component`."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    component: ComponentId
    first: int
    last: int


class Program(BaseModel):
    """A Scenic program with its source map."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    text: str
    spans: tuple[FragmentSpan, ...] = ()

    def component_at(self, line: int) -> ComponentId | None:
        """The component to which a line (1-based) of the program belongs."""
        for span in self.spans:
            if span.first <= line <= span.last:
                return span.component
        return None

    def span_of(self, cid: ComponentId) -> FragmentSpan | None:
        """The (first) lines of a component."""
        for span in self.spans:
            if span.component == cid:
                return span
        return None

    def fragment(self, cid: ComponentId) -> str:
        """The text of a component's fragment, as it stands in the program (its parts, where it is scattered)."""
        lines = list(io.StringIO(self.text, newline="\n"))
        return "".join("".join(lines[s.first - 1 : s.last]) for s in self.spans if s.component == cid)


def run_limit(text: str, usual: float = 0.0) -> float:
    """The s that a run of a program takes at most: as usual, or until it ends by its own words, if that is later. At
    most `LONGEST`."""
    return min(max(usual, *(float(m[1]) for m in _ENDS.finditer(text)), 0.0), LONGEST)


def assemble(structure: Structure) -> Program:
    """The fragments in the order of writing (the paper, Algorithm 1, "S_code"), an empty line between them; a program
    that was opened or edited by hand as it was arranged, byte for byte (layout.py)."""
    row = layout.pieces(structure)
    spans: list[FragmentSpan] = []
    line = 1
    for component, text in row:
        last = line + text.count("\n") - text.endswith("\n")
        follows = bool(spans) and spans[-1].last == line - 1
        if follows and (spans[-1].component == component or component == layout.FREE and not text.strip()):
            spans[-1] = spans[-1].model_copy(update={"last": last})
        elif component != layout.FREE:
            spans.append(FragmentSpan(component=component, first=line, last=last))
        line = last + 1
    return Program(text="".join(text for _, text in row), spans=tuple(spans))
