# What makes shapes and draws them, beside what reading STEP takes: for tests and benches. HSR_OCCT_SHAPES_FOUND if all of it is there.
include(${PROJECT_SOURCE_DIR}/cmake/occt.cmake)
set(HSR_OCCT_SHAPES_FOUND ${HSR_OCCT_FOUND})
hsr_add_occt_libraries(HSR_OCCT_SHAPES_FOUND TKFillet TKOffset TKBool TKBO TKPrim TKHLR)
