"""Results of rsh-bench as they were written, a file or several of one suite, and what their heads say."""
import hashlib
import json
import pathlib
import textwrap

# What makes two devices the same; memory is none of it, as the same chip comes with more or less.
DEVICE = ("name", "platform", "driver", "compute_units", "native_vector_width", "host_instruction_set")


class Results:
    """The cases of one suite. Of a case that several files have, the last one counts."""

    def __init__(self, paths, documents):
        self.paths, self.documents = paths, documents
        self.suite = documents[0]["suite"]
        self.cases = list({case["name"]: case for document in documents for case in document["cases"]}.values())

    def require_right(self):
        """A wrong answer has no speed, and no place in a table."""
        wrong = [case["name"] for case in self.cases if not case["ok"]]
        if wrong:
            raise SystemExit(f"{self.names()}: {wrong[0]} is wrong, and {len(wrong) - 1} more")

    def names(self):
        return ", ".join(str(path) for path in self.paths)

    def digest(self):
        """The same for the same content, however the JSON is laid out."""
        text = json.dumps(self.documents, sort_keys=True)
        return "results " + hashlib.sha256(text.encode()).hexdigest()[:16]


def read(path):
    """The JSON of one file, if it is one of rsh-bench."""
    try:
        document = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise SystemExit(f"{path}: {error}") from None
    if not isinstance(document, dict) or not isinstance(document.get("suite"), str):
        raise SystemExit(f"{path}: is not of rsh-bench: has no suite")
    if not isinstance(document.get("cases"), list):
        raise SystemExit(f"{path}: is not of rsh-bench: has no cases")
    for case in document["cases"]:
        if not isinstance(case, dict) or not {"name", "ok", "params", "metrics"} <= case.keys():
            raise SystemExit(f"{path}: a case has not all of name, ok, params and metrics: {str(case)[:60]}")
    return document


def by_suite(paths):
    """The results of all files, a suite each."""
    found = {}
    for path in paths:
        document = read(path)
        found.setdefault(document["suite"], []).append((path, document))
    return {suite: joined(files) for suite, files in found.items()}


def joined(files):
    (first_path, first), *others = files
    for path, document in others:
        difference = other_device(first, document)
        if difference:
            raise SystemExit(f"{first_path} and {path} are of several devices: {difference}")
    return Results([path for path, _ in files], [document for _, document in files])


def other_device(one, other):
    """In what two files' devices differ, or nothing. What one of them does not say is no difference."""
    for field in DEVICE:
        mine, its = one.get("device", {}).get(field), other.get("device", {}).get(field)
        if mine is not None and its is not None and mine != its:
            return f"{field} is {mine} and {its}"
    return None


def device_text(document):
    device = document.get("device", {})
    instructions = device.get("host_instruction_set", "instruction set not recorded")
    platform = f"{device.get('platform', 'platform not recorded')} {device.get('driver', '')}".strip()
    return (f"{device.get('name', 'device not recorded')}, {device.get('compute_units', '?')} compute units, "
            f"{instructions}, {platform}")


def commit_of(document):
    return document.get("rsh", {}).get("commit", "not recorded")


def command_of(document):
    """As somebody else would type it: without the folder of the program."""
    program, *arguments = document.get("command", "").split() or ["command not recorded"]
    return " ".join([pathlib.PurePath(program).name, *arguments])


def measured_on(results):
    """Device, commits and commands: the last line below a table."""
    commits = ", ".join(dict.fromkeys(commit_of(document) for document in results.documents))
    commands = ", ".join(f"`{command_of(document)}`" for document in results.documents)
    return f"- {device_text(results.documents[0])}, commit {commits}; {commands}."


def wrapped(lines):
    """Lines of a list, none longer than a page is wide."""
    return "\n".join(textwrap.fill(line, 108, subsequent_indent="  ", break_on_hyphens=False)
                     for line in lines)
