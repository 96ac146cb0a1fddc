"""What the concerns of the workbench have in common: each is a class of its own that knows the workbench."""

from collections.abc import Callable, Coroutine
from functools import partial, wraps
from typing import TYPE_CHECKING, Any, Concatenate, ParamSpec, TypeVar, cast

from textual.worker import Worker

if TYPE_CHECKING:
    from c2s_engine.session.session import Session
    from c2s_tui.app import C2SApp
    from c2s_tui.backend import Backend
    from c2s_tui.chat.pane import ChatPane
    from c2s_tui.desk import Desk
    from c2s_tui.workbench import Workbench

P = ParamSpec("P")
Some = TypeVar("Some", bound="Part")


class Part:
    """One concern of the workbench. A method `do_NAME(argument)` is the command NAME."""

    def __init__(self, bench: "Workbench"):
        self.bench = bench

    @property
    def app(self) -> "C2SApp":
        return cast("C2SApp", self.bench.app)

    @property
    def chat(self) -> "ChatPane":
        return self.bench.chat

    @property
    def backend(self) -> "Backend":
        return self.bench.backend

    @property
    def desk(self) -> "Desk":
        return self.bench.desk

    @desk.setter
    def desk(self, desk: "Desk") -> None:
        self.bench.desk = desk

    @property
    def session(self) -> "Session":
        """The session that is open; commands that need one ask `Turns.may_begin` first."""
        assert self.bench.session is not None
        return self.bench.session


Doing = Callable[Concatenate[Some, P], Coroutine[Any, Any, None]]
Started = Callable[Concatenate[Some, P], Worker[None]]


def background(group: str, exclusive: bool = True) -> Callable[[Doing[Some, P]], Started[Some, P]]:
    """Run a part's method as a worker of the workbench; an exclusive one cancels those of its group before it."""

    def wrap(method: Doing[Some, P]) -> Started[Some, P]:
        @wraps(method)
        def start(part: Some, *arguments: P.args, **options: P.kwargs) -> Worker[None]:
            work = partial(method, part, *arguments, **options)  # no coroutine yet: it may be cancelled before
            name = method.__name__
            return part.bench.run_worker(work, name, group, exclusive=exclusive, exit_on_error=False)

        return start

    return wrap


def sentence(error: BaseException) -> str:
    """What an error says, in one line."""
    text = str(error).strip() or type(error).__name__
    return text.splitlines()[0]
