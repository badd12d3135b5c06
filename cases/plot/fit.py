#!/usr/bin/env python3
"""Test data and the laws fitted to them, from the fit.csv and curves.csv that velum fit writes. A
band is the 95 % interval of a law; a curve is dotted where the law is unstable by Drucker."""
import argparse
import csv
from pathlib import Path

from style import plt, save

COLOURS = {"neo_hookean": "#1b6ca8", "mooney_rivlin_2": "#c8553d", "mooney_rivlin_5": "#5a8f3c"}
NAMES = {"neo_hookean": "neo-Hookean", "mooney_rivlin_2": "Mooney-Rivlin 2",
         "mooney_rivlin_5": "Mooney-Rivlin 5"}
TESTS = ["uniaxial", "planar", "equibiaxial"]
MEGA = 1e-6


def rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def draw_curve(axes, part: list[dict[str, str]], model: str) -> None:
    stretch = [float(r["stretch [1]"]) for r in part]
    stress = [MEGA * float(r["engineering_stress [Pa]"]) for r in part]
    half = [MEGA * float(r["half_interval [Pa]"]) for r in part]
    colour = COLOURS[model]
    axes.fill_between(stretch, [s - h for s, h in zip(stress, half)],
                      [s + h for s, h in zip(stress, half)], color=colour, alpha=0.2, linewidth=0)
    held = [r["stable [1]"] == "1" for r in part]
    axes.plot(stretch, [s if ok else float("nan") for s, ok in zip(stress, held)], color=colour,
              label=NAMES[model])
    if not all(held):
        axes.plot(stretch, [float("nan") if ok else s for s, ok in zip(stress, held)],
                  color=colour, linestyle=":", label="unstable")


def draw_test(axes, test: str, points: list[dict[str, str]], curves: list[dict[str, str]]) -> None:
    for model in dict.fromkeys(r["model"] for r in curves):
        draw_curve(axes, [r for r in curves if r["model"] == model], model)
    stresses = [MEGA * float(r["engineering_stress [Pa]"]) for r in points]
    axes.plot([float(r["stretch [1]"]) for r in points], stresses, "o", color="black",
              markersize=3.5, markerfacecolor="none", label="measured" if points else None, zorder=3)
    if stresses:  # a wide band must not hide the data
        low, high = min(stresses + [0]), max(stresses + [0])
        axes.set_ylim(low - 0.08 * (high - low), high + 0.35 * (high - low))
    axes.set_title(test if points else f"{test}, not tested", fontsize=9)
    axes.set_xlabel("stretch")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where fit.csv and curves.csv lie")
    folder = parser.parse_args().folder
    points, curves = rows(folder / "fit.csv"), rows(folder / "curves.csv")
    figure, panels = plt.subplots(1, 3, figsize=(9.6, 3.6))
    for axes, test in zip(panels, TESTS):
        draw_test(axes, test, [r for r in points if r["test"] == test],
                  [r for r in curves if r["test"] == test])
    panels[0].set_ylabel("engineering stress (MPa)")
    labels = {}
    for axes in panels:
        labels.update(dict(zip(*reversed(axes.get_legend_handles_labels()))))
    figure.legend(labels.values(), labels.keys(), loc="lower center", ncol=5, fontsize=8)
    figure.tight_layout(rect=(0, 0.08, 1, 1))
    save(figure, folder / "fit.png")


if __name__ == "__main__":
    main()
