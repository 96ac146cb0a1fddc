"""What the modules of this package ask of the facade above them (`c2s_engine.api.Engine`), which they cannot import."""

from collections.abc import AsyncGenerator, Sequence
from contextlib import AbstractAsyncContextManager
from typing import TYPE_CHECKING, Any, Protocol

from c2s_engine.check.protocol import CheckReport
from c2s_engine.config import Settings
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.progress import Progress

if TYPE_CHECKING:
    from c2s_engine.session.requiring import Judged
    from c2s_engine.session.steps import Tools


class Turns(Protocol):
    """A session's turns. `options`: those of the facade's methods."""

    def say(self, structure: Structure, text: str, /, *_: Any, **options: Any) -> AsyncGenerator[Progress, None]: ...

    def apply(self, structure: Structure, edits: Any, /, *_: Any, **options: Any) -> AsyncGenerator[Progress, None]: ...

    async def without_effect(
        self, text: str, structure: Structure, before: Structure | None = None
    ) -> Sequence[Unmet]: ...


class Checking(Protocol):
    """Checks and runs of a program as it stands, and what they showed of S."""

    async def check(self, program: str, /, *_: Any, **options: Any) -> CheckReport: ...

    async def judge(self, structure: Structure | None, report: CheckReport, *, seed: int = 0) -> "Judged": ...


class Facade(Protocol):
    """What a turn of the chat may lead to."""

    @property
    def settings(self) -> Settings: ...

    @property
    def tools(self) -> "Tools": ...

    def generate(self, text: str, /, *_: Any, **options: Any) -> AsyncGenerator[Progress, None]: ...

    def apply(self, structure: Structure, edits: Any, /, *_: Any, **options: Any) -> AsyncGenerator[Progress, None]: ...

    async def search(self, query: str, *, kind: str = "doc", component: str | None = None, limit: int = 5) -> list[Any]:
        ...

    def model_client(self) -> AbstractAsyncContextManager[Any]: ...
