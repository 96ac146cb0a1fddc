"""The faults of the `ollama` package and httpx, said as this project's errors."""

from collections.abc import Iterator
from contextlib import contextmanager

from c2s_engine.models.errors import (
    ModelBusy,
    ModelCutOff,
    ModelError,
    ModelFailed,
    ModelMissing,
    ModelNotSet,
    ModelRefused,
    ModelTimeout,
    ModelUnavailable,
)
from c2s_engine.models.settings import ModelSettings


def translate(error: Exception, settings: ModelSettings, model: str = "") -> ModelError:
    """The error of ours for one of theirs."""
    import httpx
    import ollama

    model = model or settings.model
    if isinstance(error, ModelError):
        return error
    if isinstance(error, ollama.ResponseError):
        status, reason = error.status_code, str(error.error)
        if status == 404:
            return ModelMissing(model, settings.host) if model else ModelNotSet()
        if status in (429, 503):
            return ModelBusy(settings.host)
        if status == -1:
            return ModelCutOff(model, reason)
        if status >= 500:
            return ModelFailed(model, reason)
        return ModelRefused(model, status, reason)
    if isinstance(error, httpx.ReadTimeout | httpx.WriteTimeout | httpx.PoolTimeout):
        return ModelTimeout(model, settings.timeout)
    if isinstance(error, ConnectionError | httpx.ConnectError | httpx.ConnectTimeout):
        return ModelUnavailable(settings.host)
    if isinstance(error, httpx.TransportError):
        return ModelCutOff(model, type(error).__name__)
    if isinstance(error, httpx.InvalidURL | httpx.UnsupportedProtocol):
        return ModelUnavailable(settings.host)
    return ModelCutOff(model, f"unreadable answer: {type(error).__name__}")


@contextmanager
def translated(settings: ModelSettings, model: str = "") -> Iterator[None]:
    """Whatever goes wrong inside comes out as a ModelError; cancellation passes through."""
    try:
        yield
    except ModelError:
        raise
    except GeneratorExit:
        raise
    except Exception as error:
        raise translate(error, settings, model) from None
