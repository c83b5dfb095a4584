"""A folder with all that is made of results: tables, plots, and a page per suite."""
import html

from accuracy import page as accuracy_page
from reporting import drawing
from reporting.results import command_of, commit_of, device_text
from reporting.suites import SUITES


def write(folder, results, pictures):
    """`pictures`: the folder that rsh-bench accuracy --pictures wrote, or None."""
    folder.mkdir(parents=True, exist_ok=True)
    for found in results.values():
        text = SUITES[found.suite].table(found)
        plots = write_plots(folder, found)
        (folder / f"{found.suite}.md").write_text(text + "\n", encoding="utf-8")
        page = folder / f"{found.suite}.html"
        if pictures and found.suite == "accuracy":
            svg = plots[0].read_text(encoding="utf-8")
            page.write_text(accuracy_page.make(found, svg[svg.index("<svg"):], pictures), encoding="utf-8")
        else:
            page.write_text(plain_page(found, text, plots), encoding="utf-8")


def write_plots(folder, results):
    written = []
    for name, draw in SUITES[results.suite].plots.items():
        figure = draw(results)
        if figure:
            drawing.save(figure, folder / name, results)
            written.append(folder / name)
    return written


def plain_page(results, text, plots):
    heads = "\n".join(f"<p>{html.escape(f'{device_text(d)}; rsh commit {commit_of(d)}; {command_of(d)}')}</p>"
                      for d in results.documents)
    images = "\n".join(f'<p><img src="{plot.name}" alt="{plot.stem}"></p>' for plot in plots)
    return (f"<!doctype html><meta charset=utf-8><title>rsh-bench {results.suite}</title>\n"
            f"<h1>rsh-bench {results.suite}</h1>\n{heads}\n<pre>{html.escape(text)}</pre>\n{images}\n")
