"""Makes the page: every section is a function that returns a title, a text and HTML. Or measures."""
import argparse
import sys
import time

from . import bsdf_levels, bsdf_pictures, bsdf_plots, bsdf_speed, page, points, ranking, renders

PARTS = {"Sampling": points.SECTIONS + renders.SECTIONS,
         "BSDFs": bsdf_pictures.SECTIONS + bsdf_levels.SECTIONS + bsdf_plots.SECTIONS}


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
    parser = argparse.ArgumentParser(prog="tools/figures", description="Figures of the syllabus on sampling and BSDFs.",
                                     epilog="example: tools/figures --part bsdfs -o bsdfs.html")
    parser.add_argument("--quick", action="store_true", help="small and fast, for continuous integration")
    parser.add_argument("--part", choices=names, help="this part alone")
    parser.add_argument("--measure", action="store_true", help="instead of the page, error and cost of every sampler "
                        "(an hour) or, with --part bsdfs, cost of every BSDF: Markdown tables, and JSON as FILE")
    parser.add_argument("--assets", metavar="FOLDER", help="of --measure: holds models/DamagedHelmet.glb and "
                        "env/royal_esplanade_1k.hdr, which are measured too")
    parser.add_argument("-o", "--output", metavar="FILE",
                        help="file to write (default: figures.html, samplers.json or bsdfs.json)")
    options = parser.parse_args()
    bsdfs = options.part == "bsdfs"
    default = ("bsdfs.json" if bsdfs else "samplers.json") if options.measure else "figures.html"
    output = options.output or default
    if options.measure and bsdfs:
        bsdf_speed.measure(output, options.quick)
    elif options.measure:
        ranking.measure(output, options.assets, options.quick)
    else:
        make_page(output, [names[options.part]] if options.part else PARTS, options.quick)
    print(f"figures: wrote {output}", file=sys.stderr)


main()
