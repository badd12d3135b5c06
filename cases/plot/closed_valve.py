#!/usr/bin/env python3
"""Pictures and tables of the closed valve's study, from the folder that cases/closed_valve/study
writes. Runs that are missing are left out."""
import argparse
import sys
from pathlib import Path

from convergence import draw_convergence
from history import draw_history
from profiles import draw_profiles
from results import done
from section import draw_section
from tables import CERTIFICATE, LIP, RESOLUTIONS, SHIFTS, markdown

PRESSURES = ["p020", "p050", "p100", "p200", "p300"]
SHARP = ["dx200", "dx100", "dx067"]
DIFFUSE = ["diffuse_" + name for name in SHARP]
ALONG = [f"shift_x{quarter}" for quarter in range(4)]
ACROSS = [f"shift_y{quarter}" for quarter in range(1, 4)]
LIPS = [f"lip_{law}_{kpa}" for kpa in (100, 300) for law in ("none", "linear")]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", type=Path, help="folder of the study")
    parser.add_argument("--tables", action="store_true", help="print the tables, draw nothing")
    parser.add_argument("--section", default="p100", metavar="RUN",
                        help="run of the section and of the pressures over time (p100)")
    options = parser.parse_args()
    if not options.study.is_dir():
        sys.exit(f"There is no folder {options.study}.")

    def runs(names: list[str]) -> list[Path]:
        return [options.study / name for name in names if done(options.study / name)]

    if options.tables:
        for title, names, columns in (
            ("Certificate at five pressures", PRESSURES, CERTIFICATE),
            ("Three resolutions, both couplings", SHARP + DIFFUSE, RESOLUTIONS),
            ("Seat shifted by quarters of a cell, along x and across", ALONG + ACROSS, SHIFTS),
            ("Pressure under the lip", LIPS, LIP),
        ):
            if found := runs(names):
                print(markdown(title, found, columns))
        return

    if found := runs(PRESSURES):
        draw_profiles(found, options.study / "deflection_profiles.png")
    for run in runs([options.section]):
        draw_section(run, options.study / "section_pressure.png")
        draw_history(run, options.study / "jump_over_time.png")
    sharp, diffuse = runs(SHARP), runs(DIFFUSE)
    if sharp or diffuse:
        draw_convergence(sharp, diffuse, options.study / "leak_convergence.png")


if __name__ == "__main__":
    main()
