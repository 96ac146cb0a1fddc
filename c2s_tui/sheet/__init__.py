"""The structure pane: S as a sheet of components and their typed fields."""
