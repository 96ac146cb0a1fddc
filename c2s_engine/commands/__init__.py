"""The commands of `c2s`, one module each; `c2s_engine.cli` puts them together."""
