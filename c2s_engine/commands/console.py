"""What commands share: exit codes, one clear sentence for each failure, JSON or rich output."""

import asyncio
import contextlib
import json
import os
import sys
from collections.abc import Coroutine, Iterator
from pathlib import Path
from typing import Any, NoReturn

import typer
from rich.console import Console
from rich.text import Text

from c2s_engine.dryrun.carla import CarlaUnavailable
from c2s_engine.models.errors import ModelError
from c2s_engine.retrieve.errors import RetrievalError

OK, REFUSED, BAD_INPUT, NO_SERVICE, INTERRUPTED = 0, 1, 2, 3, 130
"""Exit codes: done; the scenario or program has a fault that is named; the input cannot be used; a service, file or
permission is missing; interrupted by the user."""


class _Unheard(Console):
    """The console for what is said along the way: work goes on, in silence, where nobody reads it any more."""

    def on_broken_pipe(self) -> None:
        self.quiet = True
        with contextlib.suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stderr.fileno())


out = Console(highlight=False)
err = _Unheard(stderr=True, highlight=False)


class InputError(ValueError):
    """The input cannot be used; one sentence that says why and what to do."""


def may_save(output: str | Path | None) -> None:
    """Refuse, before anything is done, to save where no folder is, or over what c2s did not save as it is; raises
    InputError."""
    from c2s_engine.saving import not_as_saved

    if output and not Path(output).parent.exists():
        raise InputError(f"There is no folder {Path(output).parent}: make it, or save elsewhere.")
    if output and Path(output).is_file() and not_as_saved(Path(output)):
        raise InputError(f"{output} is there already and is not as c2s saved it: save elsewhere, or remove it first.")


def fail(message: str, code: int = BAD_INPUT, as_json: bool = False) -> NoReturn:
    """Say one sentence and leave."""
    if as_json:
        print(json.dumps({"ok": False, "error": message}))
    else:
        err.print(Text(f"c2s: {message}", style="red"))
    raise typer.Exit(code)


def dump(value: Any) -> None:
    """One JSON object on stdout."""
    print(json.dumps(value, ensure_ascii=False, indent=2, default=str))


def sentence(error: Exception) -> tuple[str, int] | None:
    """What is said of an error that may happen, and its exit code; None for those that nobody foresaw."""
    if isinstance(error, PermissionError):
        return (
            f"Permission denied for {error.filename}: choose another place, or change its permissions.",
            NO_SERVICE,
        )
    if isinstance(error, OSError):
        where = f" ({error.filename})" if error.filename else ""
        advice = " Free some space and try again." if error.errno == 28 else ""
        return f"{error.strerror or error}{where}.{advice}", NO_SERVICE
    if isinstance(error, CarlaUnavailable):
        return str(error), NO_SERVICE
    ours = type(error).__module__.split(".")[0] in ("c2s_engine", "c2s_bench")
    if ours and isinstance(error, LookupError | ValueError | RuntimeError | ModelError | RetrievalError):
        return str(error), BAD_INPUT
    return None


@contextlib.contextmanager
def sentences(as_json: bool = False) -> Iterator[None]:
    """Turn what can go wrong outside the program into one sentence and an exit code."""
    try:
        yield
    except BrokenPipeError:
        sys.stderr.close()
        os._exit(OK)
    except (KeyboardInterrupt, asyncio.CancelledError):
        fail("Interrupted; nothing was written.", INTERRUPTED, as_json)
    except Exception as error:
        if (said := sentence(error)) is None:
            raise
        fail(*said, as_json)


def work(coroutine: Coroutine[Any, Any, Any], as_json: bool = False) -> Any:
    """Run to the end, or say in a sentence why not."""
    with sentences(as_json):
        return asyncio.run(coroutine)
    return None
