"""A sweep on workers of MPI: ``mpiexec -n 3 python -m mpi4py.futures mpi_sweep.py STORE [kill]``, run by a test.

`kill`: one of the workers is killed midway.
"""

import os
import signal
import sys

from dask_sweep import ARM, HOW, drawn
from helpers import model_of

from screwgen import sweep

COUNT = 1024


def main() -> None:
    from mpi4py.futures import MPIPoolExecutor

    store, *kill = sys.argv[1:]
    with MPIPoolExecutor() as executor:
        workers, started = executor.num_workers, []

        def progress(done: int, count: int) -> None:
            started.append(done)
            if kill and done >= count // 4:
                os.kill(executor.submit(os.getpid).result(), signal.SIGKILL)

        found = sweep(model_of(ARM), drawn, COUNT, store, **HOW, executor=executor, progress=progress)
        print(f"complete {found.ok.all()}, {workers} workers, first {started[0]}")


if __name__ == "__main__":
    main()
