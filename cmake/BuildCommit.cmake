# Writes the header with the commit that a build starts from: cmake -DSOURCE=dir -DHEADER=file -P this
find_program(git git)
set(commit "unknown: not built from a git repository")
if(git)
  # A copy of the sources inside another repository is not that repository.
  execute_process(COMMAND ${git} rev-parse --show-cdup HEAD WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed AND answer MATCHES "^\n([0-9a-f]+)\n$")
    set(commit "${CMAKE_MATCH_1}")
    execute_process(COMMAND ${git} status --porcelain --untracked-files=no
      WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT changes STREQUAL "")
      string(APPEND commit " with changes")
    endif()
  endif()
endif()
file(WRITE ${HEADER} "#define POWDERLINK_COMMIT \"${commit}\"\n")
