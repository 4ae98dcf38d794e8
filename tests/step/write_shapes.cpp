#include <cstdio>
#include <string>

#include "tests/step/shapes.h"

int main(int argc, char** argv) {
  using namespace hsr::shapes;
  if (argc != 2) {
    std::fputs("usage: step_shapes DIRECTORY\n", stderr);
    return 2;
  }
  const std::string directory = std::string(argv[1]) + "/";
  write_step(plate(), directory + "plate.step");
  write_step(bottle(), directory + "bottle.step");
  write_step(loft(), directory + "loft.step");
  write_step(pipe(), directory + "pipe.step");
  write_step(cylinder(), directory + "cylinder.step");
  write_step(gear(), directory + "gear.step");
  write_step(flange(), directory + "flange.step");
  write_step(spring(), directory + "spring.step");
  write_step(ridge(0.0002), directory + "ridge.step");
  write_step(plate(), directory + "plate_inch.step", "INCH");
  write_iges(plate(), directory + "plate.igs");
  write_assembly(directory + "assembly.step");
  write_pin_in_block(directory + "pin.step");
}
