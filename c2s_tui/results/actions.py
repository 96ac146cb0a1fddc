"""The commands of the results pane: show it, run a series of seeds (a mixin of the workbench)."""

from contextlib import aclosing
from dataclasses import replace
from typing import Any

from textual import work

from c2s_engine.maps.library import SHIPPED
from c2s_engine.structure.offers import Offer, verdict


class Results:
    """Commands that concern what runs show."""

    async def do_results(self: Any, argument: str) -> None:
        """Show the results of the run, or close them."""
        if self.results.has_class("-on"):
            if self.busy and argument == "close":
                await self.do_cancel("")
                return
            self.results.remove_class("-on")
            self.query_one("#right").remove_class("-results")
            self.go_to("code")
            return
        self.results.add_class("-on")
        self.query_one("#right").add_class("-results")
        self.go_to("results")
        self.call_after_refresh(self.results.show, self.desk)
        self.find_gaps()
        if self.desk.program.text and not self.desk.trajectories and not self.busy and self.session is not None:
            self.run_again(told=False)

    @work(group="gaps", exclusive=True, exit_on_error=False)
    async def find_gaps(self: Any) -> None:
        """Have the gaps of the run worked out where the pane shows them."""
        ways = next(iter(self.desk.trajectories), None)
        if ways is None or self.desk.gaps or not self.results.has_class("-on") or not self.backend.can("gaps"):
            return
        gaps = await self.backend.ask("gaps", ways)
        if next(iter(self.desk.trajectories), None) is ways:
            self.desk = replace(self.desk, gaps=gaps)
            self.results.show(self.desk)

    async def do_contradictions(self: Any, argument: str) -> None:
        """Say which numbers of the text contradict one another, where the run did not show all that is required."""
        if not self.desk.results:
            await self.chat.note("There is no run to judge yet: describe a scenario, or press F5.", "error")
        elif all(r.holds for r in self.desk.results):
            await self.chat.note("All that is required was shown: nothing contradicts.")
        elif await self._may_begin():
            self.find_contradictions()

    @work(group="turn", exclusive=True, exit_on_error=False)
    async def find_contradictions(self: Any) -> None:
        """What is found so far is said when it is cancelled, too."""
        found: list[Offer] = []
        async with self._turn_lock:
            structure, details = self.desk.structure, self.session.details
            self.working = "looking for what contradicts"
            self.show()
            try:
                offers = self.backend.events(
                    lambda: self.backend.engine.contradictions(
                        structure, map=details.get("map") or SHIPPED, room=details.get("room", 1.0)
                    )
                )
                async with aclosing(offers) as events:
                    async for offer in events:
                        found.append(offer)
                        self.working = f"looking for what contradicts: {len(found)} found"
                        self.show_status()
            except Exception as error:  # a check server that broke off: one sentence
                await self.chat.note(self._sentence(error), "error")
                return
            finally:
                self.working = ""
                self.show()
        await self.chat.note(verdict(found))

    async def do_seeds(self: Any, argument: str) -> None:
        """Run the program once with each of N seeds."""
        from c2s_engine.session.seeds import numbers

        try:
            chosen = numbers(argument or "20")
        except ValueError as error:
            await self.chat.note(str(error), "error")
            return
        if not self.desk.program.text:
            await self.chat.note("There is no program yet: describe a scenario first.", "error")
        elif await self._may_begin():
            if not self.results.has_class("-on"):
                await self.do_results("")
            self.run_seeds(chosen)

    @work(group="turn", exclusive=True, exit_on_error=False)
    async def run_seeds(self: Any, chosen: list[int]) -> None:
        """A row of the table for each seed, as soon as its run is done; what was run stays when it is cancelled."""
        from c2s_engine.session.seeds import verdict as of_series

        async with self._turn_lock:
            self.desk = replace(self.desk, seeds=(), planned=len(chosen))
            structure, program = self.desk.structure, self.desk.program
            folder = await self.backend.thread.do(lambda: self.backend.folder(program.text))
            self.working = f"seed 1 of {len(chosen)}"
            self.show()
            try:
                rows = self.backend.events(
                    lambda: self.backend.engine.seeds(structure, program, chosen, folder=folder)
                )
                async with aclosing(rows) as found:
                    async for row in found:
                        self.desk = replace(self.desk, seeds=(*self.desk.seeds, row))
                        self.working = f"seed {len(self.desk.seeds) + 1} of {len(chosen)}"
                        self.show_status()
                        self.results.show(self.desk)
            except Exception as error:  # a check server that broke off: one sentence
                await self.chat.note(self._sentence(error), "error")
            finally:
                self.working = ""
                self.show()
        if self.desk.seeds:
            rows = self.desk.seeds
            await self.chat.note(of_series(rows), "note" if all(r.passed for r in rows) else "warning")
