# cmake -Dtemplate=Version.cxx.in -Doutput=Version.cxx -Dversion=0.1.0 -Dsource=… -P HaspVersionStamp.cmake
#
# Run at every build, so that the commit is that of the build and not of the last configure. The output
# is touched only when it changes.
set(commit "unknown")
find_program(git git)
if (git)
  execute_process(COMMAND "${git}" -C "${source}" describe --always --abbrev=12 --exclude=* --dirty=+
    OUTPUT_VARIABLE described ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
  if (status EQUAL 0)
    set(commit "${described}")
  endif ()
endif ()
configure_file("${template}" "${output}" @ONLY)
