# Turns shaders/shared/registry.def into generated/registry.h (C++ enums and name tables),
# generated/reference_samplers.inc (the reference's table) and generated/samplers.glsl (includes and switch).
set(VKPT_REGISTRY "${CMAKE_SOURCE_DIR}/shaders/shared/registry.def")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${VKPT_REGISTRY}")

function(vkpt_capitalise word out)
  string(SUBSTRING "${word}" 0 1 head)
  string(SUBSTRING "${word}" 1 -1 tail)
  string(TOUPPER "${head}" head)
  set(${out} "${head}${tail}" PARENT_SCOPE)
endfunction()

file(STRINGS "${VKPT_REGISTRY}" lines REGEX "^[^#].*\\|")
set(enum "")
set(table "")
set(inc "")
set(includes "")
set(cases "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *\\| *" ";" fields "${line}")
  list(GET fields 0 kind)
  list(GET fields 1 id)
  list(GET fields 2 name)
  list(GET fields 3 stem)
  list(GET fields 4 help)
  string(STRIP "${kind}" kind)
  if(NOT kind STREQUAL "sampler")
    message(FATAL_ERROR "${VKPT_REGISTRY}: unknown kind '${kind}'")
  endif()
  vkpt_capitalise("${stem}" Stem)
  string(APPEND enum "    ${Stem} = ${id},\n")
  string(APPEND table "    {SamplerId::${Stem}, \"${name}\", \"${help}\"},\n")
  string(APPEND inc "VKPT_SAMPLER(${Stem}, ${stem})\n")
  string(APPEND includes "#include \"samplers/${stem}.glsl\"\n")
  string(APPEND cases "    case ${id}u: return ${stem}Bits(id, dim);\n")
endforeach()

file(CONFIGURE OUTPUT "${VKPT_GENERATED}/registry.h" @ONLY CONTENT
"// Generated from shaders/shared/registry.def.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace vkpt {

enum class SamplerId : std::uint32_t {
@enum@};

struct SamplerInfo {
    SamplerId id;
    std::string_view name, help;
};

inline constexpr auto kSamplers = std::to_array<SamplerInfo>({
@table@});

}  // namespace vkpt
")
file(CONFIGURE OUTPUT "${VKPT_GENERATED}/reference_samplers.inc" @ONLY CONTENT
"// Generated from shaders/shared/registry.def: VKPT_SAMPLER(EnumName, functionStem) a line.
@inc@")
file(CONFIGURE OUTPUT "${VKPT_GENERATED}/samplers.glsl" @ONLY CONTENT
"// Generated from shaders/shared/registry.def. kSampler is a specialization constant: the switch folds away.
@includes@
uint samplerBits(SampleId id, uint dim) {
    switch (kSampler) {
@cases@    }
    return 0u;
}
")
add_custom_target(vkpt_registry)
