"""SSIM by scikit-image, and FLIP straight from its papers, to compare src/compare with.

usage: reference_metrics.py (display|linear) A.pfm B.pfm ...   three words a pair; prints a JSON list

FLIP [Andersson 20, 21] is written here a second time, as its formulas stand: filters are convolutions in the plane and
in double precision, the colour matrix follows from the primaries, where src/compare splits filters, works in tiles and
in floats.
"""
import json
import sys
from math import ceil, log2, pi, sqrt

import numpy
from scipy.ndimage import correlate
from skimage.metrics import structural_similarity

PIXELS_PER_DEGREE = 3840 * pi / 180  # of a screen as wide as it is far
LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])


def tristimulus(x, y):
    return numpy.array([x / y, 1, (1 - x - y) / y])


WHITE = tristimulus(0.31271, 0.32902)
PRIMARIES = numpy.array([tristimulus(0.64, 0.33), tristimulus(0.3, 0.6), tristimulus(0.15, 0.06)]).T
XYZ_FROM_RGB = PRIMARIES * numpy.linalg.solve(PRIMARIES, WHITE)


def read_pfm(name):
    with open(name, "rb") as file:
        kind, size, scale, data = file.read().split(b"\n", 3)
    assert kind == b"PF" and float(scale) < 0
    width, height = (int(word) for word in size.split())
    return numpy.frombuffer(data, "<f4").reshape(height, width, 3)[::-1].astype(float)


def decode(v):
    return numpy.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def encode(v):
    v = numpy.clip(v, 0, 1)
    return numpy.where(v <= 0.0031308, v * 12.92, 1.055 * v ** (1 / 2.4) - 0.055)


def opponent(rgb):
    x, y, z = numpy.moveaxis(rgb @ XYZ_FROM_RGB.T / WHITE, -1, 0)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def from_opponent(first, cx, cz):
    y = (first + 16) / 116
    return numpy.stack([y + cx / 500, y, y - cz / 200], -1) * WHITE @ numpy.linalg.inv(XYZ_FROM_RGB).T


def hunt_lab(rgb):
    t = rgb @ XYZ_FROM_RGB.T / WHITE
    x, y, z = numpy.moveaxis(numpy.where(t > (6 / 29) ** 3, numpy.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29), -1, 0)
    lightness = 116 * y - 16
    return lightness, lightness / 100 * 500 * (x - y), lightness / 100 * 200 * (y - z)


def hyab(p, q):
    return abs(p[0] - q[0]) + numpy.hypot(p[1] - q[1], p[2] - q[2])


def plane(radius):
    return numpy.meshgrid(numpy.arange(-radius, radius + 1), numpy.arange(-radius, radius + 1))


def sensitivity(*terms):
    x, y = plane(ceil(3 * sqrt(0.04 / (2 * pi**2)) * PIXELS_PER_DEGREE))
    squared = (x**2 + y**2) / PIXELS_PER_DEGREE**2
    weights = sum(a * sqrt(pi / b) * numpy.exp(-(pi**2) * squared / b) for a, b in terms)
    return weights / weights.sum()


def detectors():
    deviation = 0.082 / 2 * PIXELS_PER_DEGREE
    x, y = plane(ceil(3 * deviation))
    gauss = numpy.exp(-(x**2 + y**2) / (2 * deviation**2))
    for weights in (-x * gauss, (x**2 / deviation**2 - 1) * gauss):
        positive, negative = weights[weights > 0].sum(), -weights[weights < 0].sum()
        yield numpy.where(weights > 0, weights / positive, weights / negative)


def convolve(image, weights):
    return correlate(image, weights, mode="nearest")


def flip_map(image, reference):
    """Of linear colours in [0, 1]."""
    filters = [sensitivity((1, 0.0047)), sensitivity((1, 0.0053)), sensitivity((34.1, 0.04), (13.5, 0.025))]

    def seen(rgb):
        return hunt_lab(numpy.clip(from_opponent(*map(convolve, opponent(rgb), filters)), 0, 1))

    largest = hyab(hunt_lab(numpy.array([0, 1.0, 0])), hunt_lab(numpy.array([0, 0, 1.0]))) ** 0.7
    knee, raised = 0.4 * largest, hyab(seen(image), seen(reference)) ** 0.7
    color = numpy.where(raised < knee, 0.95 * raised / knee, 0.95 + 0.05 * (raised - knee) / (largest - knee))

    def strength(rgb, weights):
        luminance = (opponent(rgb)[0] + 16) / 116
        return numpy.hypot(convolve(luminance, weights), convolve(luminance, weights.T))

    edge, point = (abs(strength(image, w) - strength(reference, w)) for w in detectors())
    return color ** (1 - numpy.sqrt(numpy.maximum(edge, point) / sqrt(2)))


def hdr_flip_map(image, reference):
    k0, k1, k3, k4, k5 = 0.36 * 2.51, 0.6 * 0.03, 0.36 * 2.43, 0.6 * 0.59, 0.14
    a, b, c = k0 - 0.85 * k3, k1 - 0.85 * k4, -0.85 * k5
    shown = (-b + sqrt(b * b - 4 * a * c)) / (2 * a)
    luminance = reference @ LUMINANCE
    start, stop = log2(shown / luminance.max()), log2(shown / numpy.median(luminance))
    count = max(2, ceil(stop - start))
    worst = numpy.zeros(luminance.shape)
    for exposure in numpy.linspace(start, stop, count):
        a, r = (numpy.clip((k0 * x**2 + k1 * x) / (k3 * x**2 + k4 * x + k5), 0, 1)
                for x in (image * 2**exposure, reference * 2**exposure))
        worst = numpy.maximum(worst, flip_map(a, r))
    return worst


def ssim(image, reference):
    return structural_similarity(image, reference, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
                                 data_range=1.0, K1=0.01, K2=0.03)


def figures(encoding, image, reference):
    display = encoding == "display"
    flip = flip_map(decode(image), decode(reference)) if display else hdr_flip_map(image, reference)
    a, r = (image, reference) if display else (encode(image), encode(reference))
    return {"ssim": ssim(a @ LUMINANCE, r @ LUMINANCE), "channels": [ssim(a[..., c], r[..., c]) for c in range(3)],
            "flip": flip.mean()}


def main(words):
    pairs = zip(words[0::3], words[1::3], words[2::3])
    print(json.dumps([figures(kind, read_pfm(a), read_pfm(b)) for kind, a, b in pairs]))


main(sys.argv[1:])
