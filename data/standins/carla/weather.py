"""Weather parameters, and the presets with the values that CARLA 0.9.15 publishes for them."""

FIELDS = (
    "cloudiness", "precipitation", "precipitation_deposits", "wind_intensity", "sun_azimuth_angle",
    "sun_altitude_angle", "fog_density", "fog_distance", "fog_falloff", "wetness", "scattering_intensity",
    "mie_scattering_scale", "rayleigh_scattering_scale", "dust_storm",
)

# cloudiness, precipitation, deposits, wind, sun altitude, fog density, fog distance, fog falloff, wetness, dust
PRESETS = {
    "ClearNoon": (5, 0, 0, 10, 45, 2, 0.75, 0.1, 0, 0),
    "CloudyNoon": (60, 0, 0, 10, 45, 3, 0.75, 0.1, 0, 0),
    "WetNoon": (5, 0, 50, 10, 45, 3, 0.75, 0.1, 0, 0),
    "WetCloudyNoon": (60, 0, 50, 10, 45, 3, 0.75, 0.1, 0, 0),
    "SoftRainNoon": (20, 30, 50, 30, 45, 3, 0.75, 0.1, 0, 0),
    "MidRainyNoon": (60, 60, 60, 60, 45, 3, 0.75, 0.1, 0, 0),
    "HardRainNoon": (100, 100, 90, 100, 45, 7, 0.75, 0.1, 0, 0),
    "ClearSunset": (5, 0, 0, 10, 15, 2, 0.75, 0.1, 0, 0),
    "CloudySunset": (60, 0, 0, 10, 15, 3, 0.75, 0.1, 0, 0),
    "WetSunset": (5, 0, 50, 10, 15, 2, 0.75, 0.1, 0, 0),
    "WetCloudySunset": (60, 0, 50, 10, 15, 2, 0.75, 0.1, 0, 0),
    "SoftRainSunset": (20, 30, 50, 30, 15, 2, 0.75, 0.1, 0, 0),
    "MidRainSunset": (60, 60, 60, 60, 15, 3, 0.75, 0.1, 0, 0),
    "HardRainSunset": (100, 100, 90, 100, 15, 7, 0.75, 0.1, 0, 0),
    "ClearNight": (5, 0, 0, 10, -90, 60, 75, 1, 0, 0),
    "CloudyNight": (60, 0, 0, 10, -90, 60, 0.75, 0.1, 0, 0),
    "WetNight": (5, 0, 50, 10, -90, 60, 75, 1, 60, 0),
    "WetCloudyNight": (60, 0, 50, 10, -90, 60, 0.75, 0.1, 60, 0),
    "SoftRainNight": (60, 30, 50, 30, -90, 60, 0.75, 0.1, 60, 0),
    "MidRainyNight": (80, 60, 60, 60, -90, 60, 0.75, 0.1, 80, 0),
    "HardRainNight": (100, 100, 90, 100, -90, 100, 0.75, 0.1, 100, 0),
    "DustStorm": (100, 0, 0, 100, 45, 2, 0.75, 0.1, 0, 100),
}


class WeatherParameters:
    """Percentages 0..100; sun angles in degrees; fog distance in metres."""

    def __init__(
        self, cloudiness=0.0, precipitation=0.0, precipitation_deposits=0.0, wind_intensity=0.0, sun_azimuth_angle=0.0,
        sun_altitude_angle=0.0, fog_density=0.0, fog_distance=0.0, fog_falloff=0.0, wetness=0.0,
        scattering_intensity=0.0, mie_scattering_scale=0.0, rayleigh_scattering_scale=0.0331, dust_storm=0.0,
    ):
        values = locals()
        for field in FIELDS:
            setattr(self, field, float(values[field]))

    def __eq__(self, other):
        return isinstance(other, WeatherParameters) and other.__dict__ == self.__dict__

    __hash__ = None

    def __repr__(self):
        return f"WeatherParameters({', '.join(f'{k}={v:f}' for k, v in self.__dict__.items())})"


for _name, _values in PRESETS.items():
    _cloud, _rain, _deposits, _wind, _altitude, _fog, _distance, _falloff, _wetness, _dust = _values
    setattr(
        WeatherParameters, _name,
        WeatherParameters(
            _cloud, _rain, _deposits, _wind, -1.0, _altitude, _fog, _distance, _falloff, _wetness, 1.0, 0.03, 0.0331, _dust
        ),
    )
WeatherParameters.Default = WeatherParameters(*([-1.0] * 10), 1.0, 0.03, 0.0331, 0.0)
