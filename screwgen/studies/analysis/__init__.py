"""What a robot's equations are like in a state: regular or not, how they vibrate, which steps they bear."""

from .analyse import SAMPLES, Analysis, analyse, sample_states

__all__ = ["SAMPLES", "Analysis", "analyse", "sample_states"]
