"""What a paper or a measurement says of a run: paper.csv beside the scene, which the results keep.

Columns quantity, time [s], value, unit, label: a column of series.csv that has a value at a time;
or "section", without value and unit, a time whose section is drawn."""
import csv
import sys
from pathlib import Path

from results import UNITS

COLUMNS = {"quantity", "time [s]", "value", "unit", "label"}
SECTION = "section"


def rows(run: Path) -> list[dict[str, str]]:
    file = run / "paper.csv"
    if not file.exists():
        return []
    with open(file, newline="") as text:
        all_rows = list(csv.DictReader(text, skipinitialspace=True))
    for row in all_rows:
        if not COLUMNS <= row.keys() or (row["quantity"] != SECTION and row["unit"] not in UNITS):
            sys.exit(f"{file}: takes the columns {', '.join(sorted(COLUMNS))}, units one of "
                     f"{', '.join(UNITS)}.")
    return all_rows


def values(run: Path) -> list[dict[str, str]]:
    return [row for row in rows(run) if row["quantity"] != SECTION]


def instants(run: Path) -> list[float]:
    """Times in seconds at which sections are wanted, in order."""
    return sorted(float(row["time [s]"]) for row in rows(run) if row["quantity"] == SECTION)
