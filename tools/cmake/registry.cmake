# Turns shaders/shared/registry.def into generated/registry.h (C++ enums and name tables of samplers, BSDF models and
# integrators), generated/reference_samplers.inc (the reference's table), generated/samplers.glsl (includes and switch)
# and generated/integrators.glsl (ids).
set(VKPT_REGISTRY "${CMAKE_SOURCE_DIR}/shaders/shared/registry.def")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${VKPT_REGISTRY}")

function(vkpt_capitalise word out)
  string(SUBSTRING "${word}" 0 1 head)
  string(SUBSTRING "${word}" 1 -1 tail)
  string(TOUPPER "${head}" head)
  set(${out} "${head}${tail}" PARENT_SCOPE)
endfunction()

# "owen xor none" to "ScrambleId::Owen, ScrambleId::Xor, ScrambleId::None", and their number; "-" to nothing.
function(vkpt_scramble_list names out count_out)
  set(list "")
  if(NOT names STREQUAL "-")
    string(REPLACE " " ";" names "${names}")
    foreach(name IN LISTS names)
      vkpt_capitalise("${name}" Name)
      list(APPEND list "ScrambleId::${Name}")
    endforeach()
  endif()
  list(LENGTH list count)
  string(JOIN ", " list ${list})
  set(${out} "${list}" PARENT_SCOPE)
  set(${count_out} "${count}" PARENT_SCOPE)
endfunction()

# One line "bsdf | id | name | stem | group | help": enum and table. Includes and switches: registry_bsdf.cmake.
set(bsdf_enum "")
set(bsdf_table "")
function(vkpt_add_bsdf kind id name stem group help)
  vkpt_capitalise("${stem}" Stem)
  vkpt_capitalise("${group}" Group)
  set(bsdf_enum "${bsdf_enum}    ${Stem} = ${id},\n" PARENT_SCOPE)
  set(bsdf_table "${bsdf_table}    {BsdfId::${Stem}, \"${name}\", BsdfGroup::${Group}, \"${help}\"},\n" PARENT_SCOPE)
endfunction()

# One line "integrator | id | name | stem | help".
set(integrator_enum "")
set(integrator_table "")
set(integrator_constants "")
function(vkpt_add_integrator kind id name stem help)
  vkpt_capitalise("${stem}" Stem)
  set(integrator_enum "${integrator_enum}    ${Stem} = ${id},\n" PARENT_SCOPE)
  set(integrator_table "${integrator_table}    {IntegratorId::${Stem}, \"${name}\", \"${help}\"},\n" PARENT_SCOPE)
  set(integrator_constants "${integrator_constants}const uint kIntegrator${Stem} = ${id}u;\n" PARENT_SCOPE)
endfunction()

file(STRINGS "${VKPT_REGISTRY}" lines REGEX "^[^#].*\\|")
set(enum "")
set(table "")
set(inc "")
set(includes "")
set(cases "")
set(pair_cases "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *\\| *" ";" fields "${line}")
  list(GET fields 0 kind)
  if(kind STREQUAL "bsdf")
    vkpt_add_bsdf(${fields})
    continue()
  elseif(kind STREQUAL "integrator")
    vkpt_add_integrator(${fields})
    continue()
  elseif(NOT kind STREQUAL "sampler")
    message(FATAL_ERROR "${VKPT_REGISTRY}: unknown kind '${kind}'")
  endif()
  list(GET fields 1 id)
  list(GET fields 2 name)
  list(GET fields 3 stem)
  list(GET fields 4 unit)
  list(GET fields 5 scrambles)
  list(GET fields 6 counts)
  list(GET fields 7 help)
  vkpt_capitalise("${stem}" Stem)
  vkpt_capitalise("${counts}" Counts)
  vkpt_scramble_list("${scrambles}" scramble_list scramble_count)
  string(APPEND enum "    ${Stem} = ${id},\n")
  string(APPEND table "    {SamplerId::${Stem}, \"${name}\", SampleCounts::${Counts}, \"${help}\", "
                      "{${scramble_list}}, ${scramble_count}},\n")
  if(scramble_count EQUAL 0)
    string(APPEND inc "VKPT_SAMPLER(${Stem}, ${stem})\n")
  else()
    string(APPEND inc "VKPT_SCRAMBLED_SAMPLER(${Stem}, ${stem})\n")
  endif()
  string(APPEND includes "#include \"samplers/${stem}.glsl\"\n")
  if(unit STREQUAL "pair")
    string(APPEND cases "    case ${id}u: pair = ${stem}Pair(id, dim >> 1u); return (dim & 1u) == 0u ? pair.x : pair.y;\n")
    string(APPEND pair_cases "    case ${id}u: return ${stem}Pair(id, pair);\n")
  else()
    string(APPEND cases "    case ${id}u: return ${stem}Bits(id, dim);\n")
    string(APPEND pair_cases
      "    case ${id}u: return uvec2(${stem}Bits(id, 2u * pair), ${stem}Bits(id, 2u * pair + 1u));\n")
  endif()
endforeach()

file(CONFIGURE OUTPUT "${VKPT_GENERATED}/registry.h" @ONLY CONTENT
"// Generated from shaders/shared/registry.def.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include \"constants.h\"

namespace vkpt {

enum class SamplerId : std::uint32_t {
@enum@};

enum class ScrambleId : std::uint32_t {
    None = kScrambleNone,
    Xor = kScrambleXor,
    Digit = kScrambleDigit,
    Faure = kScrambleFaure,
    Owen = kScrambleOwen,
};

/// Numbers of samples that a sampler's sets can have. Any: points do not depend on their number; else they do.
enum class SampleCounts : std::uint32_t { Any, Set, Grid, Prime2, Power2 };

struct SamplerInfo {
    SamplerId id;
    std::string_view name;
    SampleCounts counts;
    std::string_view help;
    std::array<ScrambleId, 5> scrambleList;
    std::uint32_t scrambleCount;

    /// The default first; empty where there is nothing to choose.
    [[nodiscard]] constexpr std::span<const ScrambleId> scrambles() const {
        return std::span(scrambleList).first(scrambleCount);
    }
};

/// BSDF models; MaterialRecord.flags holds the id.
enum class BsdfId : std::uint32_t {
@bsdf_enum@};

/// Models of one group share a shade kernel.
enum class BsdfGroup : std::uint32_t {
    Gltf = kGroupGltf,
    Microfacet = kGroupMicrofacet,
    Classic = kGroupClassic,
};

struct BsdfModelInfo {
    BsdfId id;
    std::string_view name;
    BsdfGroup group;
    std::string_view help;
};

/// RenderParams.integrator holds the id.
enum class IntegratorId : std::uint32_t {
@integrator_enum@};

struct IntegratorInfo {
    IntegratorId id;
    std::string_view name;
    std::string_view help;
};

/// In the order of their ids.
inline constexpr auto kIntegrators = std::to_array<IntegratorInfo>({
@integrator_table@});

/// In the order of their ids.
inline constexpr auto kBsdfModels = std::to_array<BsdfModelInfo>({
@bsdf_table@});

inline constexpr auto kSamplers = std::to_array<SamplerInfo>({
@table@});

}  // namespace vkpt
")
file(CONFIGURE OUTPUT "${VKPT_GENERATED}/reference_samplers.inc" @ONLY CONTENT
"// Generated from shaders/shared/registry.def: VKPT_SAMPLER(EnumName, functionStem) a line, or
// VKPT_SCRAMBLED_SAMPLER where it has scrambles.
@inc@")
file(CONFIGURE OUTPUT "${VKPT_GENERATED}/samplers.glsl" @ONLY CONTENT
"// Generated from shaders/shared/registry.def. kSampler is a specialization constant: the switch folds away.
@includes@
uint samplerBits(SampleId id, uint dim) {
    uvec2 pair;
    switch (kSampler) {
@cases@    }
    return 0u;
}

// Dimensions 2 pair and 2 pair + 1.
uvec2 samplerPair(SampleId id, uint pair) {
    switch (kSampler) {
@pair_cases@    }
    return uvec2(0u);
}
")
file(CONFIGURE OUTPUT "${VKPT_GENERATED}/integrators.glsl" @ONLY CONTENT
"// Generated from shaders/shared/registry.def: values of kIntegrator and RenderParams.integrator.
@integrator_constants@")
add_custom_target(vkpt_registry)
