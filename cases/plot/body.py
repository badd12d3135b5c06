#!/usr/bin/env python3
"""Load and deflection of a body alone, and its section in every state, from the series.csv and
profile.csv of velum run."""
import argparse
import csv
from pathlib import Path

from style import plt, save

KILO, MILLI = 1e-3, 1e3


def columns(path: Path) -> dict[str, list[float]]:
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def draw_path(axes, series: dict[str, list[float]]) -> None:
    pressures = [KILO * p for p in series["pressure [Pa]"]]
    axes.plot([abs(MILLI * d) for d in series["deflection [m]"]], pressures, "o-",
              color="#1b6ca8", markersize=3.5, label="velum")
    wanted = [abs(MILLI * d) for d in series["deflection_reference [m]"]]
    if any(d == d for d in wanted):
        axes.plot(wanted, pressures, "x", color="black", markersize=7, label="reference")
    axes.set_xlabel("deflection (mm)")
    axes.set_ylabel("pressure (kPa)")
    axes.legend()


def draw_sections(axes, profile: dict[str, list[float]]) -> None:
    states = sorted(set(profile["state [1]"]))
    for n, state in enumerate(states):
        here = [k for k, s in enumerate(profile["state [1]"]) if s == state]
        axes.plot([MILLI * profile["radius [m]"][k] for k in here],
                  [MILLI * profile["axial [m]"][k] for k in here],
                  color=plt.cm.viridis(0.9 * n / max(1, len(states) - 1)))
    axes.set_aspect("equal")
    axes.set_xlabel("radius (mm)")
    axes.set_ylabel("axial (mm)")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="results of the run")
    parser.add_argument("picture", type=Path, help="file to write")
    arguments = parser.parse_args()
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.8))
    draw_path(left, columns(arguments.folder / "series.csv"))
    draw_sections(right, columns(arguments.folder / "profile.csv"))
    save(figure, arguments.picture)


if __name__ == "__main__":
    main()
