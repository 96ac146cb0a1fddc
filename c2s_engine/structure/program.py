"""The assembled program and the map from its lines back to the components."""

import io

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure import layout
from c2s_engine.structure.components import ComponentId, Structure

BORDER = "## {id}: "
"""Every fragment begins with a comment line `## O1: its one-sentence description`."""


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


def assemble(structure: Structure) -> Program:
    """Concatenate the fragments in the order of writing (the paper, Algorithm 1, "S_code").

    Fragments written by the engine are separated by one empty line; imported ones carry their own spacing and stand
    where they stood (layout.py), so that an imported program is assembled again byte for byte.
    """
    chunks = layout.chunks([c for c in structure.components if c.code])
    pieces: list[str] = []
    spans: list[FragmentSpan] = []
    line = 1
    for i, (component, code, verbatim) in enumerate(chunks):
        last = i == len(chunks) - 1
        if not verbatim:
            code = _ended(code) if last else code.rstrip("\n") + "\n\n"
        elif not last:
            code = _ended(code)
        count = code.count("\n") + (0 if code.endswith("\n") else 1)
        if spans and spans[-1].component == component:
            spans[-1] = FragmentSpan(component=component, first=spans[-1].first, last=line + count - 1)
        else:
            spans.append(FragmentSpan(component=component, first=line, last=line + count - 1))
        pieces.append(code)
        line += code.count("\n")
    return Program(text="".join(pieces), spans=tuple(spans))


def _ended(code: str) -> str:
    return code if code.endswith("\n") else code + "\n"
