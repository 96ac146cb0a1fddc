"""What the commands of the app do (a mixin of the workbench: a method `do_NAME` for each)."""

from dataclasses import replace
from difflib import get_close_matches
from typing import Any

from textual import work
from textual.content import Content

from c2s_engine.structure.edits import SetCode
from c2s_tui.borders import Borders
from c2s_tui.choices import Choices
from c2s_tui.commands import commands
from c2s_tui.desk import checked
from c2s_tui.files import Files
from c2s_tui.layout import Layout
from c2s_tui.past import Past
from c2s_tui.results.actions import Results
from c2s_tui.screens.dialogs import Choosable, Chooser, Reading
from c2s_tui.search import Search
from c2s_tui.start import Start
from c2s_tui.turns import Turns


class Actions(Turns, Layout, Borders, Start, Files, Past, Choices, Results, Search):
    """Commands that concern the panes and the session's turns; the other mixins hold the rest."""

    async def run_command(self: Any, name: str, argument: str = "") -> None:
        """Run a command by name; an unknown one is said in the chat."""
        if name not in commands():
            near = get_close_matches(name, commands(), 3, 0.5)
            more = f" Did you mean {', '.join('/' + n for n in near)}?" if near else ""
            await self.chat.note(f"There is no command /{name}.{more} /help lists them.", "error")
            return
        await getattr(self, f"do_{name}")(argument)

    async def action_command(self: Any, name: str) -> None:
        await self.run_command(name)

    def visit(self: Any, cid: str) -> None:
        """Go to a component in the structure pane."""
        self.sheet.point(cid)
        self.code.point(cid)
        self.go_to("sheet")

    async def do_chat(self: Any, _: str) -> None:
        self.go_to("chat")

    async def do_sheet(self: Any, _: str) -> None:
        self.go_to("sheet")

    async def do_code(self: Any, _: str) -> None:
        self.go_to("code")

    async def do_help(self: Any, _: str) -> None:
        from c2s_tui.screens.help import help_screen

        focused = self.focused
        name = next((n.HELP_NAME for n in focused.ancestors_with_self if hasattr(n, "HELP_NAME")), "chat") \
            if focused else "chat"  # fmt: skip
        titles = {"chat": "the chat", "sheet": "the structure S", "code": "the code", "picture": "the picture"}
        self.app.push_screen(help_screen(titles.get(name, name), focused, self.app.prefs.keys))

    async def do_glossary(self: Any, _: str) -> None:
        from c2s_engine.session.glossary import terms

        words = Content("\n").join(Content.assemble((name, "bold"), f": {text}") for name, text in terms().items())
        self.app.push_screen(Reading("Glossary", words))

    async def do_run(self: Any, _: str) -> None:
        """Apply hand edits; without any, check and run what stands."""
        if not self.code.commit() and await self._may_begin():
            self.run_again()

    @work(group="turn", exclusive=True, exit_on_error=False)
    async def run_again(self: Any, then: str = "", told: bool = True) -> None:
        """Check and run the program as it stands; S and history stay. `then` names a command to run after it; `told`:
        whether the chat says how it went."""
        async with self._turn_lock:
            self.working = "running"
            self.show_status()
            program = self.desk.program
            try:
                report = await self.backend.check(program.text, spans=program.spans, upto="run", trajectories=True)
                judging = self.backend.can("judge")
                judged = await self.backend.ask("judge", self.desk.structure, report) if judging else None
                self.desk = checked(self.desk, report, judged)
            except Exception as error:
                await self.chat.note(self._sentence(error), "error")
            finally:
                self.working = ""
                self.show()
        if told:
            await self._summarise()
        self.find_gaps()
        if then and self.picture.available:
            await self.run_command(then)

    async def do_regenerate(self: Any, argument: str) -> None:
        if not await self._may_begin():
            return
        chosen = tuple(argument.replace(",", " ").split())
        unknown = [c for c in chosen if c not in self.desk.structure]
        if unknown:
            await self.chat.note(f"There is no component {', '.join(unknown)}.", "error")
            return
        options = self.options()
        self.turn(lambda: self.session.regenerate(chosen, **options), "writing")

    async def do_undo(self: Any, _: str) -> None:
        await self._back("undo")

    async def do_redo(self: Any, _: str) -> None:
        await self._back("redo")

    async def _back(self: Any, which: str) -> None:
        if not await self._may_begin():
            return
        if not getattr(self.session, f"can_{which}"):
            self.app.notify(f"There is nothing to {which}.", markup=False)
            return
        self.turn(lambda: getattr(self.session, which)(), which)

    async def do_resume(self: Any, _: str) -> None:
        if await self._may_begin():
            if self.session.pending is None:
                await self.chat.note("No turn was interrupted.", "note")
                return
            self.turn(lambda: self.session.resume(), "resuming")

    async def do_cancel(self: Any, _: str) -> None:
        """Cancel what runs; S is as before the turn, what is typed stays."""
        if self.busy:
            self._waiting_edits = ()
            self.workers.cancel_group(self, "turn")
            await self.chat.note("Cancelled; nothing was changed.", "note")

    async def do_why(self: Any, argument: str) -> None:
        from c2s_tui.screens.why import why_screen

        cid = argument or (self.sheet.here.cid if self.sheet.here else "") or "E"
        if cid not in self.desk.structure:
            await self.chat.note(f"There is no component {cid}.", "error")
            return
        component = self.desk.structure[cid]
        self.app.push_screen(why_screen(self.desk.structure, component, self.desk.state(component)))

    async def do_conflict(self: Any, argument: str) -> None:
        from c2s_tui.screens.conflict import Conflict

        cid = argument or next((c.id for c in self.desk.structure.components if c.conflict is not None), "")
        if not cid or cid not in self.desk.structure or self.desk.structure[cid].conflict is None:
            await self.chat.note("There is no conflict.", "note")
            return
        component = self.desk.structure[cid]

        async def decided(which: str | None) -> None:
            if which == "mine":
                await self.make_edits((SetCode(component=cid, code=component.code),))
            elif which == "theirs":
                await self.make_edits((SetCode(component=cid, code=None),))

        self.app.push_screen(Conflict(cid, component.code, component.conflict or ""), decided)

    async def do_copy(self: Any, argument: str) -> None:
        if argument == "answer":
            answers = list(self.chat.query("Answer"))
            text = answers[-1].text if answers else ""
        elif argument:
            text = self.desk.program.fragment(argument)
        else:
            text = self.code.area.selected_text or self.code.text
        if not text:
            self.app.notify("There is nothing to copy.", markup=False)
            return
        self.app.copy_to_clipboard(text)
        self.app.notify(
            f"{len(text.splitlines())} lines sent to the terminal's clipboard; /save writes a file.", markup=False
        )

    async def do_finding(self: Any, _: str) -> None:
        self.go_to("code")
        self.code.next_finding()

    async def do_problems(self: Any, _: str) -> None:
        """All findings as a list; choosing one goes to its line."""
        found = [d for d in self.code.diagnostics if d.line]
        if not found:
            self.app.notify("The code has no findings.", markup=False)
            return
        entries = [
            Choosable(str(i), f"{d.severity:<8}line {d.line:<5}{d.component or '':<4}", d.message)
            for i, d in enumerate(sorted(found, key=lambda d: d.line or 0))
        ]
        lines = sorted(d.line for d in found if d.line)

        def chosen(value: str | None) -> None:
            if value is not None:
                self.go_to("code")
                self.code.go_to_line(lines[int(value)])

        self.app.push_screen(Chooser("Findings", entries, foot="Enter goes to the line", wide=True), chosen)

    async def do_find(self: Any, argument: str) -> None:
        """Find in the code: the line to type in, or what was given with the command."""
        self.go_to("code")
        self.call_after_refresh(self.code.finder.open, argument)

    async def do_fold(self: Any, argument: str) -> None:
        """Fold components in the code, or unfold them."""
        if argument and argument not in ("all", "none") and argument not in self.desk.structure:
            await self.chat.note(f"There is no component {argument}; /fold all and /fold none fold every one.", "error")
            return
        self.go_to("code")
        self.code.toggle_fold(argument)

    async def do_fix(self: Any, _: str) -> None:
        self.code.take_fix()

    async def do_picture(self: Any, _: str) -> None:
        """Show or hide the picture of the run."""
        if self.picture.has_class("-on"):
            self.picture.stop()
            self.picture.remove_class("-on")
            self.go_to("sheet")
        elif self.picture.available:
            self.picture.add_class("-on")
            self.go_to("picture")
            self.call_after_refresh(self.picture.show, self.desk)
        elif self.busy or not self.ready:
            self.then = "picture"
            self.app.notify("The picture opens as soon as there is a run.", markup=False)
        elif self.desk.program.text and await self._may_begin():
            self.run_again("picture", told=False)
        elif not self.desk.program.text:
            self.app.notify("There is no program yet: describe a scenario first.", markup=False)

    def choose(self: Any, **values: Any) -> None:
        """Change what the next turn uses, and remember it."""
        self.choice = replace(self.choice, **values)
        self.app.remember(**values)
        self.show_status()
        if values.get("map"):
            self.run_worker(self.backend.warm(values["map"]), group="warm", exit_on_error=False)
