# Installs what a component needs into a fresh prefix; there builds the project against it, and runs its program.
# cmake -DBUILD=... -DPROJECT=... -DWORK=... -DTYPE=... -DCOMPILER=... -DFLAGS=... -DCOMPONENT=... -DHEADERS=a,b,...
#   -DINSTALL=core,...      the parts to install
#   -DWITHOUT=ZLIB,...      packages that are not to be found
#   -DFAILS_WITH=...        the configuration is to fail with this message
#   -P run.cmake
cmake_minimum_required(VERSION 3.23)
file(REMOVE_RECURSE ${WORK})
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${text}")
  endif()
endfunction()

string(REPLACE "," ";" INSTALL "${INSTALL}")
foreach(part IN LISTS INSTALL)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --component ${part})
endforeach()
string(REPLACE "," ";" WITHOUT "${WITHOUT}")
list(TRANSFORM WITHOUT REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=TRUE")
set(configure ${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_BUILD_TYPE=${TYPE} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS} -DCOMPONENT=${COMPONENT}
  -DHEADERS=${HEADERS} ${WITHOUT})
if(FAILS_WITH)
  execute_process(COMMAND ${configure} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  string(REGEX REPLACE "[ \n]+" " " text "${text}")
  string(FIND "${text}" "${FAILS_WITH}" at)
  if(status EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "expected to fail with \"${FAILS_WITH}\"; status ${status}\n${text}")
  endif()
  return()
endif()
run(${configure})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
