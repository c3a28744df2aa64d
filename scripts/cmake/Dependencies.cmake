# Finds every external library and defines one target for each. The minimum versions are those of Debian 12. The installed CMake package
# includes this file too (Install.cmake).
find_package(PkgConfig REQUIRED)
find_package(MPI REQUIRED COMPONENTS C)
find_package(yaml-cpp REQUIRED)
if(PROJECT_NAME STREQUAL soft-actuator)   # not needed by users of the library
  find_package(CLI11 REQUIRED)
  find_package(nlohmann_json 3.11 REQUIRED)
endif()
pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET nettle)

# PETSc: only includes and libraries are used, because its pkg-config flags contain the hardening flags of the distribution.
pkg_check_modules(PETSC_PC REQUIRED PETSc>=3.18)
add_library(soft_petsc INTERFACE IMPORTED)
target_include_directories(soft_petsc SYSTEM INTERFACE ${PETSC_PC_INCLUDE_DIRS})
target_link_libraries(soft_petsc INTERFACE ${PETSC_PC_LINK_LIBRARIES} MPI::MPI_C)
target_compile_definitions(soft_petsc INTERFACE OMPI_SKIP_MPICXX)

pkg_check_modules(SLEPC_PC REQUIRED SLEPc>=3.18)
add_library(soft_slepc INTERFACE IMPORTED)
target_include_directories(soft_slepc SYSTEM INTERFACE ${SLEPC_PC_INCLUDE_DIRS})
target_link_libraries(soft_slepc INTERFACE soft_petsc ${SLEPC_PC_LINK_LIBRARIES})

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(soft_cholmod INTERFACE IMPORTED)
target_include_directories(soft_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
target_link_libraries(soft_cholmod INTERFACE ${CHOLMOD_LIBRARY})

# The MUMPS library that PETSc uses.
find_path(MUMPS_INCLUDE_DIR dmumps_c.h HINTS ${PETSC_PC_INCLUDE_DIRS} PATH_SUFFIXES MUMPS openmpi-${CMAKE_SYSTEM_PROCESSOR} REQUIRED)
find_library(MUMPS_LIBRARY dmumps HINTS ${PETSC_PC_LIBRARY_DIRS} REQUIRED)
add_library(soft_mumps INTERFACE IMPORTED)
target_include_directories(soft_mumps SYSTEM INTERFACE ${MUMPS_INCLUDE_DIR})
target_link_libraries(soft_mumps INTERFACE ${MUMPS_LIBRARY})

find_library(LAPACK_LIBRARY NAMES lapack flexiblas openblas REQUIRED)   # installed with PETSc
add_library(soft_lapack INTERFACE IMPORTED)
target_link_libraries(soft_lapack INTERFACE ${LAPACK_LIBRARY})

# HDF5: the variant with which PETSc was built; two variants in one process do not share identifiers.
pkg_search_module(HDF5_PC REQUIRED hdf5-openmpi hdf5)
find_library(HDF5_HL_LIBRARY NAMES hdf5_openmpi_hl hdf5_hl HINTS ${HDF5_PC_LIBRARY_DIRS} REQUIRED)
add_library(soft_hdf5 INTERFACE IMPORTED)
target_include_directories(soft_hdf5 SYSTEM INTERFACE ${HDF5_PC_INCLUDE_DIRS})
target_link_libraries(soft_hdf5 INTERFACE ${HDF5_HL_LIBRARY} ${HDF5_PC_LINK_LIBRARIES} MPI::MPI_C)
target_compile_definitions(soft_hdf5 INTERFACE H5_USE_110_API OMPI_SKIP_MPICXX)

find_path(GMSH_INCLUDE_DIR gmsh.h REQUIRED)
find_library(GMSH_LIBRARY gmsh REQUIRED)
add_library(soft_gmsh INTERFACE IMPORTED)
target_include_directories(soft_gmsh SYSTEM INTERFACE ${GMSH_INCLUDE_DIR})
target_link_libraries(soft_gmsh INTERFACE ${GMSH_LIBRARY})

find_path(CSV_INCLUDE_DIR csv.h REQUIRED)
find_library(CSV_LIBRARY csv REQUIRED)
add_library(soft_csv INTERFACE IMPORTED)
target_include_directories(soft_csv SYSTEM INTERFACE ${CSV_INCLUDE_DIR})
target_link_libraries(soft_csv INTERFACE ${CSV_LIBRARY})

find_package(OpenMP REQUIRED COMPONENTS CXX)   # part of the compiler; for the threads of the element loops
find_package(CGAL CONFIG REQUIRED)
find_package(Ceres 2.1 REQUIRED)   # includes Eigen
find_package(pugixml REQUIRED)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
