# Finds LIGGGHTS as a library: headers, libliggghts and the stock program.
#
#   LIGGGHTS::liggghts     headers (system), libliggghts and MPI without its C++ bindings
#   LIGGGHTS_EXECUTABLE    the stock program
#   LIGGGHTS_VERSION       when the library's file name tells it
# LIGGGHTS_ROOT (variable or environment) points to another installation.
include(FindPackageHandleStandardArgs)

find_path(LIGGGHTS_INCLUDE_DIR NAMES pair_gran_base.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY NAMES liggghts)
find_program(LIGGGHTS_EXECUTABLE NAMES liggghts)

# The headers carry only the LAMMPS version; the library's file name has LIGGGHTS's own.
if(LIGGGHTS_LIBRARY)
  file(REAL_PATH "${LIGGGHTS_LIBRARY}" _liggghts_file)
  if(_liggghts_file MATCHES "\\.so\\.([0-9.]+)$")
    set(LIGGGHTS_VERSION ${CMAKE_MATCH_1})
  endif()
endif()

# The hosts speak C MPI; the deprecated C++ bindings clash with their headers.
set(MPI_CXX_SKIP_MPICXX ON)
find_package(MPI COMPONENTS CXX QUIET)

find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR LIGGGHTS_EXECUTABLE MPI_CXX_FOUND
  VERSION_VAR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "the program, its library, its headers and MPI are all needed. Run scripts/setup.sh (packages liggghts, libliggghts-dev, libopenmpi-dev), or set LIGGGHTS_ROOT to an installation with bin/, lib/ and include/liggghts/")

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::liggghts)
  add_library(LIGGGHTS::liggghts UNKNOWN IMPORTED)
  set_target_properties(LIGGGHTS::liggghts PROPERTIES
    IMPORTED_LOCATION "${LIGGGHTS_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS OMPI_SKIP_MPICXX
    INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY LIGGGHTS_EXECUTABLE)
