"""described.py - rsh_describe_interface of a loaded library as Python's ctypes: classes for its structs,
and its functions with their types. What a binding begins with."""

import ctypes

KINDS = ("void", "unsigned", "signed", "float", "text", "pointer", "struct")


class Field(ctypes.Structure):
    _fields_ = [
        ("_name", ctypes.c_char_p),
        ("_type", ctypes.c_char_p),
        ("offset", ctypes.c_size_t),
        ("size", ctypes.c_size_t),
        ("count", ctypes.c_uint32),
        ("kind", ctypes.c_uint32),
    ]
    name = property(lambda self: self._name.decode())
    type = property(lambda self: self._type.decode())
    kind_name = property(lambda self: KINDS[self.kind])


def listed(pointer, count):
    return [pointer[i] for i in range(count)]


class Struct(ctypes.Structure):
    _fields_ = [
        ("_name", ctypes.c_char_p),
        ("size", ctypes.c_size_t),
        ("align", ctypes.c_size_t),
        ("_fields", ctypes.POINTER(Field)),
        ("_count", ctypes.c_size_t),
    ]
    fields = property(lambda self: listed(self._fields, self._count))


class Constant(ctypes.Structure):
    _fields_ = [("_name", ctypes.c_char_p), ("value", ctypes.c_int64)]


class Function(ctypes.Structure):
    _fields_ = [
        ("_name", ctypes.c_char_p),
        ("result", Field),
        ("_parameters", ctypes.POINTER(Field)),
        ("_count", ctypes.c_size_t),
    ]
    parameters = property(lambda self: listed(self._parameters, self._count))


class Tables(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_size_t)]
    for _name, _type in (
        ("structs", Struct),
        ("constants", Constant),
        ("functions", Function),
        ("callbacks", Function),
    ):
        _fields_ += [(_name, ctypes.POINTER(_type)), (_name[:-1] + "_count", ctypes.c_size_t)]


class Interface:
    """Tables by name, and `classes`: a ctypes.Structure for each struct."""

    def __init__(self, library):
        self.library = library
        library.rsh_describe_interface.restype = ctypes.POINTER(Tables)
        tables = library.rsh_describe_interface().contents
        for name in ("structs", "constants", "functions", "callbacks"):
            rows = listed(getattr(tables, name), getattr(tables, name[:-1] + "_count"))
            setattr(self, name, {row._name.decode(): row for row in rows})
        self.constants = {name: row.value for name, row in self.constants.items()}
        self.classes = {}
        for name, struct in self.structs.items():
            self.classes[name] = type(name, (ctypes.Structure,), {"_fields_": self.layout(struct)})

    def ctype(self, field):
        """Of an element."""
        size = field.size // max(field.count, 1)
        if field.kind_name == "struct":
            return self.classes[field.type]
        return {
            ("unsigned", 4): ctypes.c_uint32,
            ("unsigned", 8): ctypes.c_uint64,
            ("signed", 4): ctypes.c_int32,
            ("signed", 8): ctypes.c_int64,
            ("float", 4): ctypes.c_float,
            ("text", 1): ctypes.c_char,
            ("pointer", 8): ctypes.c_char_p if field.type == "const char*" else ctypes.c_void_p,
            ("void", 0): None,
        }[field.kind_name, size]

    def layout(self, struct):
        """Padding is spelled out where alignment is more than that of elements, as of rsh_float4."""
        fields, end = [], 0
        for field in struct.fields:
            element = self.ctype(field)
            end = -(-end // ctypes.alignment(element)) * ctypes.alignment(element)
            if field.offset > end:
                fields.append((f"_padding_{end}", ctypes.c_char * (field.offset - end)))
            fields.append((field.name, element * field.count if field.count > 1 else element))
            end = field.offset + field.size
        if struct.size - end >= 8:
            fields.append((f"_padding_{end}", ctypes.c_char * (struct.size - end)))
        return fields

    def misplaced(self):
        """Complaints about structs that ctypes lays out in another way."""
        for name, struct in self.structs.items():
            made = self.classes[name]
            if ctypes.sizeof(made) != struct.size:
                yield f"{name}: is described with {struct.size} bytes, has {ctypes.sizeof(made)}"
            for field in struct.fields:
                place = getattr(made, field.name)
                if (place.offset, place.size) != (field.offset, field.size):
                    yield (
                        f"{name}.{field.name}: is described with offset and size {field.offset}, "
                        f"{field.size}, has {place.offset}, {place.size}"
                    )

    def call(self, name, *arguments):
        function, described = getattr(self.library, name), self.functions[name]
        function.restype = self.ctype(described.result)
        function.argtypes = [self.ctype(parameter) for parameter in described.parameters]
        return function(*arguments)
