#!/usr/bin/env python3
"""interface.py LIBRARY COMPILER OPTION... - whether rsh_describe_interface of the shared library says
what the headers do. These are read here from what the compiler's preprocessor leaves of them: other
code than cmake/describe_interface.cmake. Names, order and types of members and parameters, values of
constants; offsets and sizes against those that ctypes lays out; and a call by what was described.
Ends with 1 when anything is missing, too much or different."""
import ctypes
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "bindings/python/generate"))
from described import Interface

SOURCE = "#include <rsh/rsh_interface.h>\n"
WORDS = {"size_t": ("unsigned", 8), "int": ("signed", 4), "float": ("float", 4),
         "char": ("text", 1), "void": ("void", 0)}
for prefix in ("cl_", "rsh_"):
    WORDS |= {prefix + "uint": ("unsigned", 4), prefix + "ulong": ("unsigned", 8),
              prefix + "long": ("signed", 8), prefix + "float": ("float", 4)}
WORDS |= {"rsh_float4": ("float", 4), "rsh_status": ("signed", 4), "rsh_features": ("unsigned", 4),
          "cl_bool": ("unsigned", 4), "cl_int": ("signed", 4)}
HANDLES = {"cl_context", "cl_device_id", "cl_platform_id", "cl_command_queue", "cl_mem", "cl_event",
           "rsh_context"}


def preprocessed(command, options, source):
    done = subprocess.run([*command, "-E", *options, "-x", "c", "-"], input=source, text=True,
                          stdout=subprocess.PIPE, check=True)
    return done.stdout


class Headers:
    def __init__(self, command, options):
        text = preprocessed(command, [*options, "-P"], SOURCE)
        text = re.sub(r"__attribute__\s*\(\((?:[^()]|\([^()]*\))*\)\)", "", text)
        self.constants = {}
        self.add_enumerators(text)
        self.add_macros(command, options)
        self.structs = {name: self.fields(body) for name, body in
                        re.findall(r"struct\s+(rsh_\w+)\s*\{(.*?)\}", text, re.DOTALL)}
        self.callbacks = {name: self.function(result, body) for result, name, body in
                          re.findall(r"typedef\s+(\w+)\s*\(\*(rsh_\w+)\)\s*\(([^()]*)\)", text)}
        self.functions = {name: self.function(result, body) for result, name, body in
                          re.findall(r"([\w *]+[ *\s])(rsh_\w+)\s*\(([^()]*)\)\s*;", text)}

    def number(self, text):
        """Of an integer expression in C."""
        return eval(re.sub(r"(?<=[0-9a-f])[uUlL]+\b", "", text), {"__builtins__": {}}, self.constants)

    def add_enumerators(self, text):
        for body in re.findall(r"enum\s*\w*\s*\{([^{}]*)\}", text):
            value = -1
            for item in filter(str.strip, body.split(",")):
                name, _, given = item.partition("=")
                value = self.number(given) if given else value + 1
                if name.strip().startswith("RSH_"):
                    self.constants[name.strip()] = value

    def add_macros(self, command, options):
        """Those that become integers."""
        names = re.findall(r"^#define (RSH_\w+) .", preprocessed(command, [*options, "-dM"], SOURCE),
                           re.MULTILINE)
        asked = "".join(f"@{name[4:]} = {name}\n" for name in names)
        text = preprocessed(command, [*options, "-P"], SOURCE + asked)
        for name, value in re.findall(r"^@(\w+) = (.*)$", text, re.MULTILINE):
            if re.fullmatch(r"[-+*() 0-9a-fxuUlL]+", value):
                self.constants["RSH_" + name] = self.number(value)

    def declaration(self, text):
        """'const rsh_scene *scene[2]' as (name, type, elements)."""
        found = re.fullmatch(r"(.*?[\s*])(\w+)\s*(?:\[(.*)\])?", text.strip(), re.DOTALL)
        kind = re.sub(r"\s*\*\s*", "*", " ".join(found[1].split()))
        return found[2], kind, self.number(found[3]) if found[3] else 1

    def fields(self, body):
        fields = []
        for line in filter(str.strip, body.split(";")):
            first, *more = line.split(",")
            fields.append(self.declaration(first))
            fields += [(name.strip(), *fields[-1][1:]) for name in more]
        return fields

    def function(self, result, body):
        parameters = [] if body.strip() == "void" else body.split(",")
        return self.declaration(result + " it")[1], [self.declaration(p) for p in parameters]


class Comparison:
    def __init__(self, headers, described):
        self.headers, self.described, self.complaints = headers, described, []

    def same(self, what, described, header):
        if described != header:
            self.complaints.append(f"{what}: is described as {described}, the header has {header}")

    def names(self, what, described, header):
        for name in sorted(described.keys() ^ header.keys()):
            self.complaints.append(f"{what}: only the {'header' if name in header else 'library'}"
                                   f" has {name}")
        return sorted(described.keys() & header.keys())

    def value(self, what, info, name, kind, elements):
        word, size = WORDS.get(kind, ("pointer", 8))
        if kind in self.headers.structs:
            word, size = "struct", self.described.structs[kind].size
        elif word == "pointer" and not (kind.endswith("*") or kind in HANDLES
                                        or kind in self.headers.callbacks):
            self.complaints.append(f"{what}.{name}: interface.py does not know the type {kind}")
        count = 0 if word == "void" else elements * (4 if kind == "rsh_float4" else 1)
        self.same(f"{what}.{name}", (info.name, info.type, info.kind_name, info.count, info.size),
                  (name, kind, word, count, count * size))

    def values(self, what, infos, declarations):
        self.same(f"members of {what}", [info.name for info in infos],
                  [name for name, _, _ in declarations])
        for info, (name, kind, elements) in zip(infos, declarations):
            self.value(what, info, name, kind, elements)

    def run(self):
        for name in self.names("structs", self.described.structs, self.headers.structs):
            self.values(name, self.described.structs[name].fields, self.headers.structs[name])
        for kind in ("functions", "callbacks"):
            described, header = getattr(self.described, kind), getattr(self.headers, kind)
            for name in self.names(kind, described, header):
                result, parameters = header[name]
                self.value(name, described[name].result, "", result, 1)
                self.values(name, described[name].parameters, parameters)
        for name in self.names("constants", self.described.constants, self.headers.constants):
            self.same(name, self.described.constants[name], self.headers.constants[name])
        self.complaints += self.described.misplaced()


def main():
    library, compiler, *options = sys.argv[1:]
    described = Interface(ctypes.CDLL(library))
    comparison = Comparison(Headers([compiler], options), described)
    comparison.run()
    value = ctypes.c_uint32()
    status = described.call("rsh_strategy_from_name", b"lookback", ctypes.byref(value))
    comparison.same("rsh_strategy_from_name", (status, value.value),
                    (0, described.constants["RSH_STRATEGY_LOOKBACK"]))
    print(*comparison.complaints, sep="\n")
    print(f"{len(described.structs)} structs, {len(described.constants)} constants, "
          f"{len(described.functions)} functions and {len(described.callbacks)} callbacks: "
          f"{len(comparison.complaints)} complaints")
    return 1 if comparison.complaints or not described.structs else 0


if __name__ == "__main__":
    sys.exit(main())
