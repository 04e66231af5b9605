"""One HTML file that holds all it shows."""
import base64
import collections
import html
import io
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

Section = collections.namedtuple("Section", "title text body")

STYLE = """body{font:16px/1.5 sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#222}
h1,h2{font-weight:600}h2{margin-top:3rem;border-top:1px solid #ddd;padding-top:1rem}img{max-width:100%}
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.2rem .9rem;text-align:right;border-bottom:1px solid #eee}
td:first-child,th:first-child{text-align:left}p{max-width:48rem}"""


def figure(plot):
    """The matplotlib figure as an image element; closes it."""
    data = io.BytesIO()
    alternative = html.escape("; ".join(filter(None, (axes.get_title() for axes in plot.axes))), quote=True)
    plot.savefig(data, format="png", dpi=110, bbox_inches="tight")
    plt.close(plot)
    return element(data.getvalue(), alternative)


def element(png, alternative, more=""):
    """An image element; `alternative` as HTML."""
    return f'<img alt="{alternative}"{more} src="data:image/png;base64,{base64.b64encode(png).decode()}">'


def image_file(path, alternative):
    """A PNG file as an image element of half the width, so that two stand side by side."""
    return element(pathlib.Path(path).read_bytes(), html.escape(alternative, quote=True), ' style="width:49%"')


def table(header, rows):
    cells = "".join(f"<th>{html.escape(str(h))}</th>" for h in header)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(str(c))}</td>" for c in row) + "</tr>" for row in rows)
    return f"<table><tr>{cells}</tr>{body}</table>"


def anchor(title):
    return "".join(c if c.isalnum() else "-" for c in title.lower())


def write(path, parts):
    """`parts` maps a heading to its sections."""
    contents, body = "", ""
    for heading, sections in parts.items():
        links = (f'<a href="#{anchor(s.title)}">{html.escape(s.title)}</a>' for s in sections)
        contents += f"<p><b>{html.escape(heading)}.</b> {' · '.join(links)}</p>"
        body += f"<h1>{html.escape(heading)}</h1>"
        body += "".join(f'<h2 id="{anchor(s.title)}">{html.escape(s.title)}</h2><p>{html.escape(s.text)}</p>{s.body}'
                        for s in sections)
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{" and ".join(parts)}</title>'
                   f"<style>{STYLE}</style></head><body>{contents}{body}</body></html>\n")
