"""A picture of points and cameras in space, as SVG. It needs matplotlib."""

import matplotlib
import numpy as np

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "pointline"
from matplotlib import pyplot


def draw(path, points, cameras):
    """Draws points (N, 3) and cameras: triples of a name, R (V, 3, 3) and t (V, 3)."""
    axes = pyplot.figure(figsize=(6, 4.5)).add_subplot(projection="3d")
    axes.scatter(points[:, 0], points[:, 2], -points[:, 1], s=4, color="grey", label="points")
    for (name, Rs, ts), color in zip(cameras, ["black", "red", "blue"]):
        centres = -np.einsum("vji,vj->vi", Rs, ts)
        axes.scatter(centres[:, 0], centres[:, 2], -centres[:, 1], color=color, label=name)
        for c, axis in zip(centres, Rs[:, 2]):
            axes.quiver(c[0], c[2], -c[1], axis[0], axis[2], -axis[1], color=color)
    axes.legend()
    pyplot.savefig(path, metadata={"Date": None})
