"""A sweep on two workers of dask, one of which is killed midway: ``python dask_sweep.py STORE``, run by a test."""

import multiprocessing
import os
import signal
import sys

import numpy as np
from helpers import model_of

from screwgen import sweep

LINK = {"length": 0.5, "section": {"rhoA": 2.0, "EIz": 400.0}, "bodies": [{"at": "tip", "mass": 1.5}]}
LINK |= {"modes": {"bending_y": 1}, "joint": {"axes": ["z"]}}
ARM = {"name": "swept", "gravity": [0.0, -9.81, 0.0], "links": [{"name": "a", **LINK}]}
HOW = {"step": 1e-3, "steps": 50, "substeps": 10, "chunk": 64}
COUNT = 4096


def drawn(rng, n: int) -> dict:
    return {"x0": np.hstack([rng.uniform(-1, 1, (n, 1)), np.zeros((n, 3))])}


def main() -> None:
    from dask.distributed import Client, LocalCluster

    cluster = LocalCluster(2, threads_per_worker=1, processes=True, dashboard_address=None)
    with cluster, Client(cluster) as client:
        pids, killed = list(client.run(os.getpid).values()), []

        def kill(done: int, count: int) -> None:
            if done >= count // 8 and not killed:
                os.kill(pids[0], signal.SIGKILL)
                killed.append(pids[0])

        found = sweep(model_of(ARM), drawn, COUNT, sys.argv[1], **HOW, executor=client.get_executor(), progress=kill)
        print(f"complete {found.ok.all()}, killed {len(killed)} of {len(pids)}")


if __name__ == "__main__":
    multiprocessing.freeze_support()
    main()
