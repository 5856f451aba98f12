# Writes OUTPUT, a header with the commit of SOURCE; the file is left alone where nothing has changed.
find_package(Git QUIET)
set(commit "unknown: not built in a Git checkout")
if(GIT_FOUND AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(commit ${found})
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define ICEBOW_COMMIT \"${commit}\"\n")
