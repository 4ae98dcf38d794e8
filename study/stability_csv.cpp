#include "study/stability_csv.h"

#include <locale>
#include <sstream>

namespace hsr::internal {

std::string stability_csv(const Stability& stability) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << "family,knob,value,triangles,covered,method,numbers,space,exact,outcome,wrong,edge,tie,order,wrong_share,predicted,"
          "seconds\n";
  for (const FamilyResult& f : stability.families)
    for (const StabilityRow& row : f.rows)
      for (std::size_t k = 0; k < row.points.size(); ++k) {
        const StabilityValue& v = f.values[k];
        const StabilityPoint& p = row.points[k];
        text << f.family.name << ",\"" << f.family.knob << "\"," << v.value << ',' << v.triangles << ',' << v.covered << ",\""
             << row.method << "\",\"" << row.numbers << "\"," << (row.is_object_space ? "object" : "image") << ','
             << (row.is_exact ? "yes" : "no") << ',' << name(p.outcome) << ',' << p.wrong << ',' << p.edge << ',' << p.tie
             << ',' << p.order << ',' << p.wrong_share << ',';
        if (row.predicted) text << *row.predicted;
        text << ',' << p.seconds << '\n';
      }
  return text.str();
}

}  // namespace hsr::internal
