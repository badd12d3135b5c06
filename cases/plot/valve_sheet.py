"""What stands on a valve's data sheet: Kv over lift, flow over pressure up and down."""
import csv
from pathlib import Path

import numpy as np

from results import series, summary
from style import plt, save

UP, DOWN = "#c8553d", "#1b6ca8"
LITRES_PER_HOUR = 3.6e6


def kv_table(run: Path) -> dict[str, np.ndarray]:
    """Columns of kv.csv by name, without the unit; not a number where a class is empty."""
    with open(run / "kv.csv", newline="") as file:
        header, *rows = csv.reader(file)
    columns = np.array([[float(cell or "nan") for cell in row] for row in rows]).T
    return {name.split(" [")[0]: column for name, column in zip(header, columns)}


def pilot_opens(run: Path) -> float:
    """When the pilot opens, s; the beginning where it does not move."""
    opens = summary(run).get("valve_pilot_opens")
    return series(run)["time"][0] if opens is None else opens


def draw_kv(axes, run: Path) -> None:
    kv = kv_table(run)
    for name, colour in (("opening", UP), ("closing", DOWN)):
        axes.plot(1e6 * kv["gap"], kv[f"kv_{name}"], "o-", color=colour, markersize=3.5,
                  linewidth=1.2, label=name)
    axes.set_xlabel("gap of the seat (um)")
    axes.set_ylabel("Kv, the pilot's share in it (m3/h)")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.legend()


def draw_loop(axes, run: Path) -> None:
    """Flow over the pressure around the seat, once the pilot is open; where it cracks, reseats."""
    data, figures = series(run), summary(run)
    time, pressure = data["time"], 1e-3 * data["pressure_outside"]
    flow = LITRES_PER_HOUR * data["flow"]
    around = 0.005 * (time[-1] - time[0])
    change = np.interp(time + around, time, pressure) - np.interp(time - around, time, pressure)
    opened = time > pilot_opens(run)
    least = 1e-3 * np.ptp(pressure)
    for name, colour, way in (("rising", UP, change), ("falling", DOWN, -change)):
        there = opened & (way > least)
        axes.plot(np.where(there, pressure, np.nan), flow, color=colour, linewidth=1.4, label=name)
    for name, colour in (("cracking", UP), ("reseating", DOWN)):
        if (value := figures.get(f"valve_{name}_pressure")) is not None:
            axes.axvline(1e-3 * value, color=colour, linestyle=":", linewidth=1)
            axes.annotate(f"{name} {1e-3 * value:.3g} kPa", (1e-3 * value, 0.98),
                          xycoords=("data", "axes fraction"), rotation=90, va="top",
                          ha="left" if name == "cracking" else "right", fontsize=7.5,
                          color=colour)
    axes.set_xlabel("pressure around the seat (kPa)")
    axes.set_ylabel("flow out of the valve (l/h)")
    axes.set_ylim(bottom=0)
    axes.legend(loc="lower right")


def draw_sheet(run: Path, picture: Path) -> None:
    """Left Kv over lift; right the way up and down of the pressure, and its low end from near."""
    figures = summary(run)
    ramp = "valve_cracking_pressure" in figures or "valve_reseating_pressure" in figures
    figure, panels = plt.subplots(1, 3 if ramp else 1, figsize=(10.5 if ramp else 4.2, 3.3),
                                  layout="constrained", squeeze=False)
    draw_kv(panels[0, 0], run)
    if ramp:
        near = 2 * max(figures.get(f"valve_{n}_pressure", 0) for n in ("cracking", "reseating"))
        for axes in panels[0, 1:]:
            draw_loop(axes, run)
        panels[0, 1].set_xlim(left=0)
        axes.set_xlim(0, 1e-3 * near)
        data = series(run)
        there = (data["pressure_outside"] < near) & (data["time"] > pilot_opens(run))
        if there.any():
            axes.set_ylim(0, 1.1 * LITRES_PER_HOUR * data["flow"][there].max())
    save(figure, picture)
