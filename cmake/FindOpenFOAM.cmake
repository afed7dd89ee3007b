# Finds OpenFOAM (openfoam.com, v1912 or later) as libraries with headers:
#
#   OpenFOAM::OpenFOAM (with Pstream and MPI), ::fileFormats, ::surfMesh, ::meshTools, ::finiteVolume, ::dynamicMesh,
#   ::dynamicFvMesh, ::sampling, ::transportModels (incompressible), ::turbulenceModels,
#   ::incompressibleTurbulence, ::fvOptions
#   OpenFOAM_VERSION    api number, as 1912
#   OpenFOAM_DIR        the folder with src/*/lnInclude
#   OpenFOAM_PROJECT_DIR  the folder with etc/controlDict: WM_PROJECT_DIR at run time
#
# Headers come from the first of: OpenFOAM_ROOT (variable or environment); the user's own OpenFOAM,
# $WM_PROJECT_DIR, when built from source; the tree that scripts/openfoam_headers.sh makes in the
# build folder for the packaged libraries.
include(FindPackageHandleStandardArgs)

set(_foam_made_tree ${PROJECT_SOURCE_DIR}/build/openfoam)
unset(OpenFOAM_DIR)
foreach(_foam_dir IN ITEMS "${OpenFOAM_ROOT}" "$ENV{OpenFOAM_ROOT}" "$ENV{WM_PROJECT_DIR}"
                           "${_foam_made_tree}")
  # Debian's WM_PROJECT_DIR (/usr/share/openfoam) has no headers and must not win.
  if(_foam_dir AND NOT OpenFOAM_DIR
     AND EXISTS "${_foam_dir}/src/OpenFOAM/lnInclude/foamVersion.H")
    set(OpenFOAM_DIR "${_foam_dir}")
  endif()
endforeach()

# A tree and libraries of different installations would link and then crash, so an own OpenFOAM is
# searched in its own folders only.
if(OpenFOAM_DIR AND NOT OpenFOAM_DIR STREQUAL _foam_made_tree)
  set(_foam_search PATHS "$ENV{FOAM_LIBBIN}" "$ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI}"
    "${OpenFOAM_DIR}/lib" NO_DEFAULT_PATH)
else()
  set(_foam_search)
endif()

# api-info is the version's home since v1906.
unset(OpenFOAM_VERSION)
if(OpenFOAM_DIR AND EXISTS "${OpenFOAM_DIR}/META-INFO/api-info")
  file(STRINGS "${OpenFOAM_DIR}/META-INFO/api-info" _foam_api REGEX "^api=[0-9]+")
  string(REGEX REPLACE "^api=([0-9]+).*" "\\1" OpenFOAM_VERSION "${_foam_api}")
endif()

# imported target | library | folders under src | targets needed by its headers
set(_foam_components
  "Pstream|Pstream||"
  "OpenFOAM|OpenFOAM|OpenFOAM,OSspecific/POSIX|Pstream"
  "fileFormats|fileFormats|fileFormats|OpenFOAM"
  "surfMesh|surfMesh|surfMesh|fileFormats"
  "meshTools|meshTools|meshTools|surfMesh"
  "finiteVolume|finiteVolume|finiteVolume|meshTools"
  "dynamicMesh|dynamicMesh|dynamicMesh|finiteVolume"
  "dynamicFvMesh|dynamicFvMesh|dynamicFvMesh|dynamicMesh"
  "sampling|sampling|sampling|finiteVolume"
  "transportModels|incompressibleTransportModels|transportModels/incompressible|finiteVolume"
  "turbulenceModels|turbulenceModels|TurbulenceModels/turbulenceModels|finiteVolume"
  "incompressibleTurbulence|incompressibleTurbulenceModels|TurbulenceModels/incompressible|turbulenceModels,transportModels"
  "fvOptions|fvOptions|fvOptions|finiteVolume")

set(_foam_required OpenFOAM_DIR)
foreach(_foam_component IN LISTS _foam_components)
  string(REPLACE "|" ";" _foam_fields "${_foam_component}")
  list(GET _foam_fields 0 _foam_target)
  list(GET _foam_fields 1 _foam_library)
  find_library(OpenFOAM_${_foam_target}_LIBRARY NAMES ${_foam_library} ${_foam_search})
  mark_as_advanced(OpenFOAM_${_foam_target}_LIBRARY)
  list(APPEND _foam_required OpenFOAM_${_foam_target}_LIBRARY)
endforeach()
find_path(OpenFOAM_PROJECT_DIR NAMES etc/controlDict
  HINTS "$ENV{WM_PROJECT_DIR}" "${OpenFOAM_DIR}" PATH_SUFFIXES share/openfoam)
mark_as_advanced(OpenFOAM_PROJECT_DIR)
set(MPI_CXX_SKIP_MPICXX ON)
find_package(MPI COMPONENTS CXX QUIET)

find_package_handle_standard_args(OpenFOAM
  REQUIRED_VARS ${_foam_required} OpenFOAM_VERSION OpenFOAM_PROJECT_DIR MPI_CXX_FOUND
  VERSION_VAR OpenFOAM_VERSION
  REASON_FAILURE_MESSAGE "libraries, headers and META-INFO/api-info of openfoam.com's OpenFOAM, v1912 or later, are needed. Run scripts/setup.sh, or source your own OpenFOAM's etc/bashrc")

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::OpenFOAM)
  set(_foam_label_size 32)
  if(DEFINED ENV{WM_LABEL_SIZE})
    set(_foam_label_size $ENV{WM_LABEL_SIZE})
  endif()
  set(_foam_precision DP)
  if(DEFINED ENV{WM_PRECISION_OPTION})
    set(_foam_precision $ENV{WM_PRECISION_OPTION})
  endif()

  foreach(_foam_component IN LISTS _foam_components)
    string(REPLACE "|" ";" _foam_fields "${_foam_component}")
    list(GET _foam_fields 0 _foam_target)
    list(GET _foam_fields 2 _foam_folders)
    list(GET _foam_fields 3 _foam_needs)
    string(REPLACE "," ";" _foam_folders "${_foam_folders}")
    string(REPLACE "," ";" _foam_needs "${_foam_needs}")
    list(TRANSFORM _foam_folders PREPEND "${OpenFOAM_DIR}/src/" OUTPUT_VARIABLE _foam_includes)
    list(TRANSFORM _foam_includes APPEND "/lnInclude")
    # Some headers name others by their path below transportModels or TurbulenceModels.
    foreach(_foam_folder IN LISTS _foam_folders)
      if(_foam_folder MATCHES "^(transportModels|TurbulenceModels)/")
        list(APPEND _foam_includes "${OpenFOAM_DIR}/src/${CMAKE_MATCH_1}")
      endif()
    endforeach()
    list(TRANSFORM _foam_needs PREPEND "OpenFOAM::")

    # Their libraries carry no SONAME: linked by path, that path would be fixed in our programs.
    add_library(OpenFOAM::${_foam_target} SHARED IMPORTED)
    set_target_properties(OpenFOAM::${_foam_target} PROPERTIES
      IMPORTED_LOCATION "${OpenFOAM_${_foam_target}_LIBRARY}"
      IMPORTED_NO_SONAME TRUE
      INTERFACE_INCLUDE_DIRECTORIES "${_foam_includes}"
      INTERFACE_LINK_LIBRARIES "${_foam_needs}")
  endforeach()
  # OpenFOAM registers models in static objects: its libraries must stay linked although no symbol
  # of theirs is named.
  set_property(TARGET OpenFOAM::OpenFOAM APPEND PROPERTY
    INTERFACE_LINK_OPTIONS "LINKER:--no-as-needed")
  set_property(TARGET OpenFOAM::OpenFOAM APPEND PROPERTY
    INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
  # List_ACCESS promises by __restrict__ that the operands of a field operation do not overlap, which a
  # reused temporary breaks: T(tmp) is then no transpose where the compiler takes the promise up (GCC 12.2,
  # -O2 with AVX2; findings/openfoam_restrict_transpose.sh). Test: foam.turbulence_stock.
  set_property(TARGET OpenFOAM::OpenFOAM APPEND PROPERTY
    INTERFACE_COMPILE_DEFINITIONS OPENFOAM=${OpenFOAM_VERSION} WM_${_foam_precision}
    WM_LABEL_SIZE=${_foam_label_size} NoRepository OMPI_SKIP_MPICXX __restrict__=)
endif()
