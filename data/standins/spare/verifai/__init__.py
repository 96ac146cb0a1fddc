"""Inert stand-in for VerifAI: its samplers' interface as far as Scenic uses it, drawn uniformly."""
