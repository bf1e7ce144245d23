# cmake -DBUILD=<build tree> -DCONSUMER=<source> -DWORK=<folder> -DGENERATOR=…
#   -DFLAGS=<compiler flags> -P InstallAndConsume.cmake
# Installs the build below WORK, builds the consumer against it and runs it. The build tree is not on
# any path: what the install lacks, the consumer lacks.
file(REMOVE_RECURSE "${WORK}")
function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
endfunction ()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_CXX_FLAGS=${FLAGS}")
file(STRINGS "${WORK}/build/CMakeCache.txt" found REGEX "^Hasp_DIR:")
if (NOT found MATCHES "=${WORK}/prefix/")
  message(FATAL_ERROR "The consumer found another Hasp: ${found}")
endif ()
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${CMAKE_COMMAND}" -E env --unset=DISPLAY --unset=LD_LIBRARY_PATH "${WORK}/build/Consumer")
message("${output}")
file(REMOVE_RECURSE "${WORK}")
