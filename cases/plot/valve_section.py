"""Pressure and speed over sections through the axis, with the deformed membrane, at instants."""
from pathlib import Path

import numpy as np
from matplotlib.colors import Normalize, PowerNorm

from paper import instants
from results import Dump, dumps, series
from style import RUBBER, SOLID, plt, save
from valve_profiles import spread

INSTANTS = 4
MILLI = 1e3
HEAD = 0.6  # mm above the membrane that a section shows
NEAR, ABOVE, BELOW = 0.7, 0.25, 1.05  # mm around the seat that its picture shows


def shown(run: Path) -> list[Dump]:
    """The states nearest to the instants that the paper names, or else some over the run."""
    states = [Dump(run, n) for n in range(dumps(run))]
    wanted = instants(run)
    if not wanted:
        return spread(states, INSTANTS)
    times = np.array([s.time for s in states])
    nearest = dict.fromkeys(int(np.argmin(np.abs(times - t))) for t in wanted)
    return [states[n] for n in nearest]


def speed(state: Dump) -> np.ndarray:
    return np.ma.masked_where(state.side == 0, np.hypot(*np.moveaxis(state.velocity, 2, 0)))


class Colours:
    """Scales that all instants share: pressure in kPa without the one cell in two hundred that is
    farthest out on either side, speed in m/s."""

    def __init__(self, states: list[Dump]):
        pressure = np.concatenate([s.pressure.compressed() for s in states])
        low, high = 1e-3 * np.percentile(pressure, [0.5, 99.5])
        self.pressure = Normalize(low, max(high, low + 1e-3))
        self.speed = PowerNorm(0.5, vmin=0, vmax=max(speed(s).max() for s in states) or 1)
        self.of_pressure, self.of_speed = plt.get_cmap("YlGnBu"), plt.get_cmap("magma")


def chamber_pressure(run: Path, state: Dump) -> float | None:
    """Pressure in kPa of what is above the membrane where the lattice has nothing there."""
    data = series(run)
    if (state.side == 1).any() or "pressure_above" not in data:
        return None
    return 1e-3 * np.interp(state.time, data["time"], data["pressure_above"])


def draw_half(axes, state: Dump, what: str, mirror: int, colours: Colours, chamber: float | None):
    """One half of a section; mirror is -1 on the left."""
    radial, axial = mirror * MILLI * state.radial, MILLI * state.axial
    pressure = what == "pressure"
    values = 1e-3 * state.pressure if pressure else speed(state)
    image = axes.pcolormesh(radial, axial, values.T, rasterized=True,
                            norm=colours.pressure if pressure else colours.speed,
                            cmap=colours.of_pressure if pressure else colours.of_speed)
    plus, minus = (MILLI * face[:, ::-1] * (mirror, 1) for face in (state.plus_face,
                                                                     state.minus_face))
    if chamber is not None:
        colour = colours.of_pressure(colours.pressure(chamber)) if pressure else "#f4f4f4"
        top = [[plus[-1, 0], 1e3], [0, 1e3]]
        axes.fill(*np.concatenate([plus, top]).T, color=colour, linewidth=0)
    axes.fill(*np.concatenate([plus, minus[::-1]]).T, color=RUBBER, linewidth=0)
    return image


def prepare(axes) -> None:
    axes.set_facecolor(SOLID)
    axes.grid(False)
    axes.set_aspect("equal")


def bars(figure, panels, images) -> None:
    for image, label in zip(images, ("speed (m/s)", "pressure (kPa)")):
        figure.colorbar(image, ax=panels, label=label, shrink=0.85, aspect=35, pad=0.01)


def draw_sections(run: Path, picture: Path) -> None:
    """At each instant the pressure on the left and the speed on the right."""
    states = shown(run)
    colours = Colours(states)
    lines = -(-len(states) // 2)
    columns = min(2, len(states))
    upper = max(MILLI * s.plus_face[:, 0].max() for s in states) + HEAD
    lower, outer = MILLI * states[0].axial[0], MILLI * states[0].radial[-1]
    slender = (upper - lower) / (2 * outer)
    figure, panels = plt.subplots(lines, columns,
                                  figsize=(5 * columns + 1.8, (4.4 * slender + 0.35) * lines + 0.5),
                                  squeeze=False, sharex=True, sharey=True, layout="constrained")
    figure.get_layout_engine().set(h_pad=0.1)  # a title keeps clear of the ticks above it
    for axes in panels.flat[len(states):]:
        axes.axis("off")
    for axes, state in zip(panels.flat, states):
        prepare(axes)
        chamber = chamber_pressure(run, state)
        images = [draw_half(axes, state, what, mirror, colours, chamber)
                  for what, mirror in (("pressure", -1), ("speed", 1))]
        axes.axvline(0, color="white", linewidth=0.8)
        axes.set_xlim(-outer, outer)
        axes.set_ylim(lower, upper)
        axes.set_title(f"{MILLI * state.time:.3g} ms: up to {speed(state).max():.3g} m/s",
                       fontsize=9)
    for axes in panels[-1]:
        axes.set_xlabel("radius (mm), left: pressure, right: speed")
    for axes in panels[:, 0]:
        axes.set_ylabel("axial (mm)")
    bars(figure, panels, images[::-1])
    save(figure, picture)


def seat(states: list[Dump]) -> tuple[float, float]:
    """Radius and axial place, mm, of the middle of where the face has the fewest cells of fluid
    below it, away from the rim."""
    state = max(states, key=lambda s: (s.side == 2).sum())
    radial, axial = (0.5 * (edge[1:] + edge[:-1]) for edge in (state.radial, state.axial))
    radial = radial[radial < 0.9 * state.minus_face[:, 1].max()]
    face = np.interp(radial, state.minus_face[:, 1], state.minus_face[:, 0])
    depth = np.full(len(radial), np.inf)
    for j in range(len(radial)):
        below = state.side[j, axial < face[j]][::-1] == 0
        below = below[2:]  # the face may lie in the first cell and its neighbour
        if below.any():
            depth[j] = np.argmax(below)
    narrow = depth == depth.min()
    return MILLI * radial[narrow].mean(), MILLI * face[narrow].mean()


def draw_seat(run: Path, picture: Path) -> None:
    """Around the seat: above the pressure, below the speed, an instant in each column."""
    states = shown(run)
    colours = Colours(states)
    radius, axial = seat(states)
    figure, panels = plt.subplots(2, len(states), figsize=(2.5 * len(states) + 1.2, 4.9),
                                  squeeze=False, sharex=True, sharey=True, layout="constrained")
    images = []
    for row, what in zip(panels, ("pressure", "speed")):
        for axes, state in zip(row, states):
            prepare(axes)
            image = draw_half(axes, state, what, 1, colours, chamber_pressure(run, state))
            axes.set_xlim(radius - NEAR, radius + NEAR)
            axes.set_ylim(axial - BELOW, axial + ABOVE)
        images.append(image)
        row[0].set_ylabel("axial (mm)")
    for axes, state in zip(panels[0], states):
        axes.set_title(f"{MILLI * state.time:.3g} ms", fontsize=9)
    for axes in panels[1]:
        axes.set_xlabel("radius (mm)")
    for row, image, label in zip(panels, images, ("pressure (kPa)", "speed (m/s)")):
        figure.colorbar(image, ax=row, label=label, shrink=0.9, pad=0.01)
    save(figure, picture)
