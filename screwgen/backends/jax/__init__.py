"""The JAX back end; JAX is imported here and nowhere else."""

from ...errors import UsageError

try:
    from .functions import functions as functions
except ModuleNotFoundError as missing:
    if (missing.name or "").partition(".")[0] not in ("jax", "jaxlib"):
        raise
    raise UsageError("JAX is not installed; pip install 'screwgen[jax]'") from None
