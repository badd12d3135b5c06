"""Leak over the size of the cells, for both couplings."""
from pathlib import Path

from results import quantity, summary
from style import DIFFUSE, SHARP, plt, save

AIM = 1e-6  # of the open flow


def draw_convergence(sharp: list[Path], diffuse: list[Path], picture: Path) -> None:
    """Share of the open flow (200 l/h at 3 bar); a leak of exactly zero has no place on the axis
    and is named in the legend."""
    figure, axes = plt.subplots(figsize=(4.8, 3.4))
    for runs, name, colour, marker in ((sharp, "sharp", SHARP, "o"),
                                       (diffuse, "diffuse", DIFFUSE, "s")):
        points = [(1e6 * quantity(r, "lattice.dx"), abs(summary(r)["leak_of_open_flow"]))
                  for r in runs]
        drawn = [p for p in points if p[1] > 0]
        zeros = [f"{dx:.3g}" for dx, leak in points if leak == 0]
        label = name + (f" (none at {', '.join(zeros)} um)" if zeros else "")
        axes.loglog(*zip(*drawn) if drawn else ([], []), marker=marker, color=colour, label=label)
    axes.axhline(AIM, color="black", linewidth=0.8, linestyle="--", label=f"aim, {AIM:.0e}")
    ticks = sorted({round(1e6 * quantity(r, "lattice.dx")) for r in sharp + diffuse})
    axes.set_xticks(ticks, [str(t) for t in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel("dx (um)")
    axes.set_ylabel("|leak| / open flow")
    axes.legend()
    save(figure, picture)
