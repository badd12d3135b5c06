#!/usr/bin/env python3
"""Tables (Markdown) and the fidelity chart of cases/valve_on_off/study, from the runs in its folder.

A flow is in l/h, a pressure in kPa, a gap in um. "At t" is the row nearest to t."""
import argparse
import json
from pathlib import Path

import numpy as np

from results import done, quantity, series, summary
from style import plt, save
from tables import LITRES_PER_HOUR as L_PER_H
from tables import table


def at(run: Path, name: str, time: float) -> float:
    s = series(run)
    return s[name][np.argmin(np.abs(s["time"] - time))]


def last(run: Path, name: str) -> float:
    """Mean of the last tenth of the run."""
    column = series(run)[name]
    return column[-max(1, len(column) // 10):].mean()


def on_off(run: Path) -> list[str]:
    s = summary(run)
    pressure = [f"{1e-3 * at(run, 'pressure_pilot', t):.0f}" for t in (0, 0.021, 0.1)]
    flow = [f"{L_PER_H * at(run, 'flow', t):.0f}" for t in (0.031, 0.1)]
    return [run.name, *pressure, *flow, f"{1e6 * last(run, 'gap'):.0f}",
            f"{s.get('wall_time', float('nan')):.0f}"]


def plateau(run: Path) -> list[list[str]]:
    rows = []
    for opening, time in (("closed", 0.079), ("5 %", 0.119), ("25 %", 0.139), ("38 %", 0.199),
                          ("100 %", 0.25)):
        rows.append([run.name, opening, f"{1e-3 * at(run, 'pressure_pilot', time):.1f}",
                     f"{L_PER_H * at(run, 'flow', time):.2f}",
                     f"{1e6 * at(run, 'gap', time):.2f}",
                     f"{at(run, 'seat_force', time):.2f}"])
    return rows


def figures(run: Path, *names: str) -> list[str]:
    """A row: the run, and figures of its summary as far as it has them."""
    s = summary(run)
    return [run.name, *(f"{s[k]:.4g}" if s.get(k) is not None else "-" for k in names)]


def label(run: Path) -> str:
    """fid_100um_0.2 -> 100 um, Mach 0.2"""
    parts = run.name.removeprefix("fid_").split("_")
    return f"{parts[0].removesuffix('um')} um, Mach {parts[1]}" if len(parts) == 2 else parts[0]


def is_hydrostatic(run: Path) -> bool:
    return not (run / "series.csv").exists()


def seat_force(run: Path) -> float:
    """Of the closed valve, before its pilot opens."""
    return summary(run)["seat_force"] if is_hydrostatic(run) else at(run, "seat_force", 0.9e-3)


def flow_error(run: Path, fine: dict[str, np.ndarray]) -> float:
    """Mean distance of the flow's history from the finest run's, of its largest."""
    s = series(run)
    apart = np.abs(np.interp(fine["time"], s["time"], s["flow"]) - fine["flow"])
    return apart.mean() / fine["flow"].max()


def chart(folder: Path, runs: list[Path], finest: Path) -> None:
    """Errors over wall time: of the closed valve's seat force, of the opened one's flow."""
    fine, force = series(finest), seat_force(finest)
    figure, panels = plt.subplots(1, 2, figsize=(8.6, 3.6), layout="constrained")
    marched = [run for run in runs if not is_hydrostatic(run)]
    for axes, title, those, error in (
            (panels[0], "closed: force on the seat", runs,
             lambda run: abs(seat_force(run) / force - 1)),
            (panels[1], "switched on: flow over time", marched,
             lambda run: flow_error(run, fine))):
        for run in those:
            kind = json.loads((run / "summary.json").read_text())["assumptions"]["fidelity"]
            x, y = summary(run)["wall_time"], 100 * error(run)
            axes.plot(x, y, "o" if kind == "axisymmetric" else "s",
                      color="#1b6ca8" if kind == "axisymmetric" else "#c8553d")
            axes.annotate(label(run), (x, y), textcoords="offset points", xytext=(6, 5),
                          fontsize=7)
        axes.set_xscale("log")
        axes.margins(x=0.25)
        axes.set_ylim(0, 1.15 * axes.dataLim.y1)
        axes.set_title(title, fontsize=9)
        axes.set_xlabel(f"wall time (s); {label(finest)}: {summary(finest)['wall_time']:.0f} s")
        axes.grid(True, linewidth=0.3)
    panels[0].set_ylabel(f"distance from {label(finest)} (%)")
    save(figure, folder / "fidelity.png")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    runs = sorted(run for run in folder.iterdir() if run.is_dir() and done(run))
    of = lambda prefix: [run for run in runs if run.name.startswith(prefix)]
    head = ["run", "pilot chamber at 0", "20 ms after", "at the end", "flow 30 ms after", "at the end",
            "last gap", "wall time (s)"]
    if of("on_"):
        print(table([head] + [on_off(run) for run in of("on_")]))
    if of("prop_"):
        print(table([["run", "pilot", "pilot chamber", "flow", "gap", "seat force (N)"]] +
                    [row for run in of("prop_") for row in plateau(run)]))
    if of("fid_"):
        print(table([head] + [on_off(run) for run in of("fid_") if not is_hydrostatic(run)]))
        print(table([["closed", "force on the seat (N)", "wall time (s)"]] +
                    [[run.name, f"{seat_force(run):.2f}", f"{summary(run)['wall_time']:.2g}"]
                     for run in of("fid_")]))
        grids = [run for run in of("fid_") if "um" in run.name]
        if grids:
            finest = min(grids, key=lambda run: quantity(run, "lattice.dx"))
            chart(folder, [run for run in of("fid_") if run != finest], finest)
    if of("par_"):
        base = next((run for run in of("par_") if run.name == "par_none"), None)
        if base:
            rows = []
            for run in of("par_"):
                p, q = last(run, "pressure_pilot"), L_PER_H * last(run, "flow")
                p0, q0 = last(base, "pressure_pilot"), L_PER_H * last(base, "flow")
                rows.append([run.name.removeprefix("par_"), f"{1e-3 * p:.1f}",
                             f"{100 * (p / p0 - 1):+.1f} %", f"{q:.0f}", f"{100 * (q / q0 - 1):+.0f} %"])
            print(table([["changed", "pilot chamber", "by", "flow", "by"]] + rows))
    if of("beta_") + of("chatter_"):
        print(table([["run", "frequency (Hz)", "amplitude (m)", "rate (1/s)",
                      "contacts per cycle", "flow against gap (deg)",
                      "pressure against gap (deg)"]] +
                    [figures(run, "chatter_frequency", "chatter_amplitude", "chatter_rate",
                             "chatter_contacts_per_cycle", "chatter_phase_flow_gap",
                             "chatter_phase_pressure_gap")
                     for run in of("beta_") + of("chatter_")]))
    if of("sheet_"):
        print(table([["run", "cracks (Pa)", "reseats", "Kv at the end (m3/h)", "rise (s)",
                      "leak (m3/s)", "class", "stretch", "in a face",
                      "least pressure in a cell (Pa)", "cavitation number", "wall time (s)"]] +
                    [figures(run, "valve_cracking_pressure", "valve_reseating_pressure",
                             "valve_kv", "valve_flow_rise_time", "valve_leak_shut",
                             "valve_leak_class", "stretch_max", "stretch_max_face",
                             "valve_pressure_cell_min", "valve_cavitation_number", "wall_time")
                     for run in of("sheet_")]))


if __name__ == "__main__":
    main()
