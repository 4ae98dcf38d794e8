#include <hsr/step.h>

#include <cstdio>
#include <stdexcept>

int main() {
  try {
    const hsr::BrepModel brep = hsr::read_brep("part.step", "ISO-10303-21;");
    return 1;
  } catch (const std::runtime_error& e) {
    std::puts(e.what());
  }
  return hsr::is_brep("part.stp") ? 0 : 1;
}
