#!/usr/bin/env python3
"""Penetration, errors and linear solves of a contact over its stiffness, by penalty and by augmented
Lagrangian, from the penalty.csv that velum limits contact_penalty writes."""
import argparse
import csv
from pathlib import Path

from style import DIFFUSE, SHARP, plt, save

METHODS = {"penalty": ("penalty", DIFFUSE, "o"),
           "augmented_lagrangian": ("augmented Lagrangian", SHARP, "s")}
LEAST = 1e-12  # of an error: below it is round-off, and none at all has no place on the axis


def draw(axes, rows: list[dict[str, str]], column: str, scale: float = 1, least: float = 0,
         filled: bool = True) -> None:
    for method, (name, colour, marker) in METHODS.items():
        part = [r for r in rows if r["method"] == method]
        axes.loglog([float(r["stiffness [Pa/m]"]) for r in part],
                    [max(scale * float(r[column]), least) for r in part], color=colour,
                    marker=marker, markersize=4, markerfacecolor=colour if filled else "white",
                    linestyle="-" if filled else "--", label=name)
    axes.set_xlabel("stiffness k (Pa/m)")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where penalty.csv lies")
    folder = parser.parse_args().folder
    with open(folder / "penalty.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    figure, (depth, error, work) = plt.subplots(1, 3, figsize=(9.6, 3.6))
    draw(depth, rows, "penetration [m]", scale=1e6)
    depth.set_ylabel("penetration (um)")
    draw(error, rows, "largest_pressure_error", least=LEAST)
    draw(error, rows, "seat_force_error", least=LEAST, filled=False)
    error.set_ylabel("error of the contact")
    error.set_title("full: largest pressure, dashed: force", fontsize=9)
    draw(work, rows, "linear_solves")
    work.set_ylabel("linear solves")
    work.set_ylim(bottom=1)
    figure.legend(*depth.get_legend_handles_labels(), loc="lower center", ncol=2, fontsize=8)
    figure.tight_layout(rect=(0, 0.08, 1, 1))
    save(figure, folder / "penalty.png")


if __name__ == "__main__":
    main()
