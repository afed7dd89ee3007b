# Sources that the build makes for the report: its templates as strings, and the commit it starts from.
set(report_include ${CMAKE_CURRENT_BINARY_DIR}/made)
set(report_made ${report_include}/report_template.cpp ${report_include}/analysis/build_commit.h)
foreach(template IN ITEMS report figure parameters)
  set(file ${CMAKE_CURRENT_SOURCE_DIR}/${template}.html.in)
  file(READ ${file} text)
  string(TOUPPER ${template} name)
  set(POWDERLINK_TEMPLATE_${name} "${text}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
configure_file(report_template.cpp.in ${report_include}/report_template.cpp @ONLY)

# Made again when HEAD moves: the log of HEAD grows with every commit and checkout.
set(commit_depends)
find_package(Git QUIET)
if(Git_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --path-format=absolute --git-path logs/HEAD
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE head_log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(EXISTS "${head_log}")
    set(commit_depends ${head_log})
  endif()
endif()
add_custom_command(OUTPUT ${report_include}/analysis/build_commit.h
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR}
    -DHEADER=${report_include}/analysis/build_commit.h
    -P ${PROJECT_SOURCE_DIR}/cmake/BuildCommit.cmake
  DEPENDS ${commit_depends} ${PROJECT_SOURCE_DIR}/cmake/BuildCommit.cmake
  COMMENT "Noting the commit of this build" VERBATIM)
add_custom_target(build_commit DEPENDS ${report_include}/analysis/build_commit.h)
