#include "study/comparison_csv.h"

#include <locale>
#include <sstream>

namespace hsr::internal {

std::string comparison_csv(const Comparison& c) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  text << "method,numbers,space,size,runs,seconds_median,seconds_least,seconds_most,peak_bytes,samples,covered,wrong,edge,tie,"
          "order,wrong_share,wrong_area_share,edge_error_pixels\n";
  for (const ComparedMethod& m : c.methods)
    text << '"' << m.method << "\",\"" << m.numbers << "\"," << (m.is_object_space ? "object" : "image") << ',' << m.size << ','
         << m.seconds.size() << ',' << m.median() << ',' << m.seconds.front() << ',' << m.seconds.back() << ',' << m.peak_bytes
         << ',' << m.samples << ',' << m.covered << ',' << m.wrong << ',' << m.edge << ',' << m.tie << ',' << m.order << ','
         << m.wrong_share() << ',' << m.wrong_area_share << ',' << m.edge_error << '\n';
  return text.str();
}

}  // namespace hsr::internal
