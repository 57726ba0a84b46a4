"""A search without derivatives: an evolution strategy whose steps become shorter where few of them lead to better."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

PAIRS, PARENTS = 8, 4
"""Opposite steps that are tried together, and how many of the best are followed."""
FIRST, LEAST = 0.4, 0.02
"""The length of steps at the start, and that at which the search ends, over the size of the numbers."""
QUICKNESS, SUCCESS = 0.6, 0.2
"""How fast lengths follow the share of better steps, and the share at which they stay."""


def minimised(
    score: Callable[[np.ndarray], np.ndarray],
    start: np.ndarray,
    generations: int,
    rng: np.random.Generator,
    progress: Callable[[int, float], None] | None = None,
) -> np.ndarray:
    """Numbers (n,) whose score is low, of which only the proportions count; an interruption ends with the best so far.

    `score` of rows (m, n) gives (m,). `start`: the first numbers. `progress` is told generation and least score.
    """
    at = best = _sized(start)
    least, length = float(score(best[None])[0]), FIRST
    weights = np.log(PARENTS + 0.5) - np.log(np.arange(1, PARENTS + 1))
    weights /= weights.sum()
    try:
        for generation in range(generations):
            half = rng.standard_normal((PAIRS, len(at)))
            steps = np.vstack([half, -half])
            found = score(at + length * steps)
            order = np.argsort(found, kind="stable")
            better = float(np.mean(found < least))
            if found[order[0]] < least:
                best, least = at + length * steps[order[0]], float(found[order[0]])
            at = _sized(at + length * weights @ steps[order[:PARENTS]])
            length = min(length * float(np.exp(QUICKNESS * (better - SUCCESS))), 1.0)
            if progress:
                progress(generation, least)
            if length < LEAST:
                break
    except KeyboardInterrupt:
        pass
    return best


def _sized(numbers: np.ndarray) -> np.ndarray:
    """The numbers of mean square one."""
    return np.asarray(numbers * np.sqrt(len(numbers)) / np.linalg.norm(numbers))
