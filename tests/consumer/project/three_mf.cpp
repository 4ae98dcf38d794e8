#include <hsr/three_mf.h>

#include <cstdio>
#include <stdexcept>

int main() {
  try {
    const hsr::Model model = hsr::read_three_mf("part.3mf", "PK\x03\x04");
    return 1;
  } catch (const std::runtime_error& e) {
    std::puts(e.what());
  }
  return hsr::is_three_mf("part.3mf") ? 0 : 1;
}
