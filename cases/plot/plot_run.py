#!/usr/bin/env python3
"""Pictures and one HTML page of a run, from the folder that velum run writes: histories, spectrum,
shapes of the membrane, sections. What a run has not is left out."""
import argparse
import tomllib
from pathlib import Path

import h5py

from page import write_page
from results import series
from valve_history import draw_histories
from valve_profiles import draw_profiles
from valve_section import draw_seat, draw_sections
from valve_sheet import draw_sheet
from valve_spectrum import draw_spectrum


def has_sections(run: Path) -> bool:
    """Whether there are fields in a plane with a membrane and its two faces."""
    if not (run / "run.h5").exists():
        return False
    with h5py.File(run / "run.h5") as file:
        names = sorted(name for name in file if name.startswith("dump_"))
        return bool(names) and all(
            part in file[names[0]] for part in ("fluid/side", "membrane", "plus_face"))


def has_profiles(run: Path) -> bool:
    if not (run / "profile.csv").exists():
        return False
    with open(run / "profile.csv") as file:
        return "minus_face_axial" in file.readline()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run", type=Path, help="results of the run")
    parser.add_argument("out", type=Path, help="folder of the pictures and the page")
    arguments = parser.parse_args()
    run, out = arguments.run, arguments.out
    valve = "gap" in series(run) and (run / "summary.json").exists()
    fields = has_sections(run)
    wanted = [("Over time", "history.png", draw_histories, True),
              ("Kv over lift; flow over pressure", "sheet.png", draw_sheet,
               valve and (run / "kv.csv").exists()),
              ("What oscillates", "spectrum.png", draw_spectrum, valve),
              ("Shape of the membrane", "profiles.png", draw_profiles,
               fields or has_profiles(run)),
              ("Sections: dark the membrane, grey walls and what a gap leaves to its closure",
               "sections.png", draw_sections, fields),
              ("At the seat", "seat.png", draw_seat, fields and valve)]
    pictures = []
    for caption, name, draw, there in wanted:
        if there:
            draw(run, out / name)
            pictures.append((caption, out / name))
    scene = run / "scene.toml"
    name = tomllib.loads(scene.read_text()).get("name", run.name) if scene.exists() else run.name
    write_page(run, out / "run.html", f"{name}: {run.name}", pictures)


if __name__ == "__main__":
    main()
