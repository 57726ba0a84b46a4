"""`python -m screwgen` is the command `screwgen`."""

import sys

from .cli.main import main

if __name__ == "__main__":
    sys.exit(main())
