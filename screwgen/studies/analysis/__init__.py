"""The analysis of a robot's equations in a state: regularity, vibrations, stable step sizes."""

from .analyse import SAMPLES, Analysis, analyse, sample_states

__all__ = ["SAMPLES", "Analysis", "analyse", "sample_states"]
