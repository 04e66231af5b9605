"""Makes the page: every section is a function that returns a title, a text and HTML."""
import argparse
import sys
import time

from . import page, points, renders


def main():
    parser = argparse.ArgumentParser(prog="tools/figures", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="small and fast, for continuous integration")
    parser.add_argument("-o", "--output", default="figures.html", help="file to write (default: figures.html)")
    options = parser.parse_args()
    sections = []
    for section in points.SECTIONS + renders.SECTIONS:
        begin = time.monotonic()
        sections.append(section(options.quick))
        print(f"figures: {sections[-1].title} ({time.monotonic() - begin:.1f} s)", file=sys.stderr)
    page.write(options.output, sections)
    print(f"figures: wrote {options.output}", file=sys.stderr)


main()
