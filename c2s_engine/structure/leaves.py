"""Values within specs and plain data: by their path, and all that are in them."""

from collections.abc import Iterator


def leaves(value: object) -> Iterator[object]:
    """The values in nested dicts, lists and tuples that are neither, in order."""
    if isinstance(value, dict | list | tuple):
        for inner in value.values() if isinstance(value, dict) else value:
            yield from leaves(inner)
    else:
        yield value


def value_at(spec: object, path: str) -> object:
    """A field's value by its path ("placement.gap", "phases.0.trigger"); None where there is no such field."""
    for name in path.split("."):
        if isinstance(spec, tuple) and name.isdigit():
            spec = spec[int(name)] if int(name) < len(spec) else None
        else:
            spec = getattr(spec, name, None)
    return spec
