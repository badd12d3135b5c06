"""Shape of a membrane over the radius at instants of a run."""
import csv
from pathlib import Path

import numpy as np

from results import Dump, dumps
from style import plt, save

LINES = 6  # at most


def shapes(run: Path) -> list[tuple[float, np.ndarray]]:
    """Time and mid-surface, points (axial, radial), of every state that was written."""
    if (run / "run.h5").exists():
        states = [Dump(run, n) for n in range(dumps(run))]
        return [(state.time, state.membrane) for state in states]
    with open(run / "profile.csv", newline="") as file:
        header, *rows = csv.reader(file)
    names = [cell.split(" [")[0] for cell in header]
    table = np.array(rows, dtype=float)
    places = [names.index("axial"), names.index("radius")]
    return [(time, table[table[:, 0] == time][:, places]) for time in np.unique(table[:, 0])]


def spread(items: list, number: int) -> list:
    """At most so many of them, the first and the last among them."""
    if len(items) <= number:
        return items
    return [items[k] for k in np.linspace(0, len(items) - 1, number).round().astype(int)]


def draw_profiles(run: Path, picture: Path) -> None:
    """Left the mid-surface as it lies, right how far it has risen since the start."""
    states = spread(shapes(run), LINES)
    start = states[0][1]
    figure, panels = plt.subplots(1, 2 if len(states) > 1 else 1, squeeze=False,
                                  figsize=(8.6 if len(states) > 1 else 5, 3.2),
                                  layout="constrained")
    panels = panels[0]
    colours = plt.get_cmap("viridis_r")(np.linspace(0.1, 1, len(states)))
    for colour, (time, middle) in zip(colours, states):
        panels[0].plot(1e3 * middle[:, 1], 1e3 * middle[:, 0], color=colour,
                       label=f"{1e3 * time:.3g} ms")
        if len(states) > 1:
            panels[1].plot(1e3 * start[:, 1], 1e6 * (middle[:, 0] - start[:, 0]), color=colour)
            panels[1].set_ylabel("rise (µm)")
            panels[1].set_title("rise since the start", fontsize=9)
    panels[0].set_ylabel("axial (mm)")
    panels[0].set_title("mid-surface", fontsize=9)
    for axes in panels:
        axes.set_xlabel("radius (mm)")
        axes.set_xlim(0, 1.02e3 * start[:, 1].max())
    if len(states) > 1:
        panels[-1].legend(*panels[0].get_legend_handles_labels(), loc="center left",
                          bbox_to_anchor=(1.01, 0.5), fontsize=8)
    save(figure, picture)
