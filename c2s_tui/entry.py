"""`c2s`, the program: the app is painted before anything is imported, every other command is the engine's."""

import sys

from c2s_tui import early


def main() -> None:
    """The entry point."""
    wanted = early.asked(sys.argv[1:])
    if wanted is None:
        from c2s_engine.cli import main as command_line

        command_line()
        return
    terminal = early.Early()
    terminal.paint()
    try:
        from pathlib import Path

        from c2s_tui.launch import launch

        session, file = wanted
        sys.exit(launch(session, Path(file) if file else None, terminal))
    except KeyboardInterrupt:
        terminal.leave()
        sys.exit(130)
    except Exception as error:  # what nobody foresaw is still one sentence, on the shell's screen
        terminal.leave()
        print(f"c2s: internal error: {type(error).__name__}: {error}. Please report it.",
              file=sys.stderr)  # fmt: skip
        sys.exit(2)


if __name__ == "__main__":
    main()
