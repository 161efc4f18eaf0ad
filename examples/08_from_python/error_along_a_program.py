"""The error of the tool tip along a program before and after compensation, and over the table: numbers and a picture.

usage: error_along_a_program.py PROGRAM MODEL [PICTURE.png]
"""
import sys

import numpy as np

import plumbline

program, path = sys.argv[1:3]
offset = {"G54": (0, 0, -1008, 0, 0, 0)}
model = plumbline.Model(path)

# Along the program
straight = plumbline.compensate(program, model, work_offset=offset)
before = plumbline.simulate(program, model, work_offset=offset)


def distance(table):
    return np.hypot(np.hypot(table["dx_um"], table["dy_um"]), table["dz_um"])


cut = before["motion"] > 0
print(f"before: the tip up to {distance(before)[cut].max():.1f} um off")
print(f"corrected by up to {straight.summary['largest_correction_mm']['value'] * 1000:.1f} um, "
      f"at most {straight.summary['worst_residual_um']['value']:.2f} um are left")

# Over the table, at one height
x, y = np.meshgrid(np.linspace(-150, 150, 31), np.linspace(-150, 150, 31))
poses = np.zeros((x.size, 6))
poses[:, 0], poses[:, 1], poses[:, 2] = x.ravel(), y.ravel(), -1008
sag = plumbline.error(poses, model)["dz_um"].reshape(x.shape)
print(f"at Z-1008 the tip sags by {-sag.max():.1f} to {-sag.min():.1f} um")

if len(sys.argv) > 3:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (along, over) = pyplot.subplots(1, 2, figsize=(11, 4))
    along.plot(before["time_s"], distance(before))
    along.set(xlabel="s", ylabel="um", title="error of the tip before")
    picture = over.contourf(x, y, sag, 20)
    over.set(xlabel="X mm", ylabel="Y mm", title="dz at Z-1008, um", aspect="equal")
    figure.colorbar(picture)
    figure.savefig(sys.argv[3])
