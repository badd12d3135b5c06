"""Tables of a study in Markdown, read from the summary of each run."""
from collections.abc import Callable
from pathlib import Path

from results import quantity, summary

Column = tuple[str, Callable[[Path, dict[str, float]], str]]
LITRES_PER_HOUR = 3.6e6

run_name: Column = ("run", lambda run, s: run.name)
pressure: Column = ("p_in (kPa)", lambda run, s: f"{1e-3 * quantity(run, 'inlet.pressure'):g}")
dx: Column = ("dx (um)", lambda run, s: f"{1e6 * quantity(run, 'lattice.dx'):.4g}")
held: Column = ("jump held (%)", lambda run, s: f"{100 * s['pressure_jump_held']:.4f}")
leak: Column = ("leak (l/h)", lambda run, s: f"{LITRES_PER_HOUR * s['leak']:.2e}")
share: Column = ("leak / open flow", lambda run, s: f"{s['leak_of_open_flow']:.1e}")
balance: Column = ("leak by balance (l/h)",
                   lambda run, s: f"{LITRES_PER_HOUR * s['leak_by_balance']:.2e}")
sealed: Column = ("sealed", lambda run, s: "yes" if s["sealed"] else "no")
penetration: Column = ("penetration (um)", lambda run, s: f"{1e6 * s['penetration']:.3g}")
seat_force: Column = ("seat force (N)", lambda run, s: f"{s['seat_force']:.3f}")
deflection: Column = ("centre (mm)", lambda run, s: f"{1e3 * s['centre_deflection']:.4f}")
wall_time: Column = ("wall time (s)", lambda run, s: f"{s['wall_time']:.0f}")


def upstream(run: Path, s: dict[str, float]) -> str:
    return f"{100 * s['pressure_upstream'] / s['pressure_inlet']:.4f}"


def downstream(run: Path, s: dict[str, float]) -> str:
    return f"{100 * s['pressure_downstream'] / s['pressure_inlet']:.4f}"


def held_shut(run: Path, s: dict[str, float]) -> str:
    return f"{100 * s['pressure_jump_held_shut']:.4f}" if "pressure_jump_held_shut" in s else "-"


def leak_parts(run: Path, s: dict[str, float]) -> str:
    parts = s["leak_through_seat"], s["leak_through_membrane"]
    return " / ".join(f"{LITRES_PER_HOUR * part:.2g}" for part in parts)


def difference(run: Path, s: dict[str, float]) -> str:
    return f"{100 * (s['centre_deflection'] / s['centre_deflection_hydrostatic'] - 1):+.3f}"


off_hydrostatic: Column = ("off hydrostatic (%)", difference)

CERTIFICATE: list[Column] = [
    pressure,
    ("upstream (%)", upstream),
    ("downstream (%)", downstream),
    held,
    ("inlet shut (%)", held_shut),
    ("leak seat / membrane (l/h)", leak_parts),
    share,
    penetration,
    deflection,
    ("hydrostatic (mm)", lambda run, s: f"{1e3 * s['centre_deflection_hydrostatic']:.4f}"),
    off_hydrostatic,
    ("volume residual", lambda run, s: f"{s['volume_residual']:.1e}"),
    ("spurious velocity (mm/s)", lambda run, s: f"{1e3 * s['spurious_velocity']:.2g}"),
    wall_time,
]
RESOLUTIONS = [run_name, dx, held, leak, share, balance, sealed, penetration, deflection, wall_time]
SHIFTS = [run_name, held, ("inlet shut (%)", held_shut), leak, sealed, penetration, seat_force,
          deflection, off_hydrostatic]
LIP = [run_name, pressure, seat_force, penetration,
       ("centre (mm)", lambda run, s: f"{1e3 * s['centre_deflection_hydrostatic']:.4f}")]


def table(rows: list[list[str]]) -> str:
    """Rows of cells, the first one the header."""
    rows = [rows[0], ["---"] * len(rows[0]), *rows[1:]]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows) + "\n"


def markdown(title: str, runs: list[Path], columns: list[Column]) -> str:
    """A row for each run."""
    rows = [[name for name, _ in columns]]
    for run in runs:
        figures = summary(run)
        rows.append([cell(run, figures) for _, cell in columns])
    return f"### {title}\n\n" + table(rows)
