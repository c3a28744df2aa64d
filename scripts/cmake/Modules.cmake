# One static library a module, sources listed by hand; `uses` are the modules it may include (the arrows of the house).
add_library(soft_flags INTERFACE)
target_compile_options(soft_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                            -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual)
# Vectors as arguments of functions that are always inlined (core/lanes.hpp): how they would be passed does not matter.
target_compile_options(soft_flags INTERFACE -Wno-psabi)
# Helpers of one source are not what another of the same module means (CMAKE_UNITY_BUILD). In .ci/run clang compiles each source by
# itself, with both.
if(CMAKE_UNITY_BUILD)
  target_compile_options(soft_flags INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(SOFT_WERROR)
  target_compile_options(soft_flags INTERFACE -Werror)
endif()
if(SOFT_SANITIZE)
  target_compile_options(soft_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                                              -fno-sanitize-recover=undefined)
  target_link_options(soft_flags INTERFACE -fsanitize=address,undefined)
endif()
if(SOFT_FUZZ)   # tests/fuzz; every module counts its branches, the programs there bring the fuzzer itself
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "SOFT_FUZZ needs clang 16 or later (-DCMAKE_CXX_COMPILER=clang++-16)")
  endif()
  target_compile_options(soft_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-omit-frame-pointer
                                              -fno-sanitize-recover=undefined)
  target_link_options(soft_flags INTERFACE -fsanitize=address,undefined)
endif()

# What computes at length; the other modules, the programs and the tests read, write and ask. Of a release those have -O2 and the tests
# -O1, which takes a third less time to compile than -O3; with the sanitizers, as .ci/run builds (-O0), the computing ones have -O1.
set(soft_computing_modules core mesh surface material element linalg assembly solver dynamics meshing geometry fit)

# soft_module(name SOURCES a.cpp b.cpp USES core mesh LIBRARIES soft_petsc)
function(soft_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  list(TRANSFORM MODULE_USES PREPEND soft_)
  if(MODULE_SOURCES)
    add_library(soft_${name} STATIC ${MODULE_SOURCES})
    target_include_directories(soft_${name} PUBLIC ${CMAKE_SOURCE_DIR}/lib)
    target_link_libraries(soft_${name} PUBLIC ${MODULE_USES} PRIVATE soft_flags ${MODULE_LIBRARIES})
    if(NOT name IN_LIST soft_computing_modules)
      target_compile_options(soft_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
    elseif(SOFT_SANITIZE)
      target_compile_options(soft_${name} PRIVATE -O1)
    endif()
  else()
    add_library(soft_${name} INTERFACE)
    target_include_directories(soft_${name} INTERFACE ${CMAKE_SOURCE_DIR}/lib)
    target_link_libraries(soft_${name} INTERFACE ${MODULE_USES} ${MODULE_LIBRARIES})
  endif()
endfunction()
