"""What oscillates in gap and flow: their spectrum, and the last cycles of them and the pressure."""
from pathlib import Path

import numpy as np

from results import series, summary
from style import DIFFUSE, SHARP, plt, save

CYCLES = 5  # that are shown
NEARLY_ALL = 0.99  # of the power


def even(time: np.ndarray, value: np.ndarray) -> tuple[float, np.ndarray]:
    """Samples put on even times: their distance and values."""
    step = float(np.median(np.diff(time)))
    at = np.arange(time[0], time[-1], step)
    return step, np.interp(at, time, value)


def slow(value: np.ndarray, period: int) -> np.ndarray:
    """Mean over two periods under a Hann window, continued straight at both ends."""
    half = min(period, (len(value) - 1) // 2)
    window = 1 + np.cos(np.pi * np.arange(-half, half + 1) / half)
    mean = np.convolve(value, window / window.sum(), mode="valid")
    reach = min(half, len(mean) - 1)
    ahead, behind = np.arange(half, 0, -1), np.arange(1, half + 1)
    into = (mean[reach] - mean[0]) / max(reach, 1)
    out = (mean[-1] - mean[-1 - reach]) / max(reach, 1)
    return np.concatenate([mean[0] - into * ahead, mean, mean[-1] + out * behind])


def amplitudes(step: float, value: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies in Hz and the amplitude of a sine at each, under a Hann window."""
    window = np.hanning(len(value))
    size = 4 * len(value)
    return (np.fft.rfftfreq(size, step),
            2 * np.abs(np.fft.rfft(window * (value - value.mean()), size)) / window.sum())


def draw_spectrum(run: Path, picture: Path) -> None:
    """Left the amplitudes over frequency, from the oscillation's onset to its end or of the whole
    run; right, if there is an oscillation, its last cycles."""
    data, figures = series(run), summary(run)
    time = data["time"]
    frequency = figures.get("chatter_frequency")
    begin, end = figures.get("chatter_onset", time[0]), figures.get("chatter_end", time[-1])
    step, gap = even(time, data["gap"])
    flow = even(time, data["flow"])[1]
    at = time[0] + step * np.arange(len(gap))
    period = round(1 / (frequency * step)) if frequency else len(gap) // 10
    part = (at >= begin) & (at <= end)

    figure = plt.figure(figsize=(9.6 if frequency else 7.6, 4.2), layout="constrained")
    grid = figure.add_gridspec(2, 2 if frequency else 1)
    upper = figure.add_subplot(grid[0, 0])
    lower = figure.add_subplot(grid[1, 0], sharex=upper)
    widest = 0.0  # frequency below which nearly all of it is
    for axes, signal, factor, name in ((upper, gap, 1e6, "gap (µm)"),
                                       (lower, flow, 3.6e6, "flow (l/h)")):
        hertz, size = amplitudes(step, (signal - slow(signal, period))[part])
        axes.plot(hertz, factor * size, color=SHARP if axes is upper else DIFFUSE, linewidth=1.2)
        below = np.cumsum(size**2)
        widest = max(widest, hertz[np.searchsorted(below, NEARLY_ALL * below[-1])])
        axes.set_ylabel("amplitude of the " + name)
        axes.set_ylim(bottom=0)
        if frequency:
            axes.axvline(frequency, color="#4d4d4d", linewidth=0.8, linestyle="--")
            axes.annotate(f"{frequency:.4g} Hz", (frequency, 0.93), fontsize=9,
                          xycoords=("data", "axes fraction"), xytext=(5, 0),
                          textcoords="offset points", va="top")
    upper.set_xlim(0, min(0.5 / step, max(widest, 5 * frequency if frequency else 0)))
    upper.tick_params(labelbottom=False)
    lower.set_xlabel("frequency (Hz)")
    upper.set_title(f"{1e3 * begin:.4g} to {1e3 * end:.4g} ms, less the slow mean" if frequency else
                    "no oscillation found: all of the run, less its slow mean", fontsize=9)
    if frequency:
        draw_cycles(figure, grid, data, end - CYCLES / frequency, end)
    save(figure, picture)


def draw_cycles(figure, grid, data: dict[str, np.ndarray], begin: float, end: float) -> None:
    time = data["time"]
    part = (time >= begin) & (time <= end)
    upper = figure.add_subplot(grid[0, 1])
    lower = figure.add_subplot(grid[1, 1], sharex=upper)
    upper.plot(1e3 * time[part], 1e6 * data["gap"][part], color=SHARP)
    upper.axhline(0, color="#8a8a8a", linewidth=0.8)
    upper.set_ylabel("gap (µm)")
    upper.set_title("the last cycles", fontsize=9)
    upper.tick_params(labelbottom=False)
    flow, = lower.plot(1e3 * time[part], 3.6e6 * data["flow"][part], color=DIFFUSE, label="flow")
    lower.set_ylabel("flow (l/h)")
    lower.set_xlabel("time (ms)")
    lower.set_xlim(1e3 * begin, 1e3 * end)
    other = lower.twinx()
    other.spines["right"].set_visible(True)
    other.grid(False)
    difference = data["pressure_outside"] - data["pressure_inside"]
    pressure, = other.plot(1e3 * time[part], 1e-3 * difference[part], color="#5a8f3c",
                           linestyle="--", label="pressure difference")
    other.set_ylabel("pressure difference (kPa)")
    lower.legend(handles=[flow, pressure], loc="lower center", bbox_to_anchor=(0.5, 0.98), ncol=2,
                 fontsize=8)
