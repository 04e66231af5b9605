"""Every scene by name."""
from . import cornell, spheres

SCENES = {
    "cornell_box": cornell.cornell_box,
    "mis_plates": cornell.mis_plates,
    "furnace": spheres.furnace,
    "material_grid": spheres.material_grid,
}
