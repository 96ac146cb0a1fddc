"""What the HeaderGenerator is told: the settings that were taken, in the words of CARLA and of the map at hand."""

from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, SettingsSpec
from c2s_engine.write.typed.settings import weather_parameters

DEFAULT_MODEL = "vehicle.lincoln.mkz_2017"
"""Ego's blueprint where none is detected (the paper, "Global Configuration Generator")."""


@dataclass(frozen=True)
class Ground:
    """The map that programs are written for: its file's name beside the program, CARLA's name for it (if any)."""

    map_file: str = "town.xodr"
    carla_map: str | None = None


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
    if spec.light:
        lines.append(f"- the traffic light that ego faces: '{spec.light}'")
    return "\n".join(lines)
