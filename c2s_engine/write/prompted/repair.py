"""Repair beyond the paper: a fragment that fails goes back to the model with its finding, at most three times."""

import asyncio
from collections.abc import Awaitable, Callable, Sequence

from c2s_engine.models.errors import (
    AnswerRepeats,
    AnswerTruncated,
    AnswerUnusable,
    ContextOverflow,
    ModelError,
)
from c2s_engine.models.messages import Question
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.progress import Passage
from c2s_engine.write.prompted.checking import Check, Fix, Verdict, verdict
from c2s_engine.write.prompted.configuration import Configuration
from c2s_engine.write.prompted.parsing import code_of
from c2s_engine.write.prompted.prompt import code_so_far, repair_question

ROUNDS = 3
PATIENCE = 20.0
"""Longest wait for the passage of a repair, s: the first search of all builds the index (which goes on meanwhile)."""

Ask = Callable[[Question], Awaitable[str]]
Search = Callable[..., Awaitable[list[Passage]]]


class Repairer:
    """Repairs one fragment at a time; `rounds` counts those that were asked for, `shown` are the passages in them."""

    def __init__(self, ask: Ask, check: Check, fix: Fix | None, search: Search | None, config: Configuration) -> None:
        self.ask, self.check, self.fix, self.search, self.config = ask, check, fix, search, config
        self.rounds: dict[ComponentId, int] = {}
        self.fixed: dict[ComponentId, int] = {}
        self.shown: dict[ComponentId, list[Passage]] = {}

    async def settle(self, structure: Structure, cid: ComponentId, code: str) -> Verdict:
        """The best that could be made of a fragment: what passes, else what came farthest. Raises fatal ModelErrors."""
        best = await verdict(structure, cid, code, self.check, self.fix)
        self.fixed[cid] = best.fixed
        self.shown.pop(cid, None)
        current, tried = best, {code, best.code}
        before: list[Verdict] = []
        for _ in range(ROUNDS):
            if current.ok:
                return current
            answer = await self._again(structure, cid, current, before)
            before.append(current)
            if answer is None or answer in tried:
                break  # the same question would only bring the same answer
            tried.add(answer)
            current = await verdict(structure, cid, answer, self.check, self.fix)
            self.fixed[cid] += current.fixed
            if current.stage >= best.stage:
                best = current
        return best

    async def _again(
        self, structure: Structure, cid: ComponentId, current: Verdict, before: Sequence[Verdict]
    ) -> str | None:
        """The model's next version of a fragment that was tried as in `before`; none where it cannot be used."""
        assert current.diagnostic is not None
        passage = await self._passage(current.diagnostic)
        if passage:
            self.shown.setdefault(cid, []).append(passage)
        asked = repair_question(structure, cid, current, before, passage, self.config)
        self.rounds[cid] = self.rounds.get(cid, 0) + 1
        try:
            return code_of(await self.ask(asked), cid[0], code_so_far(structure, cid))
        except (AnswerUnusable, AnswerTruncated, AnswerRepeats, ContextOverflow):
            return None

    async def _passage(self, finding: Diagnostic) -> Passage | None:
        """The chunk of the documentation nearest to a finding; none where nothing can be searched."""
        if self.search is None:
            return None
        query = f"{finding.message} {finding.text}".strip()[:300]
        try:
            found = await asyncio.wait_for(self.search(query, kind="doc", component=None, limit=1), PATIENCE)
        except ModelError:
            raise
        except Exception:
            return None  # without retrieval the repair goes on with the finding alone
        return found[0] if found else None
