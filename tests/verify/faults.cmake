# vkpt_faulty: the program with every fault of faults.json that lies in src/reference compiled in, each behind a switch.
# Built for tests only, where VKPT_FAULTS is on; no other target knows of it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(faults "${CMAKE_SOURCE_DIR}/tests/verify/faults.json")
set(plant "${CMAKE_SOURCE_DIR}/tests/verify/plant_faults.py")
set(folder "${CMAKE_BINARY_DIR}/faulty")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${faults}" "${plant}")
execute_process(COMMAND "${Python3_EXECUTABLE}" "${plant}" --list OUTPUT_VARIABLE edited COMMAND_ERROR_IS_FATAL ANY)

set(originals "")
set(copies "${folder}/planted_fault.h")
foreach(file IN LISTS edited)
  list(APPEND originals "${CMAKE_SOURCE_DIR}/${file}")
  string(REGEX REPLACE "^src/" "${folder}/" copy "${file}")
  list(APPEND copies "${copy}")
endforeach()
add_custom_command(OUTPUT ${copies} COMMAND "${Python3_EXECUTABLE}" "${plant}" "${folder}"
                   DEPENDS "${faults}" "${plant}" ${originals} COMMENT "Planting faults")

file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/reference/*.cpp"
     "${CMAKE_SOURCE_DIR}/src/verify/*.cpp" "${CMAKE_SOURCE_DIR}/src/cli/*.cpp")
list(REMOVE_ITEM sources ${originals})
add_executable(vkpt_faulty "${CMAKE_SOURCE_DIR}/src/main.cpp" ${sources} ${copies})
set_target_properties(vkpt_faulty PROPERTIES UNITY_BUILD OFF)  # as vkpt_verify
target_include_directories(vkpt_faulty BEFORE PRIVATE "${folder}")
target_compile_options(vkpt_faulty PRIVATE $<$<CONFIG:Release>:-O1>)
target_link_libraries(vkpt_faulty PRIVATE vkpt_gltf vkpt_bvh vkpt_wavefront vkpt_compare vkpt_probes vkpt_analysis
                      CLI11::CLI11)  # of vkpt_reference, which analysis brings, nothing is missing that would be linked
