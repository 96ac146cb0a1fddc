"""The commands of the results pane: show it, run a series of seeds."""

from contextlib import aclosing
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from c2s_engine.maps.library import SHIPPED
from c2s_engine.structure.offers import Offer, verdict
from c2s_tui.part import Part, background, sentence

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench


class ResultsCommands(Part):
    """Commands that concern what runs show."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.series = False  # a series of runs is under way
        self.came_from = "code"  # the pane in which one was as they were shown

    async def do_results(self, argument: str) -> None:
        """Show the results of the run, or close them where they can be seen."""
        if self.bench.results.has_class("-on") and self._behind():
            self.bench.room.go_to("results")
            self.bench.results.show(self.desk)
            return
        if self.bench.results.has_class("-on"):
            if self.series and argument == "close":
                await self.bench.turns.do_cancel("")
                return
            self.bench.results.remove_class("-on")
            self.bench.query_one("#right").remove_class("-results")
            self.bench.room.go_to(self.came_from if argument == "close" else "code")
            return
        self.came_from = self.bench.room.pane_of_focus() or "code"
        self.bench.results.empty()
        self.bench.results.add_class("-on")
        self.bench.query_one("#right").add_class("-results")
        self.bench.room.go_to("results")
        self.bench.call_after_refresh(lambda: self.bench.results.show(self.desk))
        self.find_gaps()
        idle = self.bench.session is not None and not self.bench.turns.busy
        if idle and self.desk.program.text and not self.desk.trajectories:
            self.bench.turns.run_again(told=False)

    def _behind(self) -> bool:
        """Whether another pane is in front of them, where there is room for one at a time."""
        alone = self.bench.has_class("-narrow") or self.bench.query_one("#panes").has_class("-zoom")
        return alone and self.bench.room.current_pane != "results"

    @background("gaps")
    async def find_gaps(self) -> None:
        """Have the gaps of the run worked out where the pane shows them."""
        ways = next(iter(self.desk.trajectories), None)
        if ways is None or self.desk.gaps or not self.bench.results.has_class("-on"):
            return
        gaps = await self.backend.do(lambda engine: engine.gaps(ways))
        if next(iter(self.desk.trajectories), None) is ways:
            self.desk = replace(self.desk, gaps=gaps)
            self.bench.results.show(self.desk)

    async def do_contradictions(self, argument: str) -> None:
        """Say which numbers of the text contradict one another, where the run did not show all that is required."""
        if not self.desk.results:
            await self.chat.note("There is no run to judge yet: describe a scenario, or press F5.", "error")
        elif all(r.holds for r in self.desk.results):
            await self.chat.note("All requirements were met: nothing contradicts.")
        elif await self.bench.turns.may_begin():
            self.find_contradictions()

    @background("turn")
    async def find_contradictions(self) -> None:
        """Look for them, with how many are found so far in the status line; some seconds a number."""
        found: list[Offer] = []
        async with self.bench.turns.lock:
            details, engine = self.session.details, self.backend.engine
            name, room = details.get("map") or SHIPPED, details.get("room", 1.0)
            self.bench.turns.working = "looking for what contradicts"
            self.bench.show()
            try:
                offers = partial(engine.contradictions, self.desk.structure, map=name, room=room)
                async with aclosing(self.backend.events(offers)) as events:
                    async for offer in events:
                        found.append(offer)
                        self.bench.turns.working = f"looking for what contradicts: {len(found)} found"
                        self.bench.show_status()
            except Exception as error:  # a check server that broke off: one sentence
                await self.chat.note(sentence(error), "error")
                return
            finally:
                self.bench.turns.working = ""
                self.bench.show()
        await self.chat.note(verdict(found))

    async def do_seeds(self, argument: str) -> None:
        """Run the program once with each of N seeds."""
        from c2s_engine.session.seeds import numbers

        try:
            chosen = numbers(argument or "20")
        except ValueError as error:
            await self.chat.note(str(error), "error")
            return
        if not self.desk.program.text:
            await self.chat.note("There is no program yet: describe a scenario first.", "error")
        elif await self.bench.turns.may_begin():
            if not self.bench.results.has_class("-on"):
                await self.do_results("")
            self.run_seeds(chosen)

    @background("turn")
    async def run_seeds(self, chosen: list[int]) -> None:
        """A row of the table for each seed, as soon as its run is done; what was run stays when it is cancelled."""
        from c2s_engine.session.seeds import verdict as of_series

        async with self.bench.turns.lock:
            self.desk = replace(self.desk, seeds=(), planned=len(chosen))
            structure, program = self.desk.structure, self.desk.program
            folder = await self.backend.do(lambda _: self.backend.folder(program.text))
            self.bench.turns.working, self.series = f"seed 1 of {len(chosen)}", True
            self.bench.show()
            try:
                runs = partial(self.backend.engine.seeds, structure, program, chosen, folder=folder)
                async with aclosing(self.backend.events(runs)) as found:
                    async for row in found:
                        self.desk = replace(self.desk, seeds=(*self.desk.seeds, row))
                        self.bench.turns.working = f"seed {len(self.desk.seeds) + 1} of {len(chosen)}"
                        self.bench.show_status()
                        self.bench.results.show(self.desk)
            except Exception as error:  # a check server that broke off: one sentence
                await self.chat.note(sentence(error), "error")
            finally:
                self.bench.turns.working, self.series = "", False
                self.bench.show()
        if self.desk.seeds:
            rows = self.desk.seeds
            await self.chat.note(of_series(rows), "note" if all(r.passed for r in rows) else "warning")
