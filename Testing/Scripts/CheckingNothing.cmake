# cmake -DSOURCE=<checkout> -DWORK=<folder> -P CheckingNothing.cmake
file(REMOVE_RECURSE "${WORK}")
foreach (file IN ITEMS Utilities/Scripts/check Utilities/Scripts/format Testing/Layering/CheckLayering.py
    Testing/Layering/layers.txt)
  cmake_path(GET file PARENT_PATH folder)
  file(COPY "${SOURCE}/${file}" DESTINATION "${WORK}/${folder}")
endforeach ()
execute_process(COMMAND "${WORK}/Utilities/Scripts/check" --quick
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (result EQUAL 0 OR NOT output MATCHES "no files to check")
  message(FATAL_ERROR "check --quick without files: ${result}\n${output}")
endif ()
execute_process(COMMAND "${WORK}/Utilities/Scripts/format" --check
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (result EQUAL 0)
  message(FATAL_ERROR "format --check without files: ${result}\n${output}")
endif ()
file(REMOVE_RECURSE "${WORK}")
