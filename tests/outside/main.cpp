#include <iostream>

#include "api/plumbline.hpp"

int main() {
  plumbline::api::Options options;
  plumbline::api::set_option(options, "work-offset", "G54=0,0,-1008,0,0,0");
  std::cout << plumbline::api::version() << '\n';
}
