"""A table that is too large for one machine, divided by rows over the workers of Dask.

`python dask_table.py` makes a cluster of two processes on this machine. On a real one, give Client the address of its
scheduler: `Client("tcp://scheduler:8786")`.
"""

import numpy as np
import plm_impact as plm
from dask.distributed import Client, LocalCluster
from numpy.typing import NDArray


def rows(contact: plm.Contact, keys: dict[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    """The rows of one piece: a contact and arrays travel to the worker, arrays come back."""
    return plm.impacts(contact, **keys).to_dict()


def divided(
    client: Client, contact: plm.Contact, pieces: int, **keys: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """The table of `plm.impacts(contact, **keys)`, in flat columns. Its numbers do not depend on `pieces`."""
    flat = {name: array.ravel() for name, array in zip(keys, np.broadcast_arrays(*keys.values()))}
    parts = [dict(zip(flat, part)) for part in zip(*(np.array_split(array, pieces) for array in flat.values()))]
    tables = client.gather(client.map(rows, [contact] * len(parts), parts))
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


if __name__ == "__main__":
    steel = {"youngs_modulus": 210e9, "poissons_ratio": 0.3}
    contact = plm.Contact(
        sphere={"radius": 5e-3, "density": 7850, **steel}, half_space={"yield_strength": 345e6, **steel}
    )
    speeds, radii = np.logspace(-3, 0.3, 1000), np.linspace(1e-3, 5e-3, 40)[:, np.newaxis]
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        table = divided(client, contact, 16, speed=speeds, radius=radii)
    whole = plm.impacts(contact, speed=speeds, radius=radii)
    same = all(
        np.array_equal(table[name], whole[name].ravel(), equal_nan=whole[name].dtype.kind == "f") for name in whole
    )
    print(f"{len(table['restitution'])} rows, the same as undivided: {same}")
