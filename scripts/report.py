#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes DIR/report.html, one self-contained page, from a results directory. It says what is missing there."""
import argparse
import sys
from pathlib import Path

from report.data import read_results
from report.page import page


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", type=Path, metavar="DIR", help="results directory of a study")
    folder = parser.parse_args().directory
    if not folder.is_dir():
        print(f"report: no directory '{folder}'", file=sys.stderr)
        return 2
    target = folder / "report.html"
    unfinished = target.with_suffix(".html.new")  # renamed when complete: a reader never sees half a page
    unfinished.write_text(page(read_results(folder)), encoding="utf-8")
    unfinished.replace(target)
    print(target)
    return 0


if __name__ == "__main__":
    sys.exit(main())
