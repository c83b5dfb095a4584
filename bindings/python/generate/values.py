"""values.py - what a type of the interface is in Python: its annotation, its ctypes, its conversion."""

import ctypes

SCALARS = {"unsigned": "int", "signed": "int", "float": "float"}
HANDLES = {
    "cl_context": "cl.Context",
    "cl_device_id": "cl.Device",
    "cl_command_queue": "cl.CommandQueue",
    "cl_platform_id": "cl.Platform",
}
CALLBACKS = {"rsh_log": "Callable[[str], object]", "rsh_progress": "Callable[[int, int], object]"}


def class_name(name):
    """rsh_mesh_range: MeshRange."""
    return "".join(word.capitalize() for word in name.removeprefix("rsh_").split("_"))


def pointee(field):
    """rsh_scene of const rsh_scene*."""
    return field.type.removeprefix("const ").removesuffix("*").strip()


def is_given(field):
    """Not what the binding fills in itself."""
    return not (field.name == "struct_size" or field.name.startswith("reserved") or field.type == "void*")


def source(kind):
    """A type of ctypes as text."""
    if kind is None:
        return "None"
    if issubclass(kind, ctypes.Array):
        return f"{source(kind._type_)} * {kind._length_}"
    if issubclass(kind, ctypes.Structure):
        return class_name(kind.__name__)
    return f"ct.{kind.__name__}"


class Value:
    """A member of a struct or a parameter: `annotation`, `default`, `converter` or None."""

    def __init__(self, field, structs):
        self.annotation, self.default, self.converter = "", "None", None
        kind = field.kind_name
        if field.type == "rsh_float4":
            self.set("Vector", "vector")
        elif kind in SCALARS and field.count == 1:
            self.annotation, self.default = SCALARS[kind], "0"
        elif kind == "struct":
            self.set(f"{class_name(field.type)} | None", "nested")
        elif field.type == "cl_mem":
            self.set("Memory", "memory")
        elif field.type in HANDLES:
            self.set(f"{HANDLES[field.type]} | None", "handle")
        elif field.type in CALLBACKS:
            self.set(f"{CALLBACKS[field.type]} | None", field.type.removeprefix("rsh_"))
        elif field.type == "const char*":
            self.set("str | None", "text")
        elif pointee(field) in structs:
            self.set(f"{class_name(pointee(field))} | None", "pointed")

    def set(self, annotation, converter):
        self.annotation, self.converter = annotation, converter


def docstring(text, indent):
    """Of a function or class, its lines indented."""
    lines = text.replace("\\", "\\\\").splitlines()
    return "\n".join(f"{indent}{line}".rstrip() for line in [f'"""{lines[0]}', *lines[1:]]) + (
        '"""\n' if len(lines) == 1 else f'\n{indent}"""\n'
    )


def parameters(rows):
    """A section in NumPy's style; rows of name, type, text."""
    listed = [f"{name} : {kind}" + (f"\n    {text}" if text else "") for name, kind, text in rows]
    return "\n".join(["Parameters", "----------", *listed]) if rows else ""


def sections(*texts):
    return "\n\n".join(filter(None, texts))
