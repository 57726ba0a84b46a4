"""The JAX back end; JAX is imported here and nowhere else.

``functions(chain, precision, forward_mode, methods)``: the functions by name. ``w_ext`` is (n, 6);
``step_<method> (q, v, tau, w_ext, p, dt) -> (q, v)``; where a joint cannot be solved for all results are NaN.
``precision``: ``"double"``, which needs ``jax_enable_x64``, or ``"single"``; ``forward_mode``: for ``jvp`` and
``jacfwd``, at minutes of compiling; ``methods``: integrators beside the built-in ones.
"""

from ...errors import UsageError

try:
    from .functions import functions as functions
except ModuleNotFoundError as missing:
    if (missing.name or "").partition(".")[0] not in ("jax", "jaxlib"):
        raise
    raise UsageError("JAX is not installed; pip install 'screwgen[jax]'") from None
