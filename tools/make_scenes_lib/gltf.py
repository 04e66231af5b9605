"""Collects the parts of one glTF 2.0 file and writes it, its buffer and its textures."""
import array
import json
import math
import sys

from .vec import look_at

FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5121, 5123, 5125
CODES = {FLOAT: "f", UNSIGNED_BYTE: "B", UNSIGNED_SHORT: "H", UNSIGNED_INT: "I"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
REPEAT, CLAMP, MIRROR = 10497, 33071, 33648
NEAREST, LINEAR = 9728, 9729


def rounded(value, digits=6):
    """Numbers as the file holds them: short, and the same on every machine."""
    if isinstance(value, bool) or isinstance(value, str) or value is None or isinstance(value, int):
        return value
    if isinstance(value, float):
        short = round(value, digits)
        return int(short) if short == int(short) else short
    if isinstance(value, dict):
        return {key: rounded(item, digits) for key, item in value.items()}
    return [rounded(item, digits) for item in value]


class Gltf:
    def __init__(self):
        self.binary = bytearray()
        self.files = {}
        self.extensions = set()
        self.json = {"asset": {"version": "2.0", "generator": "vkpt tools/make_scenes"}, "scene": 0}

    def _append(self, section, item):
        items = self.json.setdefault(section, [])
        if section in ("samplers", "textures") and item in items:
            return items.index(item)
        items.append(item)
        return len(items) - 1

    # ---- buffers ----

    def accessor(self, rows, kind, component=FLOAT, normalized=False, bounds=False, target=34962):
        """Rows of numbers, each row padded to 4 bytes as vertex attributes must be."""
        width = WIDTHS[kind]
        flat = array.array(CODES[component])
        padded = width
        if target == 34962:
            padded += (-width * flat.itemsize) % 4 // flat.itemsize
        for row in rows:
            flat.extend(row if width > 1 else (row,))
            flat.extend([0] * (padded - width))
        if sys.byteorder == "big":
            flat.byteswap()
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(flat) * flat.itemsize,
                "target": target}
        if padded != width:
            view["byteStride"] = padded * flat.itemsize
        self.binary.extend(flat.tobytes())
        item = {"bufferView": self._append("bufferViews", view), "componentType": component,
                "count": len(rows), "type": kind}
        if normalized:
            item["normalized"] = True
        if bounds:
            columns = [flat[i::padded] for i in range(width)]
            item["min"], item["max"] = [min(c) for c in columns], [max(c) for c in columns]
        return self._append("accessors", item)

    def primitive(self, shape, material, colors=None):
        """`colors` is (component type, rows), overriding the shape's float colours."""
        attributes = {"POSITION": self.accessor(shape.positions, "VEC3", bounds=True)}
        if shape.normals:
            attributes["NORMAL"] = self.accessor(shape.normals, "VEC3")
        if shape.tangents:
            attributes["TANGENT"] = self.accessor(shape.tangents, "VEC4")
        for i, uv in enumerate((shape.uv0, shape.uv1)):
            if uv:
                attributes[f"TEXCOORD_{i}"] = self.accessor(uv, "VEC2")
        component, rows = colors or (FLOAT, shape.colors)
        if rows:
            attributes["COLOR_0"] = self.accessor(rows, f"VEC{len(rows[0])}", component,
                                                  normalized=component != FLOAT)
        wide = len(shape.positions) > 65535
        indices = self.accessor([i for t in shape.triangles for i in t], "SCALAR",
                                UNSIGNED_INT if wide else UNSIGNED_SHORT, target=34963)
        return {"attributes": attributes, "indices": indices, "material": material}

    def mesh(self, name, *primitives):
        return self._append("meshes", {"name": name, "primitives": list(primitives)})

    def with_material(self, mesh, material, name):
        """A mesh of the same accessors with another material."""
        primitives = [dict(p, material=material) for p in self.json["meshes"][mesh]["primitives"]]
        return self.mesh(name, *primitives)

    # ---- materials ----

    def use(self, *names):
        self.extensions.update(names)

    def texture(self, name, picture, wrap=(REPEAT, REPEAT), filtering=LINEAR):
        """Index of a texture; the picture is stored once as NAME.png."""
        self.files[f"{name}.png"] = picture.encode() if name + ".png" not in self.files else self.files[f"{name}.png"]
        images = [image["uri"] for image in self.json.get("images", [])]
        uri = f"{name}.png"
        source = images.index(uri) if uri in images else self._append("images", {"uri": uri})
        sampler = self._append("samplers", {"magFilter": filtering, "minFilter": filtering,
                                            "wrapS": wrap[0], "wrapT": wrap[1]})
        return self._append("textures", {"sampler": sampler, "source": source})

    def texture_use(self, index, uv=0, transform=None, **more):
        use = {"index": index, **more}
        if uv:
            use["texCoord"] = uv
        if transform:
            self.use("KHR_texture_transform")
            use["extensions"] = {"KHR_texture_transform": rounded(transform)}
        return use

    def material(self, name, base=(1, 1, 1, 1), metallic=0.0, roughness=1.0, texture=None, orm=None,
                 normal=None, emissive=None, strength=None, emissive_texture=None, unlit=False, bsdf=None, **more):
        """Texture arguments are texture_use(...) dictionaries; `bsdf` is VKPT_materials_bsdf; `more` holds core members
        such as alphaMode."""
        base = tuple(base) + (1,) * (4 - len(base))
        pbr = {"baseColorFactor": base, "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture:
            pbr["baseColorTexture"] = texture
        if orm:
            pbr["metallicRoughnessTexture"] = orm
        item = {"name": name, "pbrMetallicRoughness": rounded(pbr)}
        if normal:
            item["normalTexture"] = normal
        if emissive:
            item["emissiveFactor"] = rounded(emissive)
        if emissive_texture:
            item["emissiveTexture"] = emissive_texture
        extensions = {}
        if strength is not None:
            extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": rounded(float(strength))}
        if unlit:
            extensions["KHR_materials_unlit"] = {}
        if bsdf:
            extensions["VKPT_materials_bsdf"] = rounded(bsdf)
        if extensions:
            self.use(*extensions)
            item["extensions"] = extensions
        item.update(more)
        return self._append("materials", item)

    def light_material(self, name, radiance):
        """A black material that emits `radiance` (nits)."""
        peak = max(radiance)
        return self.material(name, (0, 0, 0), 0.0, 1.0, emissive=tuple(c / peak for c in radiance), strength=peak)

    # ---- nodes ----

    def node(self, name=None, **members):
        """Members as in glTF, underscores excepted; identity values are left out."""
        plain = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}
        item = {"name": name} if name else {}
        for key, value in members.items():
            if value is not None and tuple(value) != plain.get(key) if key in plain else value is not None:
                item[key] = rounded(value) if key in plain else value
        return self._append("nodes", item)

    def perspective(self, name, eye, target, degrees, aspect=None):
        """Node of a camera with a vertical field of view in degrees."""
        perspective = {"yfov": round(math.radians(degrees), 6), "znear": 0.01}
        if aspect:
            perspective["aspectRatio"] = aspect
        camera = self._append("cameras", {"name": name, "type": "perspective", "perspective": perspective})
        return self.node(name, camera=camera, translation=eye, rotation=look_at(eye, target))

    def orthographic(self, name, eye, target, xmag, ymag, up=(0, 1, 0)):
        camera = self._append("cameras", {"name": name, "type": "orthographic", "orthographic": rounded(
            {"xmag": float(xmag), "ymag": float(ymag), "znear": 0.0, "zfar": 100.0})})
        return self.node(name, camera=camera, translation=eye, rotation=look_at(eye, target, up))

    def light(self, name, kind, color, intensity, position=(0, 0, 0), target=None, **members):
        """Node of a punctual light; `spot` and `range` as KHR_lights_punctual has them."""
        self.use("KHR_lights_punctual")
        lights = self.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append(rounded({"name": name, "type": kind, "color": color, "intensity": float(intensity), **members}))
        turn = look_at(position, target) if target else None
        return self.node(name, translation=position, rotation=turn,
                         extensions={"KHR_lights_punctual": {"light": len(lights) - 1}})

    def scene(self, name, *nodes):
        return self._append("scenes", {"name": name, "nodes": list(nodes)})

    # ---- output ----

    def output(self):
        """File name -> bytes."""
        if self.binary:
            self.json["buffers"] = [{"uri": "scene.bin", "byteLength": len(self.binary)}]
        if self.extensions:
            self.json["extensionsUsed"] = sorted(self.extensions)
        files = dict(self.files)
        files["scene.gltf"] = (dump(self.json) + "\n").encode()
        files["scene.bin"] = bytes(self.binary)
        return files


def dump(value, indent=0, width=110):
    """JSON with what fits a line on a line."""
    line = json.dumps(value, ensure_ascii=False)
    if len(line) + indent <= width or not isinstance(value, (dict, list, tuple)):
        return line
    pad = " " * (indent + 1)
    if isinstance(value, dict):
        items = [f"{pad}{json.dumps(k)}: {dump(v, indent + 1, width)}" for k, v in value.items()]
        return "{\n" + ",\n".join(items) + "\n" + " " * indent + "}"
    items = [pad + dump(v, indent + 1, width) for v in value]
    return "[\n" + ",\n".join(items) + "\n" + " " * indent + "]"
