# The parts of hsr that are installed and linked one by one: a static library, its headers and its targets file each.

set(HSR_PUBLIC_HEADERS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${HSR_PUBLIC_HEADERS})

# The public headers of a component, relative to the root.
function(hsr_headers_of component result)
  file(STRINGS ${HSR_PUBLIC_HEADERS} headers REGEX "^${component} ")
  list(TRANSFORM headers REPLACE "^${component} " "")
  set(${result} ${headers} PARENT_SCOPE)
endfunction()

# Library `target`, linked as hsr::<component>, and installed with its public headers under include/hsr. Its sources are added
# by the rooms that belong to it. The part of `cmake --install --component` that it belongs to is `install_with`.
# Position-independent, so that shared libraries, such as the Python module, can be made of it.
function(hsr_component target component install_with)
  add_library(${target} STATIC)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)  # calls stay direct, and as fast as they were
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:hsr_build>)
  hsr_install_component(${target} ${component} ${install_with} PUBLIC)
endfunction()

# The same of headers alone.
function(hsr_header_component target component install_with)
  add_library(${target} INTERFACE)
  hsr_install_component(${target} ${component} ${install_with} INTERFACE)
endfunction()

function(hsr_install_component target component install_with scope)
  add_library(hsr::${component} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${component})
  target_compile_features(${target} ${scope} cxx_std_20)
  hsr_headers_of(${component} headers)
  list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
  target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  install(TARGETS ${target} EXPORT hsr-${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${install_with}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hsr COMPONENT ${install_with})
  install(EXPORT hsr-${component} NAMESPACE hsr:: FILE hsr-${component}.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/hsr COMPONENT ${install_with})
endfunction()
