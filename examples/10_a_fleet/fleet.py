"""What each machine of a fleet lacks: fleet.py FOLDER MODEL [PROCESSES]

FOLDER holds a folder for each machine with its measurements, dataset.toml, and its own model.toml where it has one (else
MODEL). Every machine is diagnosed, several at a time; the table says which effects its model lacks."""
import concurrent.futures
import pathlib
import sys

import plumbline


def diagnose_all(folder, model, executor):
    """(name of the machine, Result or Error) for each, in the order of the names."""
    machines = sorted(path.parent for path in pathlib.Path(folder).glob("*/dataset.toml"))
    own = [machine / "model.toml" for machine in machines]
    jobs = [{"model": str(path if path.exists() else model), "dataset": str(machine / "dataset.toml")}
            for path, machine in zip(own, machines)]
    return zip([machine.name for machine in machines], plumbline.map(jobs, executor, function=plumbline.diagnose))


def row(name, done):
    """What a line of the table says: rms of the bar's readings that the model leaves, um, without and with what was found."""
    if isinstance(done, plumbline.Error):
        return name, "", "", f"refused: {done.message}"
    summary = done.summary
    rms = summary["gap"]["fit"]["radial_rms_um"] or {"before": None, "after": None}
    shown = ["" if rms[when] is None else f"{rms[when]:.2f}" for when in ("before", "after")]
    lacks = {"named": " and ".join(" or ".join([one["name"], *one["alternatives"]]) for one in summary["effects"]),
             "nothing-missing": "nothing", "unknown": "something that the catalogue has not"}
    return name, *shown, lacks[summary["verdict"]]


def main(folder, model, processes="2"):
    print(f"{'machine':<12} {'um off':>8} {'with it':>8}  its model lacks")
    refused = False
    with concurrent.futures.ProcessPoolExecutor(int(processes)) as executor:
        for name, done in diagnose_all(folder, model, executor):
            machine, before, after, found = row(name, done)
            print(f"{machine:<12} {before:>8} {after:>8}  {found}", flush=True)
            refused = refused or isinstance(done, plumbline.Error)
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
