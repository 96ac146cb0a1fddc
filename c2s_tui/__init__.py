"""The terminal app: chat, structure and live Scenic code, kept in step, over the engine's facade."""
