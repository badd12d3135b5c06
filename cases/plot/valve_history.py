"""Everything in series.csv over time, a panel for each kind of quantity."""
from pathlib import Path

import numpy as np

from paper import values as paper_values
from results import UNITS, series, units
from rim import at_the_rim
from style import plt, save

COLOURS = ["#1b6ca8", "#c8553d", "#5a8f3c", "#8a5a9e", "#c99a2e", "#4d4d4d"]
VALVE = [  # title, columns and what they are called; a name that ends in _ stands for all such
    ("pressure", {"pressure_above": "above the membrane", "pressure_outside": "around the seat",
                  "pressure_inside": "within the seat",
                  "pressure_least": "least of any cell", "pressure_": "{}"}),
    ("flow", {"flow": "out of the valve", "flow_": "{}"}),
    ("gap of the seat", {"gap": "gap"}),
    ("lift of the pilot", {"lift_": "{}"}),
]


def columns_of(wanted: dict[str, str], data: dict[str, np.ndarray]) -> dict[str, str]:
    """Columns of a panel, with their labels; a chamber that is another column is left out."""
    chosen: dict[str, str] = {}
    for pattern, label in wanted.items():
        for name in data:
            hit = name.startswith(pattern) if pattern.endswith("_") else name == pattern
            if not hit or name in chosen:
                continue
            if pattern.endswith("_") and any(np.array_equal(data[name], data[c]) for c in chosen):
                continue
            chosen[name] = label.format(name.removeprefix(pattern))
    return chosen


def panels_of(data: dict[str, np.ndarray],
              unit: dict[str, str]) -> list[tuple[str, dict[str, str]]]:
    """Title and columns of each panel: a valve's own, or one for each unit, without what is always
    zero."""
    if "gap" in data:
        panels = [(title, columns_of(wanted, data)) for title, wanted in VALVE]
        return [panel for panel in panels if panel[1]]
    others = [name for name in list(data)[1:] if np.any(np.nan_to_num(data[name]))]
    panels = []
    for kind in dict.fromkeys(unit[name] for name in others):
        columns = {n: n.replace("_", " ") for n in others if unit[n] == kind}
        panels.append((*columns.values(), columns) if len(columns) == 1 else ("", columns))
    return panels


def mark_paper(axes, rows: list[dict[str, str]], factor: float) -> None:
    """Points of the paper, each label once in the legend."""
    seen: set[str] = set()
    for row in rows:
        label = row["label"]
        axes.plot(1e3 * float(row["time [s]"]), factor * float(row["value"]) * UNITS[row["unit"]],
                  "D", color="black", markerfacecolor="white", markersize=5, zorder=5,
                  label=label if label not in seen else None)
        seen.add(label)


def draw_histories(run: Path, picture: Path) -> None:
    """Pressures, flows, gap and lift below each other; the paper's values are marked."""
    data, unit, paper = series(run), units(run), paper_values(run)
    first = next(iter(data))
    shown, scale = at_the_rim(unit[first])
    panels = panels_of(data, unit)
    heights = [1 if "lift" in title else 1.5 for title, _ in panels]
    figure, all_axes = plt.subplots(len(panels), 1, figsize=(7.6, 1.25 * sum(heights) + 0.6),
                                    sharex=True, squeeze=False, height_ratios=heights,
                                    layout="constrained")
    for axes, (title, columns) in zip(all_axes[:, 0], panels):
        largest = max(np.nanmax(np.abs(data[name])) for name in columns)
        kind, factor = at_the_rim(unit[next(iter(columns))], largest)
        for colour, (name, label) in zip(COLOURS * len(columns), columns.items()):
            axes.plot(scale * data[first], factor * data[name], color=colour, linewidth=1.3,
                      label=label)
        mark_paper(axes, [row for row in paper if row["quantity"] in columns], factor)
        if title == "gap of the seat":
            axes.axhline(0, color="#8a8a8a", linewidth=0.8)
        axes.set_ylabel(f"{title} ({kind})" if title and kind else title or kind)
        axes.margins(y=0.08)
        if len(axes.get_legend_handles_labels()[1]) > 1:
            axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=8)
    axes.set_xlabel(f"{first} ({shown})" if shown else first)
    axes.set_xlim(scale * data[first][0], scale * data[first][-1])
    figure.align_ylabels()
    save(figure, picture)
