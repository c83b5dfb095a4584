#!/usr/bin/env python3
"""same_bits.py RESULTS - compares what same_bits.sh left in RESULTS: the pictures old/*.exr and
new/*.exr in every bit of their pixels, and the checksums of old.json and new.json. A line per name.
Ends with 1 when something differs, a picture is only on one side, or nothing was compared."""
import json
import struct
import sys
import zlib
from pathlib import Path

ROWS_PER_CHUNK = {0: 1, 2: 1, 3: 16}  # by compression: none, zip of one row, zip


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def header(data):
    """The attributes of an EXR file as bytes, and where they end."""
    if data[:8] != b"\x76\x2f\x31\x01\x02\0\0\0":
        raise ValueError("not an EXR file of scan lines")
    attributes, at = {}, 8
    while data[at]:
        name, at = text(data, at)
        _, at = text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4 : at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def unpacked(chunk, size):
    """Undoes the deflation, the differences and the two halves of ZIP compression."""
    if len(chunk) == size:
        return chunk
    halves = bytearray(zlib.decompress(chunk))
    for i in range(1, len(halves)):
        halves[i] = (halves[i - 1] + halves[i] - 128) & 0xFF
    pixels = bytearray(size)
    pixels[0::2], pixels[1::2] = halves[: (size + 1) // 2], halves[(size + 1) // 2 :]
    return bytes(pixels)


class Picture:
    """Float channels in scan lines, as rsh-render writes them."""

    def __init__(self, path):
        self.data = Path(path).read_bytes()
        attributes, table = header(self.data)
        self.shape = attributes["channels"], attributes["dataWindow"], attributes["compression"]
        left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
        self.width, self.height = right - left + 1, bottom - top + 1
        self.names, at = [], 0
        while attributes["channels"][at]:
            name, at = text(attributes["channels"], at)
            self.names.append(name)
            at += 16
        self.rows = ROWS_PER_CHUNK[attributes["compression"][0]]
        count = -(-self.height // self.rows)
        self.offsets = struct.unpack_from(f"<{count}Q", self.data, table)

    def packed(self, i):
        _, size = struct.unpack_from("<ii", self.data, self.offsets[i])
        return self.data[self.offsets[i] + 8 : self.offsets[i] + 8 + size]

    def words(self, i):
        """Bits of chunk i: per row, channel after channel."""
        count = min(self.rows, self.height - i * self.rows) * len(self.names) * self.width
        return struct.unpack(f"<{count}I", unpacked(self.packed(i), 4 * count))

    def place(self, chunk, word):
        row, rest = divmod(word, len(self.names) * self.width)
        channel, x = divmod(rest, self.width)
        return f"pixel ({x}, {chunk * self.rows + row}) {self.names[channel]}"


def picture_difference(old_path, new_path):
    """Where two pictures differ first, and in how many values; "" when nowhere."""
    old, new = Picture(old_path), Picture(new_path)
    if old.shape != new.shape:
        return "another size, other channels or another compression"
    first, count = "", 0
    for i in range(len(old.offsets)):
        if old.packed(i) == new.packed(i):
            continue
        for at, (a, b) in enumerate(zip(old.words(i), new.words(i))):
            if a == b:
                continue
            first = first or f"{old.place(i, at)}: {a:08x} became {b:08x}"
            count += 1
    return first and f"{first}, {count} values differ"


def pictures(folder, side):
    return {path.stem: path for path in sorted((folder / side).glob("*.exr"))}


def checksums(folder, side):
    path = folder / f"{side}.json"
    if not path.exists():
        return {}
    # What is called refit was called updated.
    return {
        case["name"].replace("/updated", "/refit"): case["metrics"]["hits_checksum"]
        for case in json.loads(path.read_text())["cases"]
        if "hits_checksum" in case["metrics"]
    }


def checksum_difference(old, new):
    return "" if old == new else f"checksum {old} became {new}"


def compare(old, new, difference):
    """Prints a line per name; returns how many are the same, differ, and are on one side only."""
    same = differ = lone = 0
    for name in sorted(old.keys() | new.keys()):
        if name not in old or name not in new:
            lone += 1
            print(f"{'only old' if name in old else 'only new':9} {name}")
            continue
        what = difference(old[name], new[name])
        same, differ = same + (not what), differ + bool(what)
        print(f"{'DIFFERS' if what else 'same':9} {name}{': ' + what if what else ''}")
    return same, differ, lone


def main():
    folder = Path(sys.argv[1])
    shown = compare(pictures(folder, "old"), pictures(folder, "new"), picture_difference)
    # An engine that was added or removed has cases on one side only.
    cases = compare(checksums(folder, "old"), checksums(folder, "new"), checksum_difference)
    same, differ, lone = (a + b for a, b in zip(shown, cases))
    print(f"{same} the same, {differ} differ, {lone} on one side only")
    return 1 if differ or shown[2] or not same else 0


if __name__ == "__main__":
    sys.exit(main())
