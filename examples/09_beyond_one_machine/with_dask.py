"""All programs of a folder by workers of Dask: with_dask.py FOLDER OUT MODEL [ADDRESS]

ADDRESS is that of a Dask scheduler whose workers have plumbline (`dask scheduler`, `dask worker tcp://...`); without it two
worker processes are started here. Texts go to the workers and come back: they need no folder in common."""
import pathlib
import sys

import plumbline
from distributed import Client, LocalCluster


def jobs_of(folder, model):
    """The names of the programs, and a job for each."""
    names = sorted(path.relative_to(folder) for path in folder.rglob("*.nc"))
    machine = plumbline.Model(model)
    return names, [{"program": plumbline.Text((folder / name).read_bytes(), name), "model": machine,
                    "work_offset": {"G54": (0, 0, -1008, 0, 0, 0)}} for name in names]


def straighten(folder, out, model, client):
    """Writes each output into its place in `out`; gives the programs that were refused, with the reason."""
    folder, out = pathlib.Path(folder), pathlib.Path(out)
    names, jobs = jobs_of(folder, model)
    refused = {}
    for name, done in zip(names, plumbline.map(jobs, client.get_executor())):
        if isinstance(done, plumbline.Error):
            refused[str(name)] = done
            continue
        place = out / name
        place.parent.mkdir(parents=True, exist_ok=True)
        part = place.with_name(f".{place.name}.part")
        part.write_bytes(done.bytes)
        part.rename(place)  # whole or not at all
    return refused


def main(folder, out, model, address=None):
    with Client(address or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)) as client:
        refused = straighten(folder, out, model, client)
    for name, why in refused.items():
        print(f"{name}: {why}", file=sys.stderr)
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
