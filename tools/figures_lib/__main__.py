"""Makes the page: every section is a function that returns a title, a text and HTML. Or measures."""
import argparse
import sys
import time

from . import (bsdf_levels, bsdf_pictures, bsdf_plots, bsdf_speed, efficiency, environment, page, points, ranking,
               renders, transport_pictures, transport_plots)

PARTS = {"Sampling": points.SECTIONS + renders.SECTIONS,
         "Transport": transport_pictures.SECTIONS + environment.SECTIONS + transport_plots.SECTIONS,
         "BSDFs": bsdf_pictures.SECTIONS + bsdf_levels.SECTIONS + bsdf_plots.SECTIONS}
MEASURED = {"sampling": "samplers.json", "transport": "transport.json", "bsdfs": "bsdfs.json"}  # default outputs


def make_page(output, headings, quick):
    parts = {}
    for heading in headings:
        parts[heading] = []
        for section in PARTS[heading]:
            begin = time.monotonic()
            parts[heading].append(section(quick))
            print(f"figures: {parts[heading][-1].title} ({time.monotonic() - begin:.1f} s)", file=sys.stderr)
    page.write(output, parts)


def main():
    names = {heading.lower(): heading for heading in PARTS}
    parser = argparse.ArgumentParser(prog="tools/figures", description="Figures of the syllabus on sampling, light "
                                     "transport and BSDFs.",
                                     epilog="example: tools/figures --part transport -o transport.html")
    parser.add_argument("--quick", action="store_true", help="small and fast, for continuous integration")
    parser.add_argument("--part", choices=names, help="this part alone")
    parser.add_argument("--measure", action="store_true", help="instead of the page, error and cost of every sampler "
                        "(an hour); with --part transport, efficiency: error, seconds and their product; with --part "
                        "bsdfs, cost of every BSDF: Markdown tables, and JSON as FILE")
    parser.add_argument("--assets", metavar="FOLDER", help="of --measure: holds models/DamagedHelmet.glb and "
                        "env/royal_esplanade_1k.hdr, which are measured too")
    parser.add_argument("-o", "--output", metavar="FILE", help="file to write (default: figures.html, or "
                        f"{', '.join(MEASURED.values())})")
    options = parser.parse_args()
    measured = options.part or "sampling"
    output = options.output or (MEASURED[measured] if options.measure else "figures.html")
    if not options.measure:
        make_page(output, [names[options.part]] if options.part else PARTS, options.quick)
    elif measured == "bsdfs":
        bsdf_speed.measure(output, options.quick)
    else:
        {"sampling": ranking, "transport": efficiency}[measured].measure(output, options.assets, options.quick)
    print(f"figures: wrote {output}", file=sys.stderr)


main()
