"""The status line: where things stand, in one row."""

from dataclasses import dataclass
from typing import Any

from textual.content import Content
from textual.widgets import Static

from c2s_engine.config import METHOD
from c2s_engine.structure.account import count_lost_clauses
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.requirements import tally
from c2s_tui.desk import Desk
from c2s_tui.look.kinds import mark

STAGES = ("interpret", "resolve", "write", "parse", "safety", "compile", "sample", "run")

CLOSING = "closing"


@dataclass(frozen=True)
class Choice:
    """What the next turn will use."""

    method: str = METHOD
    model: str = ""
    map: str = ""


class StatusBar(Static):
    """Method, model, map, verdicts of the stages, time, tokens, what is required and seen."""

    def __init__(self, **options: Any):
        super().__init__("", markup=False, **options)
        self._shown = Content("")
        self._ends = False

    def tell_end(self) -> None:
        """From now on only that the app is closing."""
        self._ends = True
        self.update(Content.styled(CLOSING, "bold $text-accent"), layout=False)

    def show(self, desk: Desk, choice: Choice, working: str = "", choosing: str = "") -> None:
        """`choosing`: the key that shows code by hand that its fields contradict, with what would be written."""
        words = line(desk, choice, working, self.app.size.width, choosing)
        if not self._ends and words != self._shown:
            self._shown = words
            self.update(words, layout=False)


def line(desk: Desk, choice: Choice, working: str, width: int, choosing: str = "") -> Content:
    """The row; narrow terminals lose the least needed first."""
    parts: list = []

    def add(*pieces: Any) -> None:
        if parts:
            parts.append((f" {mark('rule')} ", "$faint"))
        parts.extend(pieces)

    if working and width < 100:  # what is done now, in full
        return Content.assemble((choice.method, "bold"), (f" {mark('rule')} ", "$faint"), _doing(working))
    if width >= 100 or not desk.collisions:
        add((choice.method, "bold"))
        add((f"map {choice.map or 'auto'}", "$muted"))
    if choice.model and width >= 100:
        add((choice.model, "$muted"))
    verdicts: list = []
    done: dict[str, StageResult] = {s.name: s for s in desk.stages}
    shown = [s for s in STAGES if s in done or s == desk.running]
    if desk.running is None and all(s.ok for s in desk.stages):
        shown = shown[-1:]  # the last stage stands for those before it
    for name in shown if width >= 100 else shown[-2:]:
        result = done.get(name)
        sign = ("writing", "$text-accent") if result is None else ("clean", "$text-success") if result.ok else \
            ("failed", "$text-error")  # fmt: skip
        verdicts += [(f"{mark(sign[0])}{name} ", sign[1])]
    if verdicts:
        add(*verdicts)
    if desk.seconds and width >= 100:
        add((f"{desk.seconds:.1f} s", "$muted"))
    if desk.answer_tokens:
        add((f"{desk.prompt_tokens}+{desk.answer_tokens} tok", "$muted"))
    for hit in desk.collisions[:1]:
        add((str(hit), "$muted" if hit.said else "bold $text-error"))
    seen, required = tally(desk.results)
    if required:
        lost = count_lost_clauses(desk.structure, desk.idle)
        short = f"; {lost} clause{'s' * (lost > 1)} lost" if lost else ""
        whole = seen == required and not lost
        words = "requirements met" if width >= 100 else "met"
        add((f"{seen} of {required} {words}{short}", "$text-success" if whole else "$text-warning"))
    if against := [c.id for c in desk.structure.components if c.conflict is not None]:
        said = f"{mark('conflict')} {', '.join(against)}: "
        add((said + (f"code or fields? {choosing} chooses" if width >= 100 else choosing), "bold $text-error"))
    if working:
        add(_doing(working))
    return Content.assemble(*parts)


def _doing(working: str) -> tuple[str, str]:
    return f"{working} (Esc cancels)", "bold $text-accent"
