#!/usr/bin/env python3
"""Error against wall time, from the chart.csv that velum chart writes: a panel for each scene, the
Pareto front of all its runs and the scene's default marked; of several scenes also one by one."""
import argparse
import csv
from collections import defaultdict
from pathlib import Path

from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from style import plt, save

COLOURS = ["#1b6ca8", "#c8553d", "#5a8f3c", "#8a5a9e", "#c99a2e", "#4d4d4d"]
MARKERS = {"double": "o", "single": "s"}


def pareto(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The points that no other one beats in both time and error, by time."""
    front, least = [], float("inf")
    for time, error in sorted(points):
        if error < least:
            front.append((time, error))
            least = error
    return front


def draw_panel(axes, scene: str, rows: list[dict[str, str]], colours: dict[str, str]) -> None:
    done = [row for row in rows if row["outcome"] == "ok"]
    lines = defaultdict(list)  # from the coarsest cells to the finest, as the rows come
    for row in done:
        lines[row["collision"], row["wall_rule"], row["precision"]].append(
            (float(row["wall_time [s]"]), float(row["error"])))
    for (collision, wall_rule, precision), points in lines.items():
        single = precision != "double"
        marker = {"half_way": "x", "linear": "+"}.get(wall_rule, MARKERS.get(precision, "^"))
        axes.loglog(*zip(*points), color=colours[collision], linewidth=1,
                    marker=marker, markersize=5 if marker in "x+" else 4,
                    markerfacecolor="white" if single else colours[collision],
                    linestyle=":" if wall_rule == "half_way" else "--" if single else "-",
                    label=f"{collision}, {wall_rule.replace('_', '-')} walls, {precision}")
    front = pareto([point for points in lines.values() for point in points])
    if front:
        axes.step(*zip(*front), where="post", color="#bbbbbb", linewidth=4, zorder=0,
                  label="Pareto front")
    default = [row for row in done if row["default"] == "1"]
    if default:
        axes.plot([float(row["wall_time [s]"]) for row in default],
                  [float(row["error"]) for row in default], marker="*", markersize=14, zorder=5,
                  color="#222222", markerfacecolor="none", linestyle="none", label="default")
    lost = len(rows) - len(done)
    axes.set_title(scene + (f" ({lost} of {len(rows)} diverged)" if lost else ""), fontsize=9)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("wall time (s)")
    axes.set_ylabel(rows[0]["error_key"])


def draw_chart(rows: list[dict[str, str]], picture: Path) -> None:
    collisions = list(dict.fromkeys(row["collision"] for row in rows))
    colours = {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(collisions)}
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    columns = min(3, len(scenes))
    lines = -(-len(scenes) // columns)
    entries = len({(row["collision"], row["wall_rule"], row["precision"]) for row in rows}) + 2  # front, default
    abreast = 4 if columns > 1 else 2
    legend = 0.17 * -(-entries // abreast) + 0.1
    height = 3.2 * lines + legend
    figure, panels = plt.subplots(lines, columns, figsize=(3.6 * columns + 0.6, height),
                                  squeeze=False)
    for axes in panels.flat[len(scenes):]:
        axes.axis("off")
    labels = {}
    for axes, scene in zip(panels.flat, scenes):
        draw_panel(axes, scene, [row for row in rows if row["scene"] == scene], colours)
        labels |= {label: handle for handle, label in zip(*axes.get_legend_handles_labels())}
    figure.legend(labels.values(), labels.keys(), loc="lower center", ncol=abreast, fontsize=8)
    figure.tight_layout(rect=(0, legend / height, 1, 1))
    save(figure, picture)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where chart.csv lies")
    folder = parser.parse_args().folder
    with open(folder / "chart.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    draw_chart(rows, folder / "chart.png")
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    for scene in scenes if len(scenes) > 1 else []:
        draw_chart([row for row in rows if row["scene"] == scene], folder / f"chart_{scene}.png")


if __name__ == "__main__":
    main()
