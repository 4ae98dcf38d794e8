#include "hsr/check/error_csv.h"

#include <locale>
#include <sstream>

namespace hsr::internal {

std::string error_csv(std::span<const ErrorAgainstTime> rows) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  text << "method,numbers,threads,width,height,runs,seconds_median,seconds_least,seconds_most,samples,covered,wrong,depth,edge,"
          "unbounded,other,wrong_share,visible_area_pixels,wrong_area_pixels,wrong_area_share\n";
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  for (const ErrorAgainstTime& r : rows) {
    const ZBufferCheck& s = r.samples;
    const auto& t = r.seconds;
    text << r.method << ',' << r.numbers << ',' << r.threads << ',' << r.width << ',' << r.height << ',' << t.size() << ','
         << (t.empty() ? 0 : t[t.size() / 2]) << ',' << (t.empty() ? 0 : t.front()) << ',' << (t.empty() ? 0 : t.back()) << ','
         << s.samples << ',' << s.covered << ',' << s.wrong << ',' << s.depth << ',' << s.edge << ',' << s.unbounded << ','
         << s.other << ',' << share(static_cast<double>(s.wrong), static_cast<double>(s.covered)) << ',' << r.area.visible
         << ',' << r.area.wrong << ',' << share(r.area.wrong, r.area.visible) << '\n';
  }
  return text.str();
}

}  // namespace hsr::internal
