"""The same manoeuvres in the dry run and in CARLA, and how far apart they come out (data/calibration.yaml)."""
