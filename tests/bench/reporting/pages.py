"""Pages with sections that report.py writes: what stands between two lines which name the section. And the
plots that a page shows, which are files beside it."""
import itertools
import os
import re
from dataclasses import dataclass

from reporting import drawing
from reporting.suites import SUITES, suite_of_section

BEGIN = re.compile(r"^<!-- ([\w-]+): tests/bench/report\.py writes from here -->\n", re.MULTILINE)
ANY_END = re.compile(r"^<!-- .*: to here -->$", re.MULTILINE)


@dataclass(frozen=True)
class Section:
    name: str
    start: int  # in the page's text
    end: int
    text: str


def sections(path, page):
    if not ANY_END.search(page):
        raise SystemExit(f"{path}: has no section that report.py writes")
    found = []
    for begin in BEGIN.finditer(page):
        end = page.find(f"<!-- {begin[1]}: to here -->", begin.end())
        if end < 0 or BEGIN.search(page, begin.end(), end):
            raise SystemExit(f"{path}: section {begin[1]} begins, and has no line "
                             f"\"<!-- {begin[1]}: to here -->\"")
        found.append(Section(begin[1], begin.end(), end, page[begin.end():end]))
    if len(ANY_END.findall(page)) != len(found):
        raise SystemExit(f"{path}: of lines \"<!-- NAME: tests/bench/report.py writes from here -->\" it has "
                         f"{len(found)}, of lines \"<!-- NAME: to here -->\" {len(ANY_END.findall(page))}")
    return found


def read(path):
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise SystemExit(f"{path}: {error.strerror}") from None


def has_sections(path):
    return ANY_END.search(read(path)) is not None


def made(path, section, results):
    """What the section must be."""
    suite = suite_of_section(section.name)
    if not suite:
        raise SystemExit(f"{path}: section {section.name} is of no suite, must be of {', '.join(SUITES)}")
    if suite not in results:
        raise SystemExit(f"{path}: section {section.name} needs results of {suite}, there are none")
    results[suite].require_right()
    return f"\n{SUITES[suite].section(section.name, results[suite], section.text).strip()}\n\n"


def write(path, results):
    """Whether the page, or a plot that it shows, was another."""
    page = read(path)
    changed = page
    for section in reversed(sections(path, page)):
        changed = changed[:section.start] + made(path, section, results) + changed[section.end:]
    stale = stale_plots(path, page, results)
    for plot, draw, of in stale:
        figure = draw(of)
        if not figure:
            raise SystemExit(f"{path}: shows {os.path.relpath(plot)}, which {of.names()} has nothing for")
        drawing.save(figure, plot, of)
    if changed != page:
        path.write_text(changed, encoding="utf-8")
    return changed != page or bool(stale)


def complaints(path, results):
    """Where the page is not what write() would make of it."""
    page = read(path)
    found = []
    for section in sections(path, page):
        must = made(path, section, results)
        if section.text != must:
            found.append(first_difference(path, page, section, must))
    for plot, _, of in stale_plots(path, page, results):
        found.append(f"{path}: {os.path.relpath(plot)} is no plot of {of.names()}")
    return found


def first_difference(path, page, section, must):
    line = page.count("\n", 0, section.start) + 1
    for mine, right in itertools.zip_longest(section.text.split("\n"), must.split("\n")):
        if mine != right:
            break
        line += 1
    return (f"{path}:{line}: section {section.name} has\n    {mine or '(nothing)'}\n"
            f"  where the results say\n    {right or '(nothing)'}")


def stale_plots(path, page, results):
    """(file, function that draws it, results) of each plot that the page shows and that is missing or of
    other results."""
    shown = {os.path.basename(link): path.parent / link for link in re.findall(r"!\[[^]]*\]\(([^)]+)\)", page)}
    return [(shown[plot], draw, results[name]) for name, suite in SUITES.items() if name in results
            for plot, draw in suite.plots.items()
            if plot in shown and not drawing.is_of(shown[plot], results[name])]
