#!/usr/bin/env python3
"""A membrane that is moved in its middle and the speed of the water that it drives, at four
instants, and its lift and the volumes over time, from the run.h5 and series.csv of velum run."""
import argparse
from pathlib import Path

import numpy as np
from matplotlib.colors import PowerNorm

from results import Dump, dumps, series
from style import DIFFUSE, RUBBER, SHARP, SOLID, plt, save

MILLI = 1e3
BELOW = 2  # side of the water that is looked at
OTHER = "#eef2f4"


def chosen(states: list[Dump], number: int) -> list[Dump]:
    """States at equal distances in time, neither the first, which is at rest, nor the last."""
    wanted = np.linspace(states[0].time, states[-1].time, 2 * number + 1)[1::2]
    return [min(states, key=lambda s: abs(s.time - t)) for t in wanted]


def speed(state: Dump) -> np.ndarray:
    return np.ma.masked_where(state.side != BELOW, np.hypot(*np.moveaxis(state.velocity, 2, 0)))


def lift(state: Dump) -> float:
    return MILLI * (state.membrane[0, 0] - state.membrane[-1, 0])


def draw_state(axes, state: Dump, norm, upper: float):
    """The right half is computed, the left half its mirror image."""
    axes.set_facecolor(SOLID)
    axes.grid(False)
    other = np.ma.masked_where((state.side == 0) | (state.side == BELOW), np.ones_like(state.side))
    radial, axial = MILLI * state.radial, MILLI * state.axial
    for mirror in (1, -1):
        axes.pcolormesh(mirror * radial, axial, other.T, cmap="gray", vmin=0, vmax=1.06,
                        rasterized=True)
        image = axes.pcolormesh(mirror * radial, axial, speed(state).T, cmap="viridis", norm=norm,
                                rasterized=True)
    draw_ways(axes, state)
    half = np.concatenate([state.plus_face, state.minus_face[::-1]])
    outline = MILLI * np.concatenate([half, half[::-1] * (1, -1)])
    axes.fill(outline[:, 1], outline[:, 0], color=RUBBER, linewidth=0)
    axes.set_aspect("equal")
    axes.set_xlim(-radial[-1], radial[-1])
    axes.set_ylim(axial[0], upper)
    axes.set_title(f"{MILLI * state.time:.3g} ms: lift {lift(state):.2f} mm, water up to "
                   f"{speed(state).max():.2g} m/s", fontsize=9)
    return image


def draw_ways(axes, state: Dump) -> None:
    """Where the water goes: lines of the flow on both halves."""
    middle = [0.5 * MILLI * (edge[1:] + edge[:-1]) for edge in (state.radial, state.axial)]
    across = np.where(state.side == BELOW, state.velocity[:, :, 1], np.nan).T
    along = np.where(state.side == BELOW, state.velocity[:, :, 0], np.nan).T
    radius = np.concatenate([-middle[0][::-1], middle[0]])
    axes.streamplot(radius, middle[1], np.hstack([-across[:, ::-1], across]),
                    np.hstack([along[:, ::-1], along]), color="white", linewidth=0.5,
                    density=(0.9, 0.7), arrowsize=0.6)


def draw_time(axes, run: Path, states: list[Dump]) -> None:
    columns = series(run)
    time = MILLI * columns["time"]
    swept = MILLI**3 * (columns["volume_inside"] - columns["volume_inside"][0])
    came = MILLI**3 * (columns["inflow"] - columns["outflow"])
    middle, = axes.plot(time, MILLI * (columns["centre"] - columns["centre"][0]), color=RUBBER,
                      label="lift of the middle")
    axes.set_xlabel("time (ms)")
    axes.set_ylabel("lift (mm)")
    axes.set_xlim(time[0], time[-1])
    axes.set_ylim(bottom=0)
    axes.set_title("dotted: the instants above", fontsize=9)
    volumes = axes.twinx()
    volumes.spines["right"].set_visible(True)
    volumes.grid(False)
    lines = [middle, *volumes.plot(time, swept, color=SHARP, label="volume swept by the membrane"),
             *volumes.plot(time, came, color=DIFFUSE, linestyle="--",
                           label="water that came in by the passage")]
    volumes.set_ylabel("volume (mm³)")
    volumes.set_ylim(0, 1.25 * swept.max())  # beside the lift, not upon it
    for state in states:
        axes.axvline(MILLI * state.time, color="#9a9a9a", linewidth=0.7, linestyle=":")
    axes.legend(lines, [line.get_label() for line in lines], loc="lower center", fontsize=8)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="results of the run")
    parser.add_argument("picture", type=Path, help="file to write")
    arguments = parser.parse_args()
    every = [Dump(arguments.folder, n) for n in range(dumps(arguments.folder))]
    states = chosen(every, 4)
    norm = PowerNorm(0.5, vmin=0, vmax=max(speed(s).max() for s in states))
    highest = MILLI * max(s.plus_face[:, 0].max() for s in every)
    figure = plt.figure(figsize=(9.6, 7.4), dpi=105, layout="constrained")
    grid = figure.add_gridspec(3, 2, height_ratios=(1, 1, 0.85))
    panels = [figure.add_subplot(grid[n // 2, n % 2]) for n in range(4)]
    for axes, state in zip(panels, states):
        image = draw_state(axes, state, norm, highest + 0.1)
    for axes in panels[2:]:
        axes.set_xlabel("radius (mm)")
    for axes in panels[::2]:
        axes.set_ylabel("axial (mm)")
    figure.colorbar(image, ax=panels, label="speed of the water below the membrane (m/s)",
                    shrink=0.8)
    draw_time(figure.add_subplot(grid[2, :]), arguments.folder, states)
    save(figure, arguments.picture)


if __name__ == "__main__":
    main()
