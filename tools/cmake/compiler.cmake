# Language level, warnings and sanitizers for every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# Build type of the sanitizer presets: asserts stay on, line numbers in reports, bearable speed.
set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1")  # no cache entry: project() has made an empty one, which would win

add_library(vkpt_compiler INTERFACE)
target_compile_options(vkpt_compiler INTERFACE -Wall -Wextra -Wshadow -Wpedantic -Werror -ffp-contract=off)
target_include_directories(vkpt_compiler INTERFACE
  "${CMAKE_SOURCE_DIR}/src" "${CMAKE_SOURCE_DIR}/shaders/shared" "${VKPT_GENERATED}")
# Bounds checks of the standard containers wherever asserts are on.
target_compile_definitions(vkpt_compiler INTERFACE $<$<CONFIG:Debug,Sanitize>:_GLIBCXX_ASSERTIONS>)
if(VKPT_SANITIZE)
  target_compile_options(vkpt_compiler INTERFACE -fsanitize=${VKPT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(vkpt_compiler INTERFACE -fsanitize=${VKPT_SANITIZE})
endif()

# oneTBB is not instrumented: ThreadSanitizer gets a stand-in that it can see through.
if(VKPT_SANITIZE MATCHES "thread")
  foreach(header blocked_range blocked_range2d combinable global_control parallel_for parallel_invoke parallel_reduce
          task_arena)
    foreach(folder tbb oneapi/tbb)
      file(CONFIGURE OUTPUT "${VKPT_GENERATED}/tsan/${folder}/${header}.h" CONTENT "#include <tbb_standin.h>\n")
    endforeach()
  endforeach()
  target_include_directories(vkpt_compiler BEFORE INTERFACE "${VKPT_GENERATED}/tsan" "${CMAKE_SOURCE_DIR}/tools/tsan")
endif()

find_program(VKPT_CCACHE ccache)
if(VKPT_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VKPT_CCACHE}")
endif()

# vkpt_library(NAME LIBRARY…): static library vkpt_NAME of all sources under src/NAME.
function(vkpt_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/${name}/*.cpp")
  if(sources)
    add_library(vkpt_${name} STATIC ${sources})
    target_link_libraries(vkpt_${name} PUBLIC vkpt_compiler ${ARGN})
    add_dependencies(vkpt_${name} vkpt_registry)
  else()
    add_library(vkpt_${name} INTERFACE)
    target_link_libraries(vkpt_${name} INTERFACE vkpt_compiler ${ARGN})
  endif()
endfunction()
