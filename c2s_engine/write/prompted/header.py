"""What the HeaderGenerator is told: the settings that were taken, in the words of CARLA and of the map at hand."""

from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, SettingsSpec
from c2s_engine.write.typed.settings import weather_parameters

DEFAULT_MODEL = "vehicle.lincoln.mkz_2017"
"""Ego's blueprint where none is detected (the paper, "Global Configuration Generator")."""


@dataclass(frozen=True)
class Ground:
    """The map that programs are written for: its file's name beside the program, CARLA's name for it (if any)."""

    map_file: str = "town.xodr"
    carla_map: str | None = None


def light_of(structure: Structure) -> str | None:
    """The light that ego faces: as told; green where another runs its red light, so that ego may go."""
    spec = structure.settings.spec
    told = spec.light if isinstance(spec, SettingsSpec) else None
    runs = (p.action == "run_red" for o in structure.objects if isinstance(o.spec, ObjectSpec) for p in o.spec.phases)
    return told or ("green" if any(runs) else None)


def is_default_header(structure: Structure) -> bool:
    """Whether the header is the default one: then there is nothing to ask."""
    spec = structure.settings.spec
    default = SettingsSpec(map=spec.map if isinstance(spec, SettingsSpec) else None)
    return not structure.settings.description and spec == default and light_of(structure) is None


def plain(structure: Structure, ground: Ground) -> str:
    """The default header."""
    ego = structure.ego.spec
    model = ego.model if isinstance(ego, EgoSpec) and ego.model else DEFAULT_MODEL
    return (
        f"param map = localPath('{ground.map_file}')\nparam carla_map = {ground.carla_map!r}\nparam timestep = 0.1\n"
        f"param weather = 'ClearNoon'\nmodel scenic.simulators.carla.model\n\nEGO_MODEL = '{model}'"
    )


def settings_text(structure: Structure, ground: Ground) -> str:
    """The settings, one a line."""
    spec = structure.settings.spec
    assert isinstance(spec, SettingsSpec)
    ego = structure.ego.spec
    model = ego.model if isinstance(ego, EgoSpec) and ego.model else DEFAULT_MODEL
    plain = not spec.weather and not spec.time and not spec.preset and not spec.parameters
    parameters = ", ".join(f"'{k}': {v:g}" for k, v in weather_parameters(spec).items())
    weather = (
        "the preset 'ClearNoon'" if plain else f"the preset '{spec.preset}'" if spec.preset else f"{{{parameters}}}"
    )
    said = ", ".join([*spec.weather, *([spec.time] if spec.time else [])])
    lines = [
        f"- map: localPath('{ground.map_file}')",
        f"- carla_map: {ground.carla_map!r}",
        "- timestep: 0.1",
        f"- weather: {weather}" + (f" ({said})" if said else ""),
        f"- ego's blueprint: '{model}'",
    ]
    if light := light_of(structure):
        lines.append(f"- the traffic light that ego faces: '{light}'")
    return "\n".join(lines)
