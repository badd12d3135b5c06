"""Pressure over a section through the axis, with the deformed membrane."""
from pathlib import Path

import numpy as np

from results import Dump, quantity
from style import RUBBER, SOLID, plt, save


def draw_section(run: Path, picture: Path) -> None:
    """The right half is computed, the left half its mirror image."""
    dump = Dump(run)
    inlet = quantity(run, "inlet.pressure")
    figure, axes = plt.subplots(figsize=(7.2, 4.2))
    axes.set_facecolor(SOLID)
    axes.grid(False)
    for mirror in (1, -1):
        image = axes.pcolormesh(
            mirror * 1e3 * dump.radial, 1e3 * dump.axial, 1e-3 * dump.pressure.T,
            cmap="YlGnBu", vmin=0, vmax=1e-3 * inlet, rasterized=True,
        )
    half = np.concatenate([dump.plus_face, dump.minus_face[::-1]])
    outline = 1e3 * np.concatenate([half, half[::-1] * (1, -1)])
    axes.fill(outline[:, 1], outline[:, 0], color=RUBBER, linewidth=0)
    axes.set_aspect("equal")
    axes.set_xlim(-1e3 * dump.radial[-1], 1e3 * dump.radial[-1])
    axes.set_ylim(1e3 * dump.axial[0], 1e3 * dump.axial[-1])
    axes.set_xlabel("radius (mm)")
    axes.set_ylabel("axial (mm)")
    axes.set_title(
        f"Closed valve at {1e-3 * inlet:g} kPa, t = {1e3 * dump.time:.3g} ms "
        "(dark: membrane, grey: wall)", fontsize=9,
    )
    figure.colorbar(image, ax=axes, label="pressure (kPa)", shrink=0.8)
    save(figure, picture)
