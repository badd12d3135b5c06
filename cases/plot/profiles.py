"""Shape of the membrane over the radius, one line for each pressure."""
from pathlib import Path

import numpy as np

from results import Dump, quantity
from style import plt, save


def draw_profiles(runs: list[Path], picture: Path) -> None:
    """Left the mid-surface, right the face that seals; the zero is the undeformed mid-surface."""
    figure, panels = plt.subplots(1, 2, figsize=(7.2, 3.2), sharex=True)
    colours = plt.get_cmap("viridis_r")(np.linspace(0.15, 1, len(runs)))
    for run, colour in zip(runs, colours):
        dump = Dump(run)
        label = f"{1e-3 * quantity(run, 'inlet.pressure'):g} kPa"
        for axes, curve in zip(panels, (dump.membrane, dump.minus_face)):
            axes.plot(1e3 * curve[:, 1], 1e3 * curve[:, 0], color=colour, label=label)
    for axes, title in zip(panels, ("mid-surface", "face on the seat's side")):
        axes.set_title(title, fontsize=9)
        axes.set_xlabel("radius (mm)")
        axes.set_xlim(left=0)
    panels[0].set_ylabel("axial (mm)")
    panels[0].legend()
    figure.tight_layout()
    save(figure, picture)
