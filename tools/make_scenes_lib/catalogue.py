"""Every scene by name."""
from . import alpha, cornell, gallery, geometry, lights, relief, spheres, textures

SCENES = {
    "cornell_box": cornell.cornell_box,
    "mis_plates": cornell.mis_plates,
    "furnace": spheres.furnace,
    "material_grid": spheres.material_grid,
    "bsdf_gallery": gallery.bsdf_gallery,
    "texture_transform": textures.texture_transform,
    "texture_wrap": textures.texture_wrap,
    "alpha_modes": alpha.alpha_modes,
    "double_sided": alpha.double_sided,
    "punctual_lights": lights.punctual_lights,
    "emissive_texture": lights.emissive_texture,
    "instances": geometry.instances,
    "orthographic": geometry.orthographic,
    "vertex_attributes": geometry.vertex_attributes,
    "normal_map": relief.normal_map,
    "negative_scale": relief.negative_scale,
}
