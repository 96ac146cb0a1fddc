"""The command of the picture."""

from c2s_tui.part import Part


class PictureCommands(Part):
    """Show the run from above, or close it."""

    came_from = "sheet"  # the pane to which closing the picture goes back

    async def do_picture(self, _: str) -> None:
        """Show or hide the picture of the run."""
        if self.bench.picture.has_class("-on"):
            self.bench.picture.stop()
            self.bench.picture.remove_class("-on")
            self.bench.room.go_to(self.came_from)
        elif self.bench.picture.available:
            self.came_from = self.bench.room.pane_of_focus() or "sheet"
            self.bench.picture.add_class("-on")
            self.bench.room.go_to("picture")
            self.bench.call_after_refresh(self.bench.picture.show, self.desk)
        elif self.bench.turns.busy or not self.bench.start.ready:
            self.bench.turns.then = "picture"
            self.app.notify("The picture opens as soon as there is a run.", markup=False)
        elif self.desk.program.text and await self.bench.turns.may_begin():
            self.bench.turns.run_again("picture", told=False)
        elif not self.desk.program.text:
            self.app.notify("There is no program yet: describe a scenario first.", markup=False)
