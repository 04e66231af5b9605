"""Makes the page: every section is a function that returns a title, a text and HTML. Or measures the samplers."""
import argparse
import sys
import time

from . import page, points, ranking, renders


def make_page(output, quick):
    sections = []
    for section in points.SECTIONS + renders.SECTIONS:
        begin = time.monotonic()
        sections.append(section(quick))
        print(f"figures: {sections[-1].title} ({time.monotonic() - begin:.1f} s)", file=sys.stderr)
    page.write(output, sections)


def main():
    parser = argparse.ArgumentParser(prog="tools/figures", description="Figures of the syllabus on sampling.",
                                     epilog="example: tools/figures -o sampling.html")
    parser.add_argument("--quick", action="store_true", help="small and fast, for continuous integration")
    parser.add_argument("--measure", action="store_true", help="instead of the page, error and cost of every sampler: "
                        "Markdown tables, and JSON as FILE; an hour")
    parser.add_argument("--assets", metavar="FOLDER", help="of --measure: holds models/DamagedHelmet.glb and "
                        "env/royal_esplanade_1k.hdr, which are measured too")
    parser.add_argument("-o", "--output", metavar="FILE", help="file to write (default: figures.html, or samplers.json)")
    options = parser.parse_args()
    output = options.output or ("samplers.json" if options.measure else "figures.html")
    if options.measure:
        ranking.measure(output, options.assets, options.quick)
    else:
        make_page(output, options.quick)
    print(f"figures: wrote {output}", file=sys.stderr)


main()
