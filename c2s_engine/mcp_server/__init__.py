"""The engine as tools of the Model Context Protocol, so that an assistant in an editor can drive it."""
