#!/usr/bin/env python3
"""Largest stable Reynolds and Mach numbers of each collision, from the limits.csv that velum limits
writes. Arrows mean: stable up to the largest number that was tried."""
import argparse
import csv
from pathlib import Path

from style import plt, save

COLOURS = ["#1b6ca8", "#c8553d", "#5a8f3c", "#8a5a9e", "#c99a2e", "#4d4d4d"]


def draw_reynolds(axes, rows: list[dict[str, str]], colours: dict[str, str]) -> None:
    """Over the Mach number; with LES hollow and dashed. Series stand a little beside each other, or
    those that have no limit would hide one another."""
    series = list(dict.fromkeys((r["collision"], r["les"]) for r in rows))
    for place, (collision, les) in enumerate(series):
        part = [r for r in rows if (r["collision"], r["les"]) == (collision, les)]
        mach = [float(r["mach"]) * 1.025 ** (place - len(series) / 2) for r in part]
        reynolds = [float(r["reynolds"]) for r in part]
        off, colour = les == "off", colours[collision]
        axes.loglog(mach, reynolds, color=colour, linestyle="-" if off else "--", marker="o",
                    markersize=5, markerfacecolor=colour if off else "white",
                    label=collision + ("" if off else ", LES"))
        for row, x, y in zip(part, mach, reynolds):
            if row["bound"] != "found":
                end = 2.5 * y if row["bound"] == "none" else y / 2.5
                axes.annotate("", (x, end), (x, y), arrowprops={"arrowstyle": "->", "color": colour})
    ticks = sorted({float(r["mach"]) for r in rows})
    axes.set_xticks(ticks, [f"{t:g}" for t in ticks])
    axes.set_xticks([], minor=True)
    axes.margins(x=0.1, y=0.15)
    axes.set_xlabel("Mach number")
    axes.set_ylabel("largest stable Reynolds number")


def draw_mach(axes, rows: list[dict[str, str]], colours: dict[str, str]) -> None:
    for place, row in enumerate(rows):
        off, mach = row["les"] == "off", float(row["mach"])
        if row["bound"] == "all":
            axes.annotate(f"< {mach:g}", (place, 0), xytext=(0, 3), textcoords="offset points",
                          ha="center", va="bottom", fontsize=8)
            continue
        axes.bar(place, mach, color=colours[row["collision"]] if off else "white",
                 edgecolor=colours[row["collision"]], hatch="" if off else "///")
    axes.set_xlim(-0.7, len(rows) - 0.3)
    axes.set_xticks([])
    axes.grid(axis="x", visible=False)
    axes.set_ylabel("largest stable Mach number")
    axes.set_title(f"at Re = {float(rows[0]['reynolds']):g}", fontsize=9)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where limits.csv lies")
    folder = parser.parse_args().folder
    with open(folder / "limits.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    collisions = list(dict.fromkeys(row["collision"] for row in rows))
    colours = {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(collisions)}
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 4.2))
    draw_reynolds(left, [r for r in rows if r["quantity"] == "reynolds"], colours)
    draw_mach(right, [r for r in rows if r["quantity"] == "mach"], colours)
    figure.legend(*left.get_legend_handles_labels(), loc="lower center", ncol=3, fontsize=8)
    left.set_title(f"{rows[0]['map']}, {rows[0]['cells']} cells across", fontsize=9)
    figure.tight_layout(rect=(0, 0.13, 1, 1))
    save(figure, folder / "limits.png")


if __name__ == "__main__":
    main()
