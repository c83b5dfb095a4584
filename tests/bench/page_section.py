"""The part of a page that a report writes: what stands between two lines of it, which name the report."""
import pathlib
import textwrap


def begin_of(suite):
    return f"<!-- {suite}: tests/bench/{suite}/report.py writes from here -->"


def end_of(suite):
    return f"<!-- {suite}: to here -->"


def written(page, suite, text):
    """The page with the text in its place."""
    begin, end = begin_of(suite), end_of(suite)
    parts = page.read_text().split(begin)
    if len(parts) != 2 or parts[1].count(end) != 1:
        raise SystemExit(f"{page}: must have one line \"{begin}\" and one \"{end}\" behind it")
    return parts[0] + begin + "\n\n" + text + "\n\n" + end + parts[1].split(end)[1]


def check(page, suite, text, file):
    if written(page, suite, text) != page.read_text():
        raise SystemExit(f"{page}: the table is not that of {file}: write it with "
                         f"tests/bench/{suite}/report.py {file} --readme {page}")


def wrapped(lines):
    """Lines of a list, none longer than a page is wide."""
    return "\n".join(textwrap.fill(line, 108, subsequent_indent="  ", break_on_hyphens=False)
                     for line in lines)


def measured_on(document):
    """Device, commit and command: the last line below a table."""
    device = document["device"]
    program, *arguments = document["command"].split()
    return (f"- {device['name']}, {device['compute_units']} compute units, "
            f"{device['platform']} {device['driver']}, commit {document['rsh']['commit']}; "
            f"`{pathlib.PurePath(program).name} {' '.join(arguments)}`.")
