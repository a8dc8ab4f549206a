"""Dask clusters whose workers are threads of this process."""

import gc
import warnings
from contextlib import contextmanager


@contextmanager
def cluster_here(distributed):
    """The address of the scheduler.

    Dask leaves sockets to the collector of garbage, which says so in whatever test it happens to
    run; so it runs here.
    """
    with distributed.LocalCluster(2, processes=False, dashboard_address="127.0.0.1:0") as cluster:
        yield cluster.scheduler_address
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        gc.collect()
