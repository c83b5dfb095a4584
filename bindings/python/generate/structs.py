"""structs.py - the text of rsh/structs.py: a class for each struct of the interface."""

from values import Value, class_name, docstring, is_given, parameters, sections, source

HEAD = '''"""The structs of rsh.h. Written when the package was built, from the library and its headers."""

import ctypes as ct
from collections.abc import Callable
from typing import TYPE_CHECKING

import pyopencl as cl

from rsh import _struct
from rsh._memory import Memory
from rsh._struct import Vector

'''


def members(interface, comments, name):
    """What a caller gives: (field, value, text)."""
    fields = interface.structs[name].fields
    for field in filter(is_given, fields):
        value = Value(field, interface.structs)
        if value.annotation:
            yield field, value, comments.members[name, field.name]


def write_struct(interface, comments, name):
    given = list(members(interface, comments, name))
    rows = [(field.name, value.annotation, text) for field, value, text in given]
    said = sections(comments.structs[name] or f"{name} of rsh.h.", parameters(rows))
    text = f"class {class_name(name)}(_struct.Struct):\n{docstring(said, '    ')}\n"
    layout = "".join(
        f'        ("{field}", {source(kind)}),\n' for field, kind in interface.layout(interface.structs[name])
    )
    text += f"    _fields_ = [\n{layout}    ]\n"
    converters = "".join(
        f'        "{field.name}": _struct.{value.converter},\n'
        for field, value, _ in given
        if value.converter
    )
    text += f"    _convert_ = {{\n{converters}    }}\n" if converters else ""
    if given:
        arguments = "".join(
            f"            {field.name}: {value.annotation} = {value.default},\n" for field, value, _ in given
        )
        text += (
            "    if TYPE_CHECKING:\n\n        def __init__(\n            self,\n            *,\n"
            f"{arguments}        ) -> None: ...\n"
        )
    return text


def write_structs(interface, comments):
    names = [name for name in interface.structs if name in comments.structs]
    listed = "".join(f'    "{class_name(name)}",\n' for name in sorted(names))
    classes = "\n\n".join(write_struct(interface, comments, name) for name in names)
    return f"{HEAD}__all__ = [\n{listed}]\n\n\n{classes}"
