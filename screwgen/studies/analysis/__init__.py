"""The analysis of a robot's equations in a state: regularity, vibrations, stable step sizes."""

from .analyse import SAMPLES, Analysis, analyse, first_state, sample_states

__all__ = ["SAMPLES", "Analysis", "analyse", "first_state", "sample_states"]
