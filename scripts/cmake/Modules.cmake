# One static library per module, with explicit source lists. USES lists the modules whose headers it may include
# (tests/layers/dependencies.txt).
add_library(soft_flags INTERFACE)
target_compile_options(soft_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                            -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual)
# math/lanes.hpp passes vectors to functions that are always inlined, so that the calling convention does not matter.
target_compile_options(soft_flags INTERFACE -Wno-psabi)
# In a unity build helpers of one source may shadow names of another source of the same module.
if(CMAKE_UNITY_BUILD)
  target_compile_options(soft_flags INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(SOFT_WERROR)
  target_compile_options(soft_flags INTERFACE -Werror)
endif()
if(SOFT_SANITIZE OR SOFT_FUZZ)   # GCC alone has a macro for this
  target_compile_definitions(soft_flags INTERFACE SOFT_SANITIZED)
endif()
if(SOFT_SANITIZE)
  target_compile_options(soft_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                                              -fno-sanitize-recover=undefined)
  target_link_options(soft_flags INTERFACE -fsanitize=address,undefined)
endif()
if(SOFT_FUZZ)   # tests/fuzz: instrument every module; the targets link libFuzzer
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "SOFT_FUZZ needs clang 16 or later (-DCMAKE_CXX_COMPILER=clang++-16)")
  endif()
  target_compile_options(soft_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-omit-frame-pointer
                                              -fno-sanitize-recover=undefined)
  target_link_options(soft_flags INTERFACE -fsanitize=address,undefined)
endif()

# Modules with numerical kernels. In a release build the other modules and the programs use -O2 and the tests -O1, which compile in two
# thirds of the time of -O3. With sanitizers (.ci/run, -O0) the modules of this list use -O1.
set(soft_computing_modules core math mesh surface contact material fem linalg solver meshing geometry fit)

# soft_module(name SOURCES a.cpp b.cpp USES core mesh LIBRARIES soft_petsc)
function(soft_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  list(TRANSFORM MODULE_USES PREPEND soft_)
  if(MODULE_SOURCES)
    add_library(soft_${name} STATIC ${MODULE_SOURCES})
    target_include_directories(soft_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/lib>)
    target_link_libraries(soft_${name} PUBLIC ${MODULE_USES} PRIVATE $<BUILD_INTERFACE:soft_flags> ${MODULE_LIBRARIES})
    target_compile_features(soft_${name} PUBLIC cxx_std_20)
    # PETSc's macros contain __FILE__; installed files name no folder of the source tree.
    target_compile_options(soft_${name} PRIVATE -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
    if(NOT name IN_LIST soft_computing_modules)
      target_compile_options(soft_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
    elseif(SOFT_SANITIZE)
      target_compile_options(soft_${name} PRIVATE -O1)
    endif()
  else()
    add_library(soft_${name} INTERFACE)
    target_include_directories(soft_${name} INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/lib>)
    target_link_libraries(soft_${name} INTERFACE ${MODULE_USES} ${MODULE_LIBRARIES})
  endif()
endfunction()
