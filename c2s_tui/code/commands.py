"""The commands of the code pane: copy, findings, find, fold."""

from c2s_tui.chat.bubbles import Answer
from c2s_tui.part import Part
from c2s_tui.screens.dialogs import Choosable, Chooser


class CodeCommands(Part):
    """Commands that concern the code."""

    async def do_copy(self, argument: str) -> None:
        if argument == "answer":
            answers = list(self.chat.query(Answer))
            text = answers[-1].text if answers else ""
        elif argument:
            text = self.desk.program.fragment(argument)
        else:
            text = self.bench.code.area.selected_text or self.bench.code.text
        if not text:
            self.app.notify("There is nothing to copy.", markup=False)
            return
        self.app.copy_to_clipboard(text)
        self.app.notify(
            f"{len(text.splitlines())} lines sent to the terminal's clipboard; /save writes a file.", markup=False
        )

    async def do_finding(self, _: str) -> None:
        self.bench.room.go_to("code")
        self.bench.code.next_finding()

    async def do_problems(self, _: str) -> None:
        """All findings as a list; choosing one goes to its line."""
        found = [d for d in self.bench.code.diagnostics if d.line]
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
                self.bench.room.go_to("code")
                self.bench.code.go_to_line(lines[int(value)])

        self.app.push_screen(Chooser("Findings", entries, foot="Enter goes to the line", wide=True), chosen)

    async def do_find(self, argument: str) -> None:
        """Find in the code: the line to type in, or what was given with the command."""
        self.bench.room.go_to("code")
        self.bench.code.finder.open(argument)

    async def do_fold(self, argument: str) -> None:
        """Fold components in the code, or unfold them."""
        if argument and argument not in ("all", "none") and argument not in self.desk.structure:
            await self.chat.note(f"There is no component {argument}; /fold all and /fold none fold every one.", "error")
            return
        self.bench.room.go_to("code")
        self.bench.code.toggle_fold(argument)

    async def do_fix(self, _: str) -> None:
        self.bench.code.take_fix()
