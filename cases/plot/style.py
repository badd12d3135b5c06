"""One look for all pictures."""
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of back end)

SHARP, DIFFUSE = "#1b6ca8", "#c8553d"
SOLID, RUBBER = "#b9b9b9", "#3b3b3b"

plt.rcParams.update({
    "figure.dpi": 150,
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e6e6e6",
    "axes.axisbelow": True,
    "legend.frameon": False,
})


def save(figure, path: Path) -> None:
    """Writes the picture and says where it is."""
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    print(path)
