"""programs.py - the OpenCL programs that the library asks for while the tests run: as
record_programs.c left them in a folder, and as the list programs.txt names them, a line "STEM
OPTION OPTION..." each. Options that every program of a device has (the version, the vector width,
correctly rounded division) are left out. Says nothing about how a program is compiled."""
import re
from pathlib import Path

LIST = Path(__file__).with_name("programs.txt")


def lines_by_file(source):
    """The lines that each file has in a program, without its #includes."""
    found, name = {}, None
    for line in source.splitlines():
        mark = re.match(r'#line \d+ "([^"]+)"', line)
        if mark:
            name = mark.group(1)
        else:
            found.setdefault(name, []).append(line)
    return found


def is_of(kernels, source):
    """Whether the library made the program, of the files of the folder as they are."""
    if not source.startswith("#line "):
        return False
    for name, lines in lines_by_file(source).items():
        path = kernels / name
        if path.exists():
            own = [line for line in path.read_text().splitlines() if not line.startswith('#include "')]
            if own != lines:
                return False
    return True


def stem_of(source):
    return re.match(r'#line 1 "([^"]+)\.cl"', source).group(1)


def own_options(text):
    words = re.sub(r"-D RSH_WIDTH=\d+", "", text).split()
    return tuple(word for word in words if not word.startswith("-cl-"))


def recorded(folder, kernels):
    """Options and source of each program that was recorded, but those that a test made of altered
    kernels, or without the library."""
    found = set()
    for path in sorted(folder.glob("*.cl")):
        options, source = path.read_text().split("\n", 1)
        if is_of(kernels, source):
            found.add((own_options(options.removeprefix("// ")), source))
    return sorted(found)


def lines_of(found):
    return sorted({" ".join((stem_of(source), *options)) for options, source in found})


def listed():
    """Stem and options of each line of the list."""
    lines = (line.split() for line in LIST.read_text().splitlines())
    return [(words[0], tuple(words[1:])) for words in lines]


def differences(found):
    """What the list has and the tests did not build, and the other way round."""
    old, new = set(LIST.read_text().splitlines()), set(lines_of(found))
    return ([f"{line}: in {LIST.name}, built by no test" for line in sorted(old - new)] +
            [f"{line}: built by a test, not in {LIST.name}" for line in sorted(new - old)])
