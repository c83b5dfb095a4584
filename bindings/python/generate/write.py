#!/usr/bin/env python3
"""write.py LIBRARY LOADER FOLDER HEADER... - writes the modules of the package that are made of the
interface: constants.py, structs.py and calls.py. Names, types and values come from
rsh_describe_interface of the library, what is said of them from the comments of the headers."""

import ctypes
import sys
from pathlib import Path

from calls import write_calls
from described import Interface
from headers import Comments
from structs import write_structs


def write_constants(interface):
    values = {name.removeprefix("RSH_"): value for name, value in interface.constants.items()}
    listed = "".join(f'    "{name}",\n' for name in sorted(values))
    lines = "".join(f"{name}: Final = {value}\n" for name, value in values.items())
    return (
        '"""The constants of rsh.h. Written when the package was built, from the library."""\n\n'
        f"from typing import Final\n\n__all__ = [\n{listed}]\n\n{lines}"
    )


def main():
    library, loader, folder, *headers = sys.argv[1:]
    ctypes.CDLL(loader, ctypes.RTLD_GLOBAL)  # the library names none
    interface = Interface(ctypes.CDLL(library))
    comments = Comments([Path(header) for header in headers])
    modules = {
        "constants.py": write_constants(interface),
        "structs.py": write_structs(interface, comments),
        "calls.py": write_calls(interface, comments),
    }
    for name, text in modules.items():
        (Path(folder) / name).write_text(text)


if __name__ == "__main__":
    main()
