# Turns the bsdf lines of shaders/shared/registry.def into generated/reference_bsdfs.inc, the reference's dispatch.
# The enum and the table of names: registry.cmake.
file(STRINGS "${CMAKE_SOURCE_DIR}/shaders/shared/registry.def" lines REGEX "^bsdf")
set(inc "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *\\| *" ";" fields "${line}")
  list(GET fields 3 stem)
  vkpt_capitalise("${stem}" Stem)
  string(APPEND inc "VKPT_BSDF(${Stem}, ${stem})\n")
endforeach()
file(CONFIGURE OUTPUT "${VKPT_GENERATED}/reference_bsdfs.inc" @ONLY CONTENT
"// Generated from shaders/shared/registry.def: VKPT_BSDF(EnumName, functionStem) a line.
@inc@")
