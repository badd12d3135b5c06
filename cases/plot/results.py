"""Reading the folder of a run: summary.json, scene.toml, series.csv and run.h5. All in SI units."""
import csv
import json
import tomllib
from pathlib import Path

import h5py
import numpy as np

UNITS = {
    "m": 1, "mm": 1e-3, "um": 1e-6, "s": 1, "ms": 1e-3, "us": 1e-6,
    "Pa": 1, "kPa": 1e3, "MPa": 1e6, "bar": 1e5,
    "m3/s": 1, "l/h": 1e-3 / 3600, "N": 1, "m/s": 1, "1": 1,
}


def done(run: Path) -> bool:
    """Whether the run has come to its end."""
    return (run / "summary.json").exists()


def summary(run: Path) -> dict[str, float]:
    """Value of every figure by its name."""
    figures = json.loads((run / "summary.json").read_text())
    return {name: f["value"] for name, f in figures.items() if name != "assumptions"}


def quantity(run: Path, key: str) -> float:
    """A quantity of the scene as it was run: quantity(run, "lattice.dx")."""
    node = tomllib.loads((run / "scene.toml").read_text())
    for part in key.split("."):
        node = node[part]
    value, unit = node.split()
    return float(value) * UNITS[unit]


def series(run: Path) -> dict[str, np.ndarray]:
    """Columns of series.csv by name, without the unit."""
    with open(run / "series.csv", newline="") as file:
        header, *rows = csv.reader(file)
    columns = np.array(rows, dtype=float).T
    return {name.split(" [")[0]: column for name, column in zip(header, columns)}


def units(run: Path) -> dict[str, str]:
    """SI unit of every column of series.csv, the first one first."""
    with open(run / "series.csv", newline="") as file:
        header = next(csv.reader(file))
    return {name: unit.rstrip("]") for name, unit in (cell.split(" [") for cell in header)}


def dumps(run: Path) -> int:
    """Number of states in run.h5."""
    with h5py.File(run / "run.h5") as file:
        return sum(name.startswith("dump_") for name in file)


class Dump:
    """A state of a run, by its number or the last. Points are (axial, radial).

    axial, radial   edges of the cells, [nx + 1], [ny + 1]
    pressure        [ny][nx], masked where there is no fluid
    side            [ny][nx], 0 no fluid, 1 above the membrane, 2 below it
    velocity        [ny][nx][2]
    membrane, plus_face, minus_face   nodes of the mid-surface and of the wet faces, [n][2]
    """

    def __init__(self, run: Path, number: int = -1):
        with h5py.File(run / "run.h5") as file:
            names = sorted(name for name in file if name.startswith("dump_"))
            grid, dump = file.attrs, file[names[number]]
            dx = grid["dx [m]"]
            self.time = float(dump.attrs["time"])
            self.axial = grid["origin axial [m]"] + dx * np.arange(grid["nx"] + 1)
            self.radial = grid["origin radial [m]"] + dx * np.arange(grid["ny"] + 1)
            fluid = dump["fluid"]
            self.side = fluid["side"][:]
            self.pressure = np.ma.masked_where(self.side == 0, fluid["pressure"][:])
            self.velocity = fluid["velocity"][:, :, :2]
            self.membrane, self.plus_face, self.minus_face = (
                dump[curve]["nodes"][:, :2] for curve in ("membrane", "plus_face", "minus_face")
            )
