"""8-bit PNG files, and equality of their pixels (zlib's bytes differ between its versions)."""
import struct
import zlib

COLOR_TYPE = {1: 0, 3: 2, 4: 6}
SIGNATURE = b"\x89PNG\r\n\x1a\n"


class Picture:
    """Interleaved 8-bit pixels, row 0 at the top. `paint(u, v)` gives floats in [0,1] at texel centres."""

    def __init__(self, width, height, channels, paint):
        self.width, self.height, self.channels = width, height, channels
        self.pixels = bytearray()
        for y in range(height):
            for x in range(width):
                for c in paint((x + 0.5) / width, (y + 0.5) / height):
                    self.pixels.append(min(255, max(0, round(c * 255))))

    def texel(self, x, y):
        start = (y * self.width + x) * self.channels
        return tuple(c / 255 for c in self.pixels[start:start + self.channels])

    def encode(self):
        stride = self.width * self.channels
        rows = [bytes(self.pixels[y * stride:(y + 1) * stride]) for y in range(self.height)]
        header = struct.pack(">IIBBBBB", self.width, self.height, 8, COLOR_TYPE[self.channels], 0, 0, 0)
        data = b"".join(_filtered(row, above, self.channels)
                        for row, above in zip(rows, [bytes(stride)] + rows))
        return (SIGNATURE + _chunk(b"IHDR", header) + _chunk(b"IDAT", zlib.compress(data, 9))
                + _chunk(b"IEND", b""))


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _filtered(row, above, step):
    left = bytes(step) + row
    candidates = (row, bytes((a - b) & 255 for a, b in zip(row, left)),
                  bytes((a - b) & 255 for a, b in zip(row, above)))
    sizes = [sum(min(b, 256 - b) for b in candidate) for candidate in candidates]
    best = sizes.index(min(sizes))
    return bytes([best]) + candidates[best]


def same_pixels(a, b):
    """Whether two files this module wrote decode alike."""
    return _inflate(a) == _inflate(b)


def _inflate(data):
    out, at = [], len(SIGNATURE)
    if data[:at] != SIGNATURE:
        return data
    while at + 12 <= len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        out.append((kind, zlib.decompress(body) if kind == b"IDAT" else body))
        at += 12 + size
    return out
