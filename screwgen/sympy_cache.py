"""How much sympy remembers: imported before anything that imports sympy.

Derivations come back to the same subexpressions by the thousand. Sympy keeps the last 1,000 results of every operation,
which are gone when they are asked for again: with 20,000 a derivation takes 0.6 of the time. Who has set
SYMPY_CACHE_SIZE, or has imported sympy before, has decided otherwise.
"""

import os

os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
