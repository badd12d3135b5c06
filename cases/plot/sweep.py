#!/usr/bin/env python3
"""Figures of a sweep, from the sweep.csv that velum sweep writes: over one key a line for each
figure, over two a map, the first key along x. Values of the keys stand as they were typed."""
import argparse
import csv
import math
import re
from pathlib import Path

import numpy as np
from matplotlib.ticker import NullFormatter

from style import SHARP, plt, save

MISSING = "#dedede"
LONGEST_LABEL = 16
NUMBER = re.compile(r"^['\"]?([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^'\"]*)['\"]?$")
Cell = float | None  # None: the run failed; not a number: it has no such figure, or knows it not


def for_people(unit: str, largest: float) -> tuple[float, str]:
    """What one SI unit is, and the unit that a picture is read in."""
    small = largest < 1e-3
    return {"m3/s": (3.6e6, "l/h"), "Pa": (1e-3, "kPa"), "s": (1e3, "ms"), "1": (1, ""),
            "m": (1e6, "um") if small else (1e3, "mm")}.get(unit, (1, unit))


def three_digits(value: float) -> str:
    """A number of three digits, without a power of ten where it is read well without."""
    if value == 0 or not 1e-3 <= abs(value) < 1e6:
        return f"{value:.3g}"
    decimals = 2 - math.floor(math.log10(abs(value)))
    return f"{round(value, decimals):.{max(decimals, 0)}f}"


class Sweep:
    """keys; runs: their values as typed -> row of the table; values of each key in their order."""

    def __init__(self, file: Path):
        with open(file, newline="") as stream:
            head, *rows = csv.reader(stream)
        self.keys = head[:head.index("outcome")]
        self.columns = {cell.split(" [")[0]: cell for cell in reversed(head[len(self.keys) + 1:])}
        count = len(self.keys)
        self.runs = {tuple(row[:count]): dict(zip(head, row)) for row in rows}
        self.values = [list(dict.fromkeys(run[k] for run in self.runs)) for k in range(count)]

    def cell(self, run: tuple[str, ...], name: str) -> Cell:
        """A figure in SI units."""
        row = self.runs.get(run)
        if row is None:
            return math.nan
        if row["outcome"] != "ok":
            return None
        return float(row[self.columns[name]] or "nan")

    def panel(self, name: str) -> tuple[str, list[list[Cell]]]:
        """Title of a figure, and its cells [second key][first key] in the unit that it names."""
        seconds = self.values[1] if len(self.keys) > 1 else [None]
        cells = [[self.cell((x,) if y is None else (x, y), name) for x in self.values[0]]
                 for y in seconds]
        known = [abs(c) for row in cells for c in row if c is not None and math.isfinite(c)]
        unit = self.columns[name].removeprefix(name + " [").rstrip("]")
        scale, unit = for_people(unit, max(known, default=0))
        scaled = [[c if c is None else scale * c for c in row] for row in cells]
        return name + (f" ({unit})" if unit else ""), scaled


def labels(values: list[str]) -> list[str]:
    """Values as typed, those cut that are too long to stand at an axis."""
    return [v if len(v) <= LONGEST_LABEL else v[:LONGEST_LABEL - 3] + "..." for v in values]


def draw_map(axes, sweep: Sweep, title: str, cells: list[list[Cell]]) -> None:
    values = np.array([[math.nan if c is None else c for c in row] for row in cells])
    values[~np.isfinite(values)] = math.nan
    axes.set_facecolor(MISSING)
    colours = axes.imshow(np.ma.masked_invalid(values), origin="lower", aspect="auto",
                          cmap="viridis")
    for y, row in enumerate(cells):
        for x, cell in enumerate(row):
            if cell is None:
                axes.plot([x], [y], marker="x", markersize=16, color="#c8553d", markeredgewidth=2)
            elif not math.isfinite(cell):
                axes.text(x, y, "-", ha="center", va="center", color="#666666")
            else:
                red, green, blue, _ = colours.cmap(colours.norm(cell))
                bright = 0.3 * red + 0.6 * green + 0.1 * blue > 0.5
                axes.text(x, y, three_digits(cell), ha="center", va="center",
                          color="black" if bright else "white")
    for axis, key, typed in zip((axes.xaxis, axes.yaxis), sweep.keys, sweep.values):
        axis.set_ticks(range(len(typed)), labels(typed))
        axis.set_label_text(key)
    axes.grid(False)
    for between in np.arange(0.5, values.shape[1] - 1):
        axes.axvline(between, color="white", linewidth=1)
    for between in np.arange(0.5, values.shape[0] - 1):
        axes.axhline(between, color="white", linewidth=1)
    axes.set_title(title, fontsize=9)


def numbers(typed: list[str]) -> tuple[list[float], str] | None:
    """The values as numbers of their common unit; None where they are none or their units vary."""
    found = [NUMBER.match(value) for value in typed]
    if not all(found) or len({match[2] for match in found}) > 1:
        return None
    return [float(match[1]) for match in found], found[0][2].strip()


def draw_line(axes, sweep: Sweep, title: str, cells: list[Cell]) -> None:
    typed = sweep.values[0]
    parsed = numbers(typed)
    at, unit = parsed or (list(map(float, range(len(typed)))), "")
    points = sorted((x, y) for x, y in zip(at, cells) if y is not None and math.isfinite(y))
    if points:
        axes.plot(*zip(*points), color=SHARP, linewidth=1, marker="o", markersize=4)
    if parsed and min(at) > 0 and max(at) > 30 * min(at):
        axes.set_xscale("log")
        axes.xaxis.set_minor_formatter(NullFormatter())
    axes.update_datalim([(x, 0) for x in at], updatey=False)  # a run without a point has its place
    axes.autoscale_view()
    for x, cell in zip(at, cells):  # at the foot of the panel
        if cell is None or not math.isfinite(cell):
            axes.text(x, 0.02, "x" if cell is None else "-", ha="center", va="bottom",
                      color="#c8553d" if cell is None else "#666666",
                      transform=axes.get_xaxis_transform())
    axes.set_xticks(at, [f"{x:g}" for x in at] if parsed else labels(typed))
    axes.set_xlabel(sweep.keys[0] + (f" ({unit})" if unit else ""))
    axes.set_title(title, fontsize=9)


def draw(sweep: Sweep, names: list[str], picture: Path) -> None:
    columns = min(3, len(names))
    lines = -(-len(names) // columns)
    across, along = len(sweep.values[0]), len(sweep.values[-1])
    is_map = len(sweep.keys) > 1
    size = ((max(3.4, 0.75 * across + 1.3), max(2.6, 0.4 * along + 1.2)) if is_map else
            (max(3.4, 0.45 * across + 1), 2.6))
    figure, panels = plt.subplots(lines, columns, squeeze=False,
                                  figsize=(size[0] * columns, size[1] * lines))
    for axes in panels.flat[len(names):]:
        axes.axis("off")
    for axes, name in zip(panels.flat, names):
        title, cells = sweep.panel(name)
        if is_map:
            draw_map(axes, sweep, title, cells)
        else:
            draw_line(axes, sweep, title, cells[0])
    if any(run["outcome"] != "ok" for run in sweep.runs.values()):
        figure.text(0.995, 0.0, "x: the run failed; sweep.csv says why", ha="right", va="top",
                    fontsize=7, color="#666666")
    figure.tight_layout()
    save(figure, picture)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where sweep.csv lies")
    parser.add_argument("figure", nargs="+", help="a figure to draw, without its unit")
    arguments = parser.parse_args()
    sweep = Sweep(arguments.folder / "sweep.csv")
    if len(sweep.keys) > 2:
        parser.error("three keys and more have no picture")
    names = [name for name in dict.fromkeys(arguments.figure) if name in sweep.columns]
    if names:
        draw(sweep, names, arguments.folder / "sweep.png")


if __name__ == "__main__":
    main()
