// Any bytes as a STEP file: read, or refused in one line. What Open CASCADE does inside is its own; what comes out is checked.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "geometry/error.h"
#include "hsr/step/step.h"

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

/// A square of side 10 as a shell of one face.
const std::string_view example = R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('');
#2=PRODUCT_CONTEXT('',#1,'mechanical');
#3=PRODUCT('part','part','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#6=PRODUCT_DEFINITION('design','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#20,#30),#10);
#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13)) REPRESENTATION_CONTEXT('',''));
#11=(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.));
#12=(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.));
#13=(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT());
#20=SHELL_BASED_SURFACE_MODEL('',(#21));
#21=OPEN_SHELL('',(#22));
#22=ADVANCED_FACE('',(#23),#31,.T.);
#23=FACE_BOUND('',#24,.T.);
#24=EDGE_LOOP('',(#41,#42,#43,#44));
#30=AXIS2_PLACEMENT_3D('',#50,#60,#61);
#31=PLANE('',#30);
#41=ORIENTED_EDGE('',*,*,#45,.T.);
#42=ORIENTED_EDGE('',*,*,#46,.T.);
#43=ORIENTED_EDGE('',*,*,#47,.T.);
#44=ORIENTED_EDGE('',*,*,#48,.T.);
#45=EDGE_CURVE('',#71,#72,#81,.T.);
#46=EDGE_CURVE('',#72,#73,#82,.T.);
#47=EDGE_CURVE('',#73,#74,#83,.T.);
#48=EDGE_CURVE('',#74,#71,#84,.T.);
#50=CARTESIAN_POINT('',(0.,0.,0.));
#51=CARTESIAN_POINT('',(10.,0.,0.));
#52=CARTESIAN_POINT('',(10.,10.,0.));
#53=CARTESIAN_POINT('',(0.,10.,0.));
#60=DIRECTION('',(0.,0.,1.));
#61=DIRECTION('',(1.,0.,0.));
#62=DIRECTION('',(0.,1.,0.));
#63=DIRECTION('',(-1.,0.,0.));
#64=DIRECTION('',(0.,-1.,0.));
#71=VERTEX_POINT('',#50);
#72=VERTEX_POINT('',#51);
#73=VERTEX_POINT('',#52);
#74=VERTEX_POINT('',#53);
#81=LINE('',#50,#91);
#82=LINE('',#51,#92);
#83=LINE('',#52,#93);
#84=LINE('',#53,#94);
#91=VECTOR('',#61,1.);
#92=VECTOR('',#62,1.);
#93=VECTOR('',#63,1.);
#94=VECTOR('',#64,1.);
ENDSEC;
END-ISO-10303-21;
)";

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const hsr::Model m = hsr::read_brep("fuzz.step", {reinterpret_cast<const char*>(data), size}).tessellated(0.1);
    for (const hsr::Point3& p : m.points) demand(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (const std::uint32_t i : m.polygons.corners) demand(i < m.points.size());
  } catch (const hsr::InputError& e) {
    demand(std::strchr(e.what(), '\n') == nullptr);
  }
  return 0;
}

/// Begins with the example, now and then anew.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (size < 2 || seed % 512 == 0) {
    if (example.size() <= most) {
      std::copy(example.begin(), example.end(), data);
      return example.size();
    }
  }
  return LLVMFuzzerMutate(data, size, most);
}
