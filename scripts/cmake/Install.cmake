# Installation in two components: runtime (programs, designs) and development (headers, libraries, CMake package, pkg-config file).
# No installed file contains an absolute path of this tree or of the prefix, so that the prefix may be moved. For the same reason the
# folders are fixed: the programs find ../lib/soft-actuator and ../share/soft-actuator.
include(CMakePackageConfigHelpers)
get_property(tools GLOBAL PROPERTY soft_tools)
add_custom_target(programs DEPENDS ${tools})   # what is installed, without the tests
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)

install(TARGETS ${tools} DESTINATION bin)
install(TARGETS soft_gmsh_module DESTINATION lib/soft-actuator)
install(DIRECTORY designs meshes DESTINATION share/soft-actuator)
install(FILES LICENSE DESTINATION share/doc/soft-actuator RENAME copyright)
install(FILES CHANGELOG.md DESTINATION share/doc/soft-actuator)

# The programs print their man pages and completions. The scripts become the commands soft-NAME, with their help as man page.
install(CODE "set(bin \"${CMAKE_RUNTIME_OUTPUT_DIRECTORY}\")\nset(tools ${tools})\nset(scripts \"${CMAKE_SOURCE_DIR}/scripts\")")
install(CODE [[
  set(prefix "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
  function(print file)   # print(FILE COMMAND...)
    cmake_path(GET file PARENT_PATH folder)
    file(MAKE_DIRECTORY "${prefix}/share/${folder}")
    execute_process(COMMAND ${ARGN} OUTPUT_FILE "${prefix}/share/${file}" COMMAND_ERROR_IS_FATAL ANY)
  endfunction()
  set(zsh site-functions)
  if(CMAKE_INSTALL_PREFIX MATCHES "/usr$")   # a package: Debian's zsh does not read /usr/share/zsh/site-functions
    set(zsh vendor-completions)
  endif()
  foreach(tool IN LISTS tools)
    print(man/man1/${tool}.1 "${bin}/${tool}" --man)
    print(bash-completion/completions/${tool} "${bin}/${tool}" --completion bash)
    print(zsh/${zsh}/_${tool} "${bin}/${tool}" --completion zsh)
    print(fish/vendor_completions.d/${tool}.fish "${bin}/${tool}" --completion fish)
  endforeach()
  set(executable FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  foreach(script sweep sweep-design sweep.smk workspace shared.py)
    file(READ "${scripts}/${script}" text)
    string(REGEX REPLACE "scripts/(sweep|workspace|{NAME})([^-.a-z])" "soft-\\1\\2" text "${text}")
    file(WRITE "${prefix}/libexec/soft-actuator/${script}" "${text}")
    if(NOT script MATCHES "[.]")   # the others are read by a program
      file(CHMOD "${prefix}/libexec/soft-actuator/${script}" ${executable})
    endif()
  endforeach()
  foreach(script sweep workspace)
    file(WRITE "${prefix}/bin/soft-${script}" "#!/bin/sh\nbin=$(dirname \"$(realpath \"$0\")\")\n"
         "PATH=$bin:$PATH exec \"$bin/../libexec/soft-actuator/${script}\" \"$@\"\n")
    file(CHMOD "${prefix}/bin/soft-${script}" ${executable})
    execute_process(COMMAND "${prefix}/bin/soft-${script}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE "\\" "\\e" help "${help}")   # roff escapes
    string(REPLACE "-" "\\-" help "${help}")
    string(REGEX REPLACE "\n([.'])" "\n\\\\&\\1" help "${help}")
    string(REGEX MATCH "^[^\n]*" summary "${help}")
    string(TOUPPER "${script}" title)
    file(WRITE "${prefix}/share/man/man1/soft-${script}.1" ".TH SOFT\\-${title} 1 \"\" \"soft\\-actuator\" \"User Commands\"\n"
         ".SH NAME\nsoft\\-${script} \\- ${summary}\n.SH DESCRIPTION\n.nf\n${help}.fi\n")
  endforeach()
]])

# The libraries, as targets soft::MODULE.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(libraries "")
foreach(module ${soft_modules})
  set_target_properties(soft_${module} PROPERTIES EXPORT_NAME ${module})
  install(TARGETS soft_${module} EXPORT soft-actuator DESTINATION lib INCLUDES DESTINATION include/soft-actuator)
  get_target_property(type soft_${module} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    string(PREPEND libraries "-lsoft_${module} ")   # dependents first
  endif()
endforeach()
install(DIRECTORY lib/ DESTINATION include/soft-actuator FILES_MATCHING PATTERN *.hpp)
set(package lib/cmake/soft-actuator)
install(EXPORT soft-actuator DESTINATION ${package} FILE soft-actuatorTargets.cmake NAMESPACE soft::)
install(FILES scripts/cmake/Dependencies.cmake DESTINATION ${package})
file(CONFIGURE OUTPUT soft-actuatorConfig.cmake @ONLY CONTENT [[
# find_package(soft-actuator) defines soft::solver, soft::io and the other modules, as static libraries.
if(NOT TARGET soft::core)
  include(${CMAKE_CURRENT_LIST_DIR}/Dependencies.cmake)
  include(${CMAKE_CURRENT_LIST_DIR}/soft-actuatorTargets.cmake)
  cmake_path(SET soft_gmsh_folder NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../soft-actuator)
  target_link_options(soft::meshing INTERFACE LINKER:-rpath,${soft_gmsh_folder})   # the folder of soft_gmsh.so
endif()
]])
write_basic_package_version_file(soft-actuatorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
# Ceres, which soft_fit needs, has no pkg-config file.
set(mpi_flags ${MPI_C_INCLUDE_DIRS})
list(TRANSFORM mpi_flags PREPEND -I)
list(JOIN mpi_flags " " mpi_flags)
list(JOIN MPI_C_LIBRARIES " " mpi_libraries)
file(CONFIGURE OUTPUT soft-actuator.pc @ONLY CONTENT [[
prefix=${pcfiledir}/../..
libdir=${prefix}/lib
Name: @PROJECT_NAME@
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Requires: SLEPc >= 3.18 PETSc >= 3.18 @HDF5_PC_MODULE_NAME@ nettle yaml-cpp pugixml
Cflags: -std=c++20 -I${prefix}/include/soft-actuator -DOMPI_SKIP_MPICXX @mpi_flags@
Libs: -L${libdir} @libraries@-Wl,-rpath,${libdir}/soft-actuator @HDF5_HL_LIBRARY@ @CHOLMOD_LIBRARY@ @MUMPS_LIBRARY@ @LAPACK_LIBRARY@ @CSV_LIBRARY@ @MPFR_LIBRARIES@ @GMP_LIBRARIES@ @mpi_libraries@ -fopenmp -ldl
]])
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/soft-actuator.pc DESTINATION lib/pkgconfig)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/soft-actuatorConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/soft-actuatorConfigVersion.cmake
        DESTINATION ${package})

# Packages: cpack writes them to build/packages. The development package needs the libraries with which this one was built.
file(STRINGS scripts/packages.txt needed REGEX "^build")
list(FILTER needed INCLUDE REGEX "\\| lib[a-z0-9+-]+-dev |nettle-dev")
list(TRANSFORM needed REPLACE "^[^|]*\\|[^|]*\\|[^|]*\\| *([^ |]+).*" "\\1")
list(FILTER needed EXCLUDE REGEX gtest|benchmark|cli11)
list(JOIN needed ", " needed)
set(CPACK_GENERATOR TGZ DEB)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CONTACT "soft-actuator maintainers <maintainers@users.noreply.h-seed-ce0e6bc6.example>")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME soft-actuator)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS python3)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "gnuplot-nox, ffmpeg, parallel, openmpi-bin, libopenblas0-serial")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "slurm-client, snakemake")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsoft-actuator-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "soft-actuator (= ${PROJECT_VERSION}), pkg-config, ${needed}")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Programs mesh-gen, solve and postprocess, tools for sweeps and material fits, and example designs.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and static libraries for C++ programs that generate meshes and follow equilibrium paths.")
include(CPack)
