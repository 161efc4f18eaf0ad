#!/usr/bin/env python3
"""pack_table.py TOML OUT: a TOML text as the bytes that src/nc/language/packed_table.hpp reads where they lie."""
import struct
import sys
import tomllib
from pathlib import Path


def packed(value):
    if isinstance(value, bool):
        kind, content = b"b", bytes([value])
    elif isinstance(value, (int, float)):
        kind, content = b"n", struct.pack("<d", value)
    elif isinstance(value, str):
        kind, content = b"t", value.encode()
    elif isinstance(value, list):
        kind, content = b"a", b"".join(map(packed, value))
    elif isinstance(value, dict):
        kind, content = b"o", b"".join(bytes([len(key.encode())]) + key.encode() + packed(one) for key, one in value.items())
    else:
        raise TypeError(f"{value!r} is neither text, number, boolean, array nor table")
    return kind + struct.pack("<I", len(content)) + content


if __name__ == "__main__":
    source, out = map(Path, sys.argv[1:])
    out.write_bytes(packed(tomllib.loads(source.read_text())))
