# Open CASCADE, by hand: its packages' own configuration fails unless all of it is installed.
# HSR_OCCT_INCLUDE and HSR_OCCT_LIBRARIES, and HSR_OCCT_FOUND if all that reading STEP takes is there.
find_path(HSR_OCCT_INCLUDE STEPCAFControl_Reader.hxx PATH_SUFFIXES opencascade occt)
mark_as_advanced(HSR_OCCT_INCLUDE)
set(HSR_OCCT_FOUND ON)
set(HSR_OCCT_LIBRARIES)
# Appends these libraries of it to HSR_OCCT_LIBRARIES, and says in `found` where one is missing.
macro(hsr_add_occt_libraries found)
  foreach(name IN ITEMS ${ARGN})
    find_library(HSR_OCCT_${name} ${name})
    mark_as_advanced(HSR_OCCT_${name})
    if(HSR_OCCT_${name})
      list(APPEND HSR_OCCT_LIBRARIES ${HSR_OCCT_${name}})
    else()
      set(${found} OFF)
    endif()
  endforeach()
endmacro()
hsr_add_occt_libraries(HSR_OCCT_FOUND TKXDESTEP TKXDEIGES TKSTEP TKIGES TKXSBase TKXCAF TKLCAF TKCAF TKCDF TKMesh TKShHealing TKTopAlgo TKBRep
  TKGeomAlgo TKGeomBase TKG3d TKG2d TKMath TKernel)
if(NOT HSR_OCCT_INCLUDE)
  set(HSR_OCCT_FOUND OFF)
endif()
