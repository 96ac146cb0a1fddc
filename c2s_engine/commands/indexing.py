"""What `c2s index add` needs for users' own programs: the importer that takes them apart, a model to describe parts."""

import contextlib
from collections.abc import AsyncIterator

from c2s_engine.config import load_settings
from c2s_engine.retrieve.client import Describe
from c2s_engine.retrieve.commands import Parts


@contextlib.asynccontextmanager
async def parts() -> AsyncIterator[Parts]:
    """`program -> S` by the check server, and `(component, code) -> sentence` by the settings' model, if any."""
    from c2s_engine.api import Engine

    settings = load_settings()
    async with contextlib.AsyncExitStack() as stack:
        engine = await stack.enter_async_context(Engine(settings))
        describe: Describe | None = None
        if settings.model:
            from c2s_engine.interpret.llm.snippets import Describer

            describe = Describer(await stack.enter_async_context(engine.model_client()))
        yield engine.import_program, describe
