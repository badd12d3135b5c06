"""One HTML page that holds everything of a run: pictures inside, figures, assumptions."""
import base64
import json
from html import escape
from pathlib import Path

from rim import in_words

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #222; margin: 2rem auto; max-width: 62rem;
       padding: 0 1rem; }
h1 { font-size: 1.5rem; margin-bottom: .2rem } h2 { font-size: 1.1rem; margin: 2rem 0 .6rem }
img { max-width: 100%; display: block; margin: .4rem 0 1.2rem }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
td { padding: .12rem 1.2rem .12rem 0; border-bottom: 1px solid #eee; vertical-align: top }
td.value { text-align: right; white-space: nowrap } td.name { color: #444 }
p.sub { color: #666; margin-top: 0 } .tables { display: flex; flex-wrap: wrap; gap: 1rem 3rem }
h3 { font-size: .95rem; margin: .4rem 0 }
"""
GROUPS = (("Valve", "valve_"), ("Chatter", "chatter_"))


def figure_tables(figures: dict[str, dict]) -> str:
    """A table for the valve's figures, one for its chatter, one for the others."""
    prefixes = tuple(prefix for _, prefix in GROUPS)
    text = ""
    for title, prefix in (*GROUPS, ("The run", "")):
        rows = [(name.removeprefix(prefix), figure) for name, figure in figures.items()
                if (name.startswith(prefix) if prefix else not name.startswith(prefixes))]
        if rows:
            text += f"<div><h3>{title}</h3><table>" + "".join(
                f'<tr><td class="name">{escape(name.replace("_", " "))}</td>'
                f'<td class="value">{escape(in_words(f["value"], f["unit"]))}</td></tr>'
                for name, f in rows) + "</table></div>"
    return f'<div class="tables">{text}</div>'


def write_page(run: Path, file: Path, title: str, pictures: list[tuple[str, Path]]) -> None:
    """The page of a run; it needs no other file.

    pictures   what each shows, and where it is
    """
    summary = run / "summary.json"
    figures = json.loads(summary.read_text()) if summary.exists() else {}
    assumptions = figures.pop("assumptions", {})
    text = (f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title>'
            f"<style>{STYLE}</style><h1>{escape(title)}</h1>")
    if not figures:
        text += '<p class="sub">The run has no summary.json: it has not come to its end.</p>'
    for caption, picture in pictures:
        data = base64.b64encode(picture.read_bytes()).decode()
        text += (f"<h2>{escape(caption)}</h2>"
                 f'<img alt="{escape(caption)}" src="data:image/png;base64,{data}">')
    if figures:
        text += "<h2>Figures</h2>" + figure_tables(figures)
    if assumptions:
        text += "<h2>Assumed or chosen</h2><table>" + "".join(
            f'<tr><td class="name">{escape(name)}</td><td>{escape(sentence)}</td></tr>'
            for name, sentence in assumptions.items()) + "</table>"
    file.write_text(text + "</html>\n")
    print(file)
