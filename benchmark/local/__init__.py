"""A model served for c2s where Ollama itself cannot be had; see README.md. Nothing of c2s imports it."""
