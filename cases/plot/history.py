"""Pressures on both sides over time, through the stage with the inlet shut."""
from pathlib import Path

from results import quantity, series
from style import DIFFUSE, SHARP, plt, save


def draw_history(run: Path, picture: Path) -> None:
    """Shares of the inlet's pressure: above, the upstream side close to 1; below, the downstream
    side close to 0. Each panel has its own scale, since the changes are small."""
    columns = series(run)
    inlet, settle = quantity(run, "inlet.pressure"), 1e3 * quantity(run, "run.settle")
    time = 1e3 * columns["time"]
    figure, (above, below) = plt.subplots(2, 1, figsize=(6.4, 4.2), sharex=True)
    above.plot(time, 100 * columns["pressure_above"] / inlet, color=SHARP,
               label="above the membrane")
    above.plot(time, 100 * columns["pressure_outside"] / inlet, color="#6fb1d8", linestyle="--",
               label="around the seat")
    below.plot(time, 100 * columns["pressure_inside"] / inlet, color=DIFFUSE, label="outlet's side")
    for axes in (above, below):
        axes.ticklabel_format(axis="y", useOffset=False)
        axes.margins(y=0.15)
        axes.set_ylabel("% of p_in")
        if time[-1] > settle:
            axes.axvspan(settle, time[-1], color="#f1ead8", zorder=0, label="inlet shut")
        axes.legend(loc="best")
    below.set_xlabel("time (ms)")
    above.set_xlim(time[0], time[-1])
    figure.tight_layout()
    save(figure, picture)
