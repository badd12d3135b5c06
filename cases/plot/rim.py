"""Units that people read: kPa, l/h, um, ms in the place of SI's."""

RIM = {
    "Pa": ("kPa", 1e-3), "m3/s": ("l/h", 3.6e6), "s": ("ms", 1e3), "m": ("um", 1e6),
    "m3": ("mm³", 1e9),
}
PRINTED = {"um": "µm", "deg": "°", "m3/h": "m³/h", "1": "", "m2/s": "m²/s",
           "m2": "m²", "1e6/s": "10⁶/s"}


def at_the_rim(unit: str, largest: float = 0) -> tuple[str, float]:
    """Unit to print a quantity in, and what its SI value is multiplied by.

    largest   of the values, SI: lengths from one millimetre on are in millimetres
    """
    if unit == "m" and largest >= 1e-3:
        return "mm", 1e3
    shown, factor = RIM.get(unit, (unit, 1.0))
    return PRINTED.get(shown, shown), factor


def in_words(value: float | None, unit: str) -> str:
    """A figure for people: "154.8 kPa"; a dash where there is none. Seconds stay seconds from ten
    on."""
    if value is None or value != value:
        return "–"
    if unit == "s" and abs(value) >= 10:
        return f"{value:.1f} s"
    shown, factor = at_the_rim(unit, abs(value))
    return f"{factor * value:.4g} {shown}".rstrip()
