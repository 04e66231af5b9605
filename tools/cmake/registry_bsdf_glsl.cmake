# The shaders' side of the registry's BSDF models: generated/bsdf_models.glsl (ids) and, for each shade group but glTF's,
# generated/bsdf_GROUP.glsl: includes of its models and the switches over them. A model that the scene does not have is
# cut out by the specialization constant kBsdfModels.
set(bsdf_ids "")
set(bsdf_groups microfacet classic)
foreach(group IN LISTS bsdf_groups)
  set(bsdf_${group}_includes "")
  set(bsdf_${group}_evaluate "")
  set(bsdf_${group}_sample "")
endforeach()
file(STRINGS "${VKPT_REGISTRY}" lines REGEX "^bsdf *\\|")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *\\| *" ";" fields "${line}")
  list(GET fields 1 id)
  list(GET fields 2 name)
  list(GET fields 3 stem)
  list(GET fields 4 group)
  vkpt_capitalise("${stem}" Stem)
  string(APPEND bsdf_ids "const uint k${Stem}Model = ${id}u;\n")
  if(group STREQUAL "gltf")
    continue()
  elseif(NOT group IN_LIST bsdf_groups)
    message(FATAL_ERROR "${VKPT_REGISTRY}: unknown shade group '${group}'")
  endif()
  set(guard "    if ((kBsdfModels & (1u << k${Stem}Model)) != 0u && b.model == k${Stem}Model)")
  string(APPEND bsdf_${group}_includes "#include \"bsdf/${name}.glsl\"\n")
  string(APPEND bsdf_${group}_evaluate "${guard} v = ${stem}Evaluate(b, wo, wi);\n")
  string(APPEND bsdf_${group}_sample "${guard} s = ${stem}Sample(b, wo, uLobe, u);\n")
endforeach()

file(CONFIGURE OUTPUT "${VKPT_GENERATED}/bsdf_models.glsl" @ONLY CONTENT
"// Generated from shaders/shared/registry.def.
@bsdf_ids@")
foreach(group IN LISTS bsdf_groups)
  set(includes "${bsdf_${group}_includes}")
  set(evaluate "${bsdf_${group}_evaluate}")
  set(sample "${bsdf_${group}_sample}")
  file(CONFIGURE OUTPUT "${VKPT_GENERATED}/bsdf_${group}.glsl" @ONLY CONTENT
"// Generated from shaders/shared/registry.def: the BSDF models of shade group ${group}.
#include \"bsdf_models.glsl\"
#include \"bsdf/bsdf.glsl\"
#include \"bsdf/surface_bsdf.glsl\"
@includes@
BsdfValue evaluateModel(SurfaceBsdf b, vec3 wo, vec3 wi) {
    BsdfValue v = kNoValue;
@evaluate@    return v;
}

LobeSample sampleModel(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    LobeSample s = LobeSample(vec3(0.0), false, vec3(0.0));
@sample@    return s;
}
#include \"bsdf/dispatch.glsl\"
")
endforeach()
