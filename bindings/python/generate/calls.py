"""calls.py - the text of rsh/calls.py: a function for each one of the interface."""

from structs import members
from values import HANDLES, SCALARS, class_name, docstring, parameters, pointee, sections, source

HEAD = '''"""The functions of rsh.h. Written when the package was built, from the library and its headers."""

import ctypes as ct
from collections.abc import Callable
from typing import Any

import pyopencl as cl
from numpy.typing import NDArray

from rsh import _call
from rsh._call import WaitFor
from rsh._context import Context
from rsh._memory import Memory
from rsh._struct import Vector, host_array
from rsh.structs import *

'''
# Written by hand, as rsh.Context, rsh.find_device, rsh.Error and in generate/.
BY_HAND = {
    "rsh_create_context",
    "rsh_release_context",
    "rsh_find_device",
    "rsh_last_error",
    "rsh_describe_interface",
}
OUTPUTS = {"cl_uint": "ct.c_uint32"}
WAITS = ["wait_count", "wait_list", "done"]
RAISES = "Raises\n------\nrsh.Error\n    Something is wrong; the message says what."


class Call:
    """A function: what its parameters become."""

    def __init__(self, interface, comments, name):
        self.interface, self.comments, self.name = interface, comments, name
        self.described = interface.functions[name]
        self.positional, self.keywords, self.setup, self.passed, self.results = [], [], [], [], []
        parameters = self.described.parameters
        self.enqueues = [field.name for field in parameters[-3:]] == WAITS
        self.last_in = max((i for i, field in enumerate(parameters) if not is_writable(field)), default=-1)
        for i, field in enumerate(parameters[:-3] if self.enqueues else parameters):
            self.add(field, i > self.last_in)

    def add(self, field, is_result):
        kind = pointee(field)
        if field.type == "rsh_context":
            self.take(field.name, "Context", f"{field.name}.handle")
        elif field.type in HANDLES:
            self.take(field.name, HANDLES[field.type], f"{field.name}.int_ptr")
        elif field.type.startswith("const rsh_") and kind.endswith("_desc"):
            self.add_desc(field, kind)
        elif kind in self.interface.structs:
            self.add_struct(field, class_name(kind), is_result)
        elif is_result:
            self.give(field.name, f"{OUTPUTS[kind]}()", f"{field.name}.value", "int")
        elif field.type == "const char*":
            self.take(field.name, "str", f"{field.name}.encode()")
        elif field.kind_name in SCALARS:
            self.take(field.name, SCALARS[field.kind_name], field.name)
        else:
            raise ValueError(f"{self.name}: what is {field.type} {field.name} in Python?")

    def add_desc(self, field, kind):
        self.keywords += list(members(self.interface, self.comments, kind))
        given = "".join(f"        {member.name}={member.name},\n" for member, _, _ in self.keywords)
        self.setup.append(f"{field.name} = {class_name(kind)}(\n{given}    )")
        self.passed.append(f"ct.byref({field.name})")

    def add_struct(self, field, kind, is_result):
        if is_result:
            self.give(field.name, f"{kind}()", field.name, kind)
        elif is_writable(field):
            self.take(field.name, kind, f"ct.byref({field.name})")
        else:  # `materials`: scene.material_count of them
            count = f"scene.{field.name[:-1]}_count"
            self.take(
                field.name, "NDArray[Any]", f'host_array("{field.name}", {field.name}, {kind}, {count})'
            )

    def take(self, name, annotation, passed):
        self.positional.append((name, annotation))
        self.passed.append(passed)

    def give(self, name, made, result, annotation):
        self.setup.append(f"{name} = {made}")
        self.passed.append(f"ct.byref({name})")
        self.results.append((result, annotation))

    def result(self):
        """Annotation, and lines that end the body."""
        call = f"_{self.short()}({', '.join(self.passed)})"
        kind = self.described.result
        if self.enqueues:
            return "cl.Event", [f"return _call.enqueue(_{self.short()}, context, queue, desc, wait_for)"]
        if kind.type == "const char*":
            return "str | None", [f"return _call.decoded({call})"]
        if kind.type == "cl_bool":
            return "bool", [f"return bool({call})"]
        if kind.type != "rsh_status":
            return "int", [f"return int({call})"]
        if self.keywords and not self.results:
            return "None", [f"_call.run(_{self.short()}, context, desc)"]
        checked = f"_call.checked({call})"
        if not self.results:
            return "None", [checked]
        ((result, annotation),) = self.results
        return annotation, [checked, f"return {result}"]

    def short(self):
        return self.name.removeprefix("rsh_")

    def signature(self, annotation):
        parameters = [f"{name}: {kind}" for name, kind in self.positional]
        if self.keywords or self.enqueues:
            parameters.append("*")
        parameters += [
            f"{field.name}: {value.annotation} = {value.default}" for field, value, _ in self.keywords
        ]
        if self.enqueues:
            parameters.append("wait_for: WaitFor = None")
        listed = "".join(f"    {parameter},\n" for parameter in parameters)
        return f"def {self.short()}(\n{listed}) -> {annotation}:\n"

    def docstring(self, annotation):
        rows = [(name, kind, "") for name, kind in self.positional]
        rows += [(field.name, value.annotation, text) for field, value, text in self.keywords]
        if self.enqueues:
            rows.append(("wait_for", "iterable of pyopencl.Event, optional", ""))
        returns = "" if annotation == "None" else f"Returns\n-------\n{annotation}"
        raises = RAISES if self.described.result.type == "rsh_status" else ""
        said = self.comments.functions[self.name] or f"Call {self.name} of rsh.h."
        return docstring(sections(said, parameters(rows), returns, raises), "    ")

    def write(self):
        annotation, end = self.result()
        types = [source(self.interface.ctype(field)) for field in self.described.parameters]
        result = source(self.interface.ctype(self.described.result))
        body = "".join(f"    {line}\n" for line in self.setup + end)
        return (
            f'_{self.short()} = _call.declare("{self.name}", {result}, [{", ".join(types)}])\n\n\n'
            f"{self.signature(annotation)}{self.docstring(annotation)}{body}"
        )


def is_writable(field):
    return field.kind_name == "pointer" and field.type.endswith("*") and "const" not in field.type


def write_calls(interface, comments):
    names = [name for name in interface.functions if name not in BY_HAND]
    listed = "".join(f'    "{name.removeprefix("rsh_")}",\n' for name in sorted(names))
    calls = "\n\n".join(Call(interface, comments, name).write() for name in names)
    return f"{HEAD}__all__ = [\n{listed}]\n\n{calls}"
