#!/usr/bin/env python3
"""Section of an STL solid and the lattice's solid cells in it, from the tables of `velum stl`."""
import argparse
import csv
from pathlib import Path

import numpy as np
from matplotlib.collections import PolyCollection

from style import SHARP, SOLID, plt, save

UNITS = ((1.0, "m"), (1e-3, "mm"), (1e-6, "um"), (1e-9, "nm"))


def table(path: Path) -> tuple[list[str], np.ndarray]:
    """Header and rows of a CSV file."""
    with path.open(newline="") as file:
        header, *rows = csv.reader(file)
    return header, np.array(rows, dtype=float).reshape(-1, len(header))


def draw_stl_section(lines: Path, cells: Path, picture: Path) -> None:
    """Outline as it is in the file over the cells whose centres are solid."""
    header, points = table(lines)
    runs = table(cells)[1]
    size = max(np.ptp(points[:, 1]), np.ptp(points[:, 2]))
    metres, unit = next((u for u in UNITS if size >= u[0]), UNITS[-1])
    figure, axes = plt.subplots(figsize=(6.4, 4.8))
    axes.grid(False)
    if len(runs):
        x0, x1, y0, y1 = runs.T / metres
        dx = y1[0] - y0[0]
        axes.add_collection(PolyCollection(
            np.stack([np.column_stack(c) for c in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))], axis=1),
            facecolor=SOLID, edgecolor="none", antialiased=False,
        ))
        draw_grid(axes, runs / metres, dx)
        cells_in_words = f"solid cells, dx = {dx:.4g} {unit}"
    else:
        cells_in_words = "no solid cell"
    for number in np.unique(points[:, 0]):
        line = points[points[:, 0] == number, 1:] / metres
        axes.plot(*line.T, color=SHARP, linewidth=1.0)
    axes.set_aspect("equal")
    axes.margins(0.05)
    axes.autoscale_view()
    for name, label in ((header[1], axes.set_xlabel), (header[2], axes.set_ylabel)):
        label(f"{name.split()[0]} ({unit})")
    axes.set_title(f"blue: the solid's outline, grey: {cells_in_words}", fontsize=9)
    save(figure, picture)


def draw_grid(axes: plt.Axes, runs: np.ndarray, dx: float, most: int = 150) -> None:
    """Lines between the solid cells, where they are few enough to be told apart."""
    if max(np.ptp(runs[:, :2]), np.ptp(runs[:, 2:])) > most * dx:
        return
    for x0, x1, y0, y1 in runs:
        columns = np.linspace(x0, x1, round((x1 - x0) / dx) + 1)
        axes.vlines(columns, y0, y1, color="white", linewidth=0.4)
        axes.hlines((y0, y1), x0, x1, color="white", linewidth=0.4)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lines", type=Path, help="section_x.csv")
    parser.add_argument("cells", type=Path, help="cells_x.csv")
    parser.add_argument("picture", type=Path, help="file to write")
    options = parser.parse_args()
    draw_stl_section(options.lines, options.cells, options.picture)


if __name__ == "__main__":
    main()
