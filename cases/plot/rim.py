"""Units that people read: kPa, l/h, um, ms in the place of SI's."""

RIM = {
    "Pa": ("kPa", 1e-3), "m3/s": ("l/h", 3.6e6), "s": ("ms", 1e3), "m": ("um", 1e6),
    "m3": ("mm³", 1e9),
}
PRINTED = {"um": "µm", "deg": "°", "m3/h": "m³/h", "1/s": "1/s", "1": "", "m2/s": "m²/s",
           "m/s": "m/s", "1e6/s": "10⁶/s"}


def at_the_rim(unit: str) -> tuple[str, float]:
    """Unit to print a quantity in, and what its SI value is multiplied by."""
    shown, factor = RIM.get(unit, (unit, 1.0))
    return PRINTED.get(shown, shown), factor


def in_words(value: float | None, unit: str) -> str:
    """A figure for people: "154.8 kPa"; a dash where there is none. Seconds stay seconds from ten
    on, lengths are millimetres from one on."""
    if value is None or value != value:
        return "–"
    if unit == "s" and abs(value) >= 10:
        return f"{value:.1f} s"
    if unit == "m" and abs(value) >= 1e-3:
        return f"{1e3 * value:.4g} mm"
    shown, factor = at_the_rim(unit)
    return f"{factor * value:.4g} {shown}".rstrip()
