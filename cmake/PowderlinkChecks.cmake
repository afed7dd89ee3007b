# Checks of the repository itself, and our own code once more under the sanitizers. The latter is
# one test here so that a single ctest summary tells the whole truth.
if(NOT POWDERLINK_SANITIZE)
  powderlink_command_test(lint.clang_format
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/lint.sh --format LABELS lint)
  powderlink_command_test(lint.house_rules
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/house_rules.sh LABELS lint)
  powderlink_command_test(lint.layers
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/layers.sh LABELS lint)
  powderlink_command_test(sanitized_tests
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/sanitized_tests.sh LABELS sanitize
    TIMEOUT 3600 RUN_SERIAL)
endif()
