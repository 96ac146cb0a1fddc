"""What can go wrong with a language model: one class and one sentence each, for the user as it stands."""


class ModelError(Exception):
    """Base of all faults of a language model.

    `retry`: whether asking again is worth it. `service`: whether Ollama, the model or a setting of theirs is missing,
    rather than an answer being bad.
    """

    retry = False
    service = False


class ModelNotSet(ModelError):
    """No model was chosen."""

    service = True

    def __init__(self) -> None:
        super().__init__(
            "No language model is chosen: set one with `--model NAME`, C2S_MODEL or in config.toml (`c2s models "
            "list` shows what is there), or stay with the method reader, which needs none."
        )


class BadSettings(ModelError):
    """The settings of the models cannot be used."""

    service = True

    def __init__(self, field: str, reason: str) -> None:
        super().__init__(f"config.toml, [ollama] {field}: {reason}. Mend that line or remove it.")


class ModelUnavailable(ModelError):
    """Nobody answers at the host."""

    service = True

    def __init__(self, host: str) -> None:
        super().__init__(
            f"Ollama does not answer at {host}: start it (`ollama serve`) or set OLLAMA_HOST; "
            "the method reader works without it."
        )


class ModelMissing(ModelError):
    """The host has no such model."""

    service = True

    def __init__(self, model: str, host: str) -> None:
        super().__init__(f"Ollama at {host} has no model {model}: get it with `c2s models pull {model}`.")


class ModelNotFetched(ModelError):
    """The host cannot fetch a model."""

    service = True

    def __init__(self, model: str, host: str, reason: str) -> None:
        detail = reason.strip().rstrip(".") or "no reason given"
        super().__init__(
            f"Ollama at {host} cannot fetch {model} ({detail}): check the name (`c2s models suggest` lists some) and "
            "its connection to the internet."
        )


class ModelBusy(ModelError):
    """The host refused for now (429, 503)."""

    retry = True
    service = True

    def __init__(self, host: str) -> None:
        super().__init__(f"Ollama at {host} has too many requests waiting: try again in a moment.")


class ModelTimeout(ModelError):
    """The host said nothing for too long. Not retried: the next try would take as long."""

    service = True

    def __init__(self, model: str, seconds: float) -> None:
        super().__init__(
            f"{model} sent nothing for {seconds:g} s: it may still be loading or be too large for this machine; "
            "raise timeout under [ollama] in config.toml or take a smaller model."
        )


class ModelCutOff(ModelError):
    """The stream ended before the model was done."""

    retry = True

    def __init__(self, model: str, reason: str = "") -> None:
        detail = f" ({reason})" if reason else ""
        super().__init__(
            f"The answer of {model} broke off before its end{detail}: Ollama's log says why, often memory ran out."
        )


class ModelRefused(ModelError):
    """The host answered with an error that asking again will not change."""

    service = True

    def __init__(self, model: str, status: int, reason: str) -> None:
        super().__init__(f"Ollama refused the request for {model} ({status}): {reason.strip() or 'no reason given'}.")


class ModelFailed(ModelError):
    """The host failed inside (5xx)."""

    retry = True

    def __init__(self, model: str, reason: str) -> None:
        super().__init__(f"Ollama failed while running {model}: {reason.strip() or 'no reason given'}.")


class ContextOverflow(ModelError):
    """The prompt does not fit the context, so that its beginning would be cut away silently."""

    def __init__(self, tokens: int, num_ctx: int, largest: bool = False) -> None:
        remedy = "take a model with a larger one" if largest else "raise num_ctx under [ollama] in config.toml"
        whose = "the model's largest context" if largest else "the context"
        said = f"The prompt (about {tokens} tokens) does not fit {whose} of {num_ctx} tokens"
        super().__init__(f"{said}: {remedy} or shorten the text.")


class AnswerTruncated(ModelError):
    """The model stopped because its answer's room was used up (done_reason "length")."""

    def __init__(self, model: str, tokens: int) -> None:
        super().__init__(f"The answer of {model} was cut after {tokens} tokens: it did not come to an end.")


class AnswerRepeats(ModelError):
    """The model says the same thing over and over; it was stopped."""

    def __init__(self, model: str) -> None:
        super().__init__(f"{model} kept repeating itself and was stopped.")


class AnswerUnusable(ModelError):
    """The answer is empty, or not what was asked for (no JSON, not of the schema, no code)."""

    def __init__(self, reason: str) -> None:
        super().__init__(f"The model's answer cannot be used: {reason}.")


class NotRecorded(ModelError):
    """A replay met a request that was never recorded."""

    service = True

    def __init__(self, purpose: str, folder: str) -> None:
        super().__init__(
            f"There is no recorded answer for this request ({purpose}) in {folder}: record it first with a model."
        )
