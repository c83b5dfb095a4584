#!/usr/bin/env python3
"""rooms.py ROOT - whether the tree keeps to the list of rooms in ROOT/ARCHITECTURE.md: reads that
list and every #include of kernels/, lib/ and samples/render/. rooms.py --self-test shows on a small
made-up tree that each of its complaints can be made.

The list is the rows of tables whose first cell begins with a path in backticks, in order:

    | room | what is in it | may use | must not |
    |---|---|---|---|
    | `include/rsh/` | the interface | - | ... |
    | `lanes/` | ... | `include/rsh/` | ... |
    | `samples/render/files/` | ... | `include/rsh/` | ... |

A room that begins with include/, kernels/, lib/ or samples/ is that folder (or file, such as
`lib/pipeline.cpp`) with what is below it; any other is the folder of that name in kernels/ and in
lib/. A file is in the room with the longest name that fits. "May use" holds the names of earlier
rooms in backticks, as they stand in the first column; other words there are ignored, but
"everything", "all" and "any" are refused. A room may use itself.

Refused are:
- a file outside of every room, and a room that is in none of the folders;
- a room that may use a later one, itself by another name, or everything;
- an #include that "may use" does not name;
- circles of files and of rooms;
- an include by anything but its path from kernels/, lib/, samples/render/ or include/;
- a folder with more than 20 files;
- a kernel header without the guard RSH_<PATH>_H of its path: kernels/rays/box_node.h has
  RSH_RAYS_BOX_NODE_H;
- a macro, function or struct that two kernel headers define differently, unless one does so where a
  macro is defined (#ifdef) and the other where it is not (#ifndef, #else)."""
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

TREES = ("kernels", "lib", "samples/render")
# Where includes begin, by the tree of the file that has them.
ROOTS = {
    "include": ("include",),
    "kernels": ("kernels", "include"),
    "lib": ("lib", "kernels", "include"),
    "samples/render": ("samples/render", "include"),
}
SOURCES = {".c", ".cl", ".cpp", ".h", ".hpp", ".inc"}
MOST_FILES = 20


class Room:
    def __init__(self, name, may_use):
        self.name, self.may_use = name, may_use
        stem = name.rstrip("/")
        is_full = stem.split("/")[0] in ("include", "kernels", "lib", "samples")
        self.places = [stem] if is_full else [f"kernels/{stem}", f"lib/{stem}"]


def read_rooms(text):
    rooms = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        head = re.match(r"`([\w./-]+)`", cells[0])
        if line.strip().startswith("|") and head and len(cells) == 4:
            rooms.append(Room(head.group(1), cells[2]))
    return rooms


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", lambda m: "\n" * m.group().count("\n"), text, flags=re.DOTALL)


class File:
    def __init__(self, root, path):
        self.name = str(path.relative_to(root))
        self.tree = next(tree for tree in ROOTS if self.name.startswith(tree + "/"))
        self.text = without_comments(path.read_text())
        self.includes = []
        for line in self.text.splitlines():
            include = re.match(r'\s*#\s*include\s*(["<])([^">]+)[">]', line)
            if include:
                self.includes.append(include.groups())


class Tree:
    def __init__(self, root):
        self.root = Path(root)
        self.rooms = read_rooms((self.root / "ARCHITECTURE.md").read_text())
        self.complaints = []
        self.files = {}
        for tree in ("include", *TREES):
            for path in sorted((self.root / tree).rglob("*")):
                if path.suffix in SOURCES:
                    file = File(self.root, path)
                    self.files[file.name] = file
        self.uses = {file.name: self.resolve(file) for file in self.files.values()}

    def complain(self, text):
        self.complaints.append(text)

    def resolve(self, file):
        """The files that a file includes."""
        found = []
        for quote, path in file.includes:
            names = [f"{root}/{path}" for root in ROOTS[file.tree] if f"{root}/{path}" in self.files]
            found += names
            if len(names) > 1:
                self.complain(f"{file.name}: \"{path}\" may be {' or '.join(names)}")
            elif not names and quote == '"':
                self.complain(f"{file.name}: \"{path}\" is no path from {' or '.join(ROOTS[file.tree])}")
        return found

    def room_of(self, name):
        """The room of a file, or None."""
        fits = [(len(place), room) for room in self.rooms for place in room.places
                if name == place or name.startswith(place + "/")]
        return max(fits, key=lambda fit: fit[0])[1] if fits else None

    def allowed(self, room, earlier):
        """The names that "may use" holds."""
        names = re.findall(r"`([^`]+)`", room.may_use)
        for name in names:
            if name not in earlier:
                self.complain(f"{room.name} may use {name}, which is no earlier room")
        if re.search(r"\b(everything|all|any)\b", re.sub(r"`[^`]*`", "", room.may_use), re.IGNORECASE):
            self.complain(f"{room.name} may use \"{room.may_use}\": name the rooms")
        return set(names) | {room.name}

    def check_rooms(self):
        earlier, allowed = set(), {}
        for room in self.rooms:
            allowed[room.name] = self.allowed(room, earlier)
            earlier.add(room.name)
            if not any((self.root / place).exists() for place in room.places):
                self.complain(f"{room.name}: there is no such folder")
        for name in self.files:
            room = self.room_of(name)
            if not room:
                self.complain(f"{name} is in no room")
                continue
            for used in self.uses[name]:
                other = self.room_of(used)
                if other and other.name not in allowed[room.name]:
                    self.complain(f"{name} includes {used}: {room.name} may not use {other.name}")

    def check_circles(self):
        self.find_circle("files", self.uses)
        between = {}
        for name, uses in self.uses.items():
            for used in uses:
                one, other = self.room_of(name), self.room_of(used)
                if one and other and one is not other:
                    between.setdefault(one.name, []).append(other.name)
        self.find_circle("rooms", between)

    def find_circle(self, kind, uses):
        done = set()

        def walk(name, way):
            if name in way:
                circle = way[way.index(name):] + [name]
                self.complain(f"a circle of {kind}: {' -> '.join(circle)}")
            elif name not in done:
                for used in uses.get(name, ()):
                    walk(used, way + [name])
                done.add(name)

        for name in sorted(uses):
            walk(name, [])

    def check_folders(self):
        for tree in TREES:
            counts = Counter(path.parent for path in (self.root / tree).rglob("*") if path.is_file())
            for folder, count in sorted(counts.items()):
                if count > MOST_FILES:
                    self.complain(f"{folder.relative_to(self.root)} has {count} files")

    def headers(self):
        return [file for file in self.files.values() if file.tree == "kernels" and file.name.endswith(".h")]

    def check_guards(self):
        for header in self.headers():
            path = header.name.removeprefix("kernels/")
            guard = "RSH_" + re.sub(r"\W", "_", path).upper()
            if not re.match(rf"\s*#ifndef {guard}\n\s*#define {guard}\n", header.text):
                self.complain(f"{header.name}: must begin with #ifndef {guard} and #define {guard}")

    def check_names(self):
        seen = {}
        for header in self.headers():
            for name, (text, where) in definitions(header.text).items():
                for other, other_text, other_where in seen.get(name, ()):
                    exclude = any((macro, not is_defined) in other_where for macro, is_defined in where)
                    if text != other_text and not exclude:
                        self.complain(f"{name} is defined differently in {other} and {header.name}")
                seen.setdefault(name, []).append((header.name, text, where))

    def check(self):
        if not self.rooms:
            self.complain("ARCHITECTURE.md has no list of rooms")
        self.check_rooms()
        self.check_circles()
        self.check_folders()
        self.check_guards()
        self.check_names()
        return sorted(set(self.complaints))


FUNCTION = re.compile(r"^(?:static|inline)\b[^;{}()]*?\b(\w+)\([^;{]*\)\s*\{(?:[^\n]*\}$|.*?^\})",
                      re.MULTILINE | re.DOTALL)
STRUCT = re.compile(r"^typedef struct \w+ \{.*?^\} (\w+);", re.MULTILINE | re.DOTALL)


def conditions(lines):
    """For each line the macros that #ifdef and #ifndef ask for there: (macro, must be defined)."""
    stack, found = [], []
    for line in lines:
        words = re.match(r"\s*#\s*(if|ifdef|ifndef|else|elif|endif)\b\s*(\w*)", line)
        if words and words.group(1).startswith("if"):
            stack.append((words.group(2), words.group(1) == "ifdef") if words.group(1) != "if" else None)
        elif words and words.group(1) == "endif":
            stack.pop()
        elif words and stack[-1]:
            stack[-1] = (stack[-1][0], not stack[-1][1])
        found.append({condition for condition in stack if condition})
    return found


def definitions(text):
    """By name, the text of the macros, functions and structs that a header defines, and the
    conditions of the last one. Left out are macros that it takes back."""
    text = text.replace("\\\n", " ")
    lines = text.splitlines()
    where = conditions(lines)
    undone = set(re.findall(r"^\s*#\s*undef\s+(\w+)", text, re.MULTILINE))
    found = {}

    def add(name, definition, line):
        before = found.get(name, ("", set()))[0]
        found[name] = (before + "\n" + " ".join(definition.split()), where[line])

    for number, line in enumerate(lines):
        macro = re.match(r"\s*#\s*define\s+(\w+)(.*)$", line)
        if macro and macro.group(1) not in undone:
            add(macro.group(1), macro.group(2), number)
    code = re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)
    for kind in (FUNCTION, STRUCT):
        for match in kind.finditer(code):
            add(match.group(1), match.group(), code.count("\n", 0, match.start()))
    return found


MADE_UP = {
    "ARCHITECTURE.md": "| room | what | may use | must not |\n|---|---|---|---|\n"
                       "| `include/rsh/` | interface | - | - |\n"
                       "| `low/` | below | `include/rsh/` | - |\n"
                       "| `high/` | above | `low/` | - |\n"
                       "| `samples/render/cli/` | program | `include/rsh/` | - |\n",
    "include/rsh/rsh.h": "",
    "kernels/low/a.h": "/* a.h */\n#ifndef RSH_LOW_A_H\n#define RSH_LOW_A_H\n"
                       "static int one(void) { return 1; }\n#endif\n",
    "kernels/low/b.h": "#ifndef RSH_LOW_B_H\n#define RSH_LOW_B_H\n#include \"low/a.h\"\n"
                       "#define RSH_B 1\n#endif\n",
    "kernels/high/c.cl": "#include \"low/b.h\"\n",
    "lib/low/a.hpp": "#include <rsh/rsh.h>\n#include <vector>\n",
    "lib/high/a.cpp": "#include \"low/a.hpp\"\n",
    "samples/render/cli/main.cpp": "#include <rsh/rsh.h>\n",
}

# What is changed in the made-up tree, and what must be said.
BREAKS = (
    ({"lib/low/a.hpp": "#include \"high/b.hpp\"\n", "lib/high/b.hpp": ""}, "low/ may not use high/"),
    ({"lib/high/a.cpp": "#include <rsh/rsh.h>\n"}, "high/ may not use include/rsh/"),
    ({"ARCHITECTURE.md": MADE_UP["ARCHITECTURE.md"].replace("`include/rsh/` | -", "`high/` | -", 1)},
     "low/ may use high/, which is no earlier room"),
    ({"ARCHITECTURE.md": MADE_UP["ARCHITECTURE.md"].replace("| `low/` |", "| everything |")},
     "high/ may use \"everything\""),
    ({"ARCHITECTURE.md": "no table"}, "has no list of rooms"),
    ({"ARCHITECTURE.md": MADE_UP["ARCHITECTURE.md"] + "| `gone/` | - | - | - |\n"}, "no such folder"),
    ({"lib/other/a.cpp": ""}, "lib/other/a.cpp is in no room"),
    ({"kernels/low/a.h": MADE_UP["kernels/low/a.h"] + "#include \"low/b.h\"\n"}, "a circle of files"),
    ({"lib/low/a.hpp": "#include \"high/b.hpp\"\n", "lib/high/b.hpp": ""}, "a circle of rooms"),
    ({"lib/high/a.cpp": "#include \"../low/a.hpp\"\n"}, "is no path from"),
    ({"kernels/high/c.cl": "#include \"a.h\"\n"}, "is no path from"),
    ({"kernels/low/a.hpp": ""}, "may be lib/low/a.hpp or kernels/low/a.hpp"),
    ({f"lib/low/{i}.txt": "" for i in range(20)}, "lib/low has 21 files"),
    ({"kernels/low/a.h": "#ifndef RSH_A_H\n#define RSH_A_H\n#endif\n"}, "must begin with #ifndef RSH_LOW_A_H"),
    ({"kernels/low/b.h": MADE_UP["kernels/low/b.h"] + "static int one(void)\n{\n    return 2;\n}\n"},
     "one is defined differently"),
    ({"kernels/low/a.h": MADE_UP["kernels/low/a.h"] + "#define RSH_B 2\n"},
     "RSH_B is defined differently"),
    ({"kernels/low/a.h": MADE_UP["kernels/low/a.h"] + "typedef struct s {\n    int i;\n} s;\n",
      "kernels/low/b.h": MADE_UP["kernels/low/b.h"] + "typedef struct s {\n    uint i;\n} s;\n"},
     "s is defined differently"),
)


def complaints_of(files):
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            path = Path(root) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return Tree(root).check()


def self_test():
    failed = 0
    # Alternatives, and macros that are taken back, may share names.
    fine = {"kernels/low/a.h": "#ifndef RSH_LOW_A_H\n#define RSH_LOW_A_H\n#ifdef RSH_X\n#if 1\n"
                               "static int one(void) { return 1; }\n#endif\n#endif\n"
                               "#define RSH_L 2\n#undef RSH_L\n#endif\n",
            "kernels/low/b.h": "#ifndef RSH_LOW_B_H\n#define RSH_LOW_B_H\n#ifndef RSH_X\n"
                               "static int one(void)\n{\n    return 2;\n}\n#endif\n"
                               "#define RSH_L 1\n#undef RSH_L\n#endif\n"}
    for change in ({}, fine):
        said = complaints_of({**MADE_UP, **change})
        if said:
            print(f"FAILED: a tree without faults: {said}")
            failed += 1
    for change, expected in BREAKS:
        said = complaints_of({**MADE_UP, **change})
        if not any(expected in text for text in said):
            print(f"FAILED: expected \"{expected}\", found {said}")
            failed += 1
    print(f"{len(BREAKS) + 2} trees, {failed} failed")
    return 1 if failed else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    tree = Tree(sys.argv[1])
    complaints = tree.check()
    for text in complaints:
        print(text)
    print(f"{len(tree.files)} files in {len(tree.rooms)} rooms, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
