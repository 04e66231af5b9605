"""expect.json: renders of a scene, and what must hold of each. The fact types are described in scenes/README.md."""
from .gltf import dump, rounded


class Expectations:
    def __init__(self, about, parity="general"):
        """`parity` is "diffuse" or "general": how many pixels of the two renderers may part at 1 spp."""
        self.json = {"about": about, "parity": {"kind": parity, "options": []}, "renders": []}

    def parity_options(self, *options):
        self.json["parity"]["options"] = list(options)

    def render(self, name, size, *options, spp=64, multiscatter=False):
        """Closed forms of glTF's material are those of its specification: without `multiscatter`."""
        if not multiscatter:
            options = (*options, "--multiscatter", "off")
        render = Render(name, [*options, "--size", f"{size[0]}x{size[1]}", "--spp", str(spp)])
        self.json["renders"].append(render.json)
        return render

    def output(self):
        return (dump(self.json) + "\n").encode()


class Render:
    def __init__(self, name, options):
        self.json = {"name": name, "options": options, "facts": []}

    def _fact(self, kind, why, **members):
        self.json["facts"].append(rounded({"type": kind, **members, "why": why}, 5))

    def region_mean(self, rect, value, tolerance, why):
        """`tolerance`: relative to the largest channel; the error of `value` itself, sampling noise comes on top."""
        self._fact("region_mean", why, rect=rect, value=value, tolerance=tolerance * max(max(value), 1e-3))

    def alpha_mean(self, rect, value, tolerance, why):
        self._fact("alpha_mean", why, rect=rect, value=value, tolerance=tolerance)

    def region_uniform(self, rect, tolerance, why):
        self._fact("region_uniform", why, rect=rect, tolerance=tolerance)

    def increasing(self, rects, why):
        self._fact("increasing", why, rects=rects)

    def mirror_symmetry(self, axis, tiles, tolerance, why):
        self._fact("mirror_symmetry", why, axis=axis, tiles=tiles, tolerance=tolerance)

    def max_below(self, rect, value, why):
        self._fact("max_below", why, rect=rect, value=value)

    def min_above(self, rect, value, why):
        self._fact("min_above", why, rect=rect, value=value)
